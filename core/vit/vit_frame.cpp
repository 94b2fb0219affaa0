#include "vit/vit_frame.h"

#include "geometry/camera_model.h"

#include <algorithm>
#include <iterator>

namespace glide {
namespace {

// BT.601 in 1/256, as OpenCV's cvtColor up to rounding.
constexpr int kRed = 77, kGreen = 150, kBlue = 29;
constexpr int kHalf = 128;

// Beyond these a sensor's size is a broken sample.
constexpr std::uint32_t kLargestSide = 16384;

// R R^T may be this far from the identity: calibration files carry as few as three digits.
constexpr double kRotationTolerance = 0.01;

std::uint32_t bytesPerPixel(vit_image_format format) {
  return format == VIT_IMAGE_FORMAT_R8G8B8 ? 3 : 1;
}

bool isReadable(const vit_img_sample& sample) {
  const bool is_known =
      sample.format == VIT_IMAGE_FORMAT_L8 || sample.format == VIT_IMAGE_FORMAT_R8G8B8;
  const bool has_size = sample.width > 0 && sample.height > 0 && sample.width <= kLargestSide &&
                        sample.height <= kLargestSide;
  if (!is_known || !has_size || sample.data == nullptr) return false;
  const std::uint64_t row = std::uint64_t{sample.width} * bytesPerPixel(sample.format);
  const std::uint64_t needed = std::uint64_t{sample.stride} * (sample.height - 1) + row;
  return sample.stride >= row && sample.size >= needed;
}

void convertRow(const vit_img_sample& sample, const std::uint8_t* from, std::uint8_t* to) {
  if (sample.format == VIT_IMAGE_FORMAT_L8) {
    std::copy_n(from, sample.width, to);
    return;
  }
  for (std::uint32_t x = 0; x < sample.width; ++x, from += 3) {
    const int sum = kRed * from[0] + kGreen * from[1] + kBlue * from[2] + kHalf;
    to[x] = static_cast<std::uint8_t>(sum / 256);
  }
}

/// How many of the coefficients count, or nothing for a model that we lack.
std::optional<std::uint32_t> coefficientCount(const vit_camera_calibration& calibration) {
  constexpr std::uint32_t kRt5 = 5, kRt8 = 8;
  switch (calibration.model) {
    case VIT_DISTORTION_NONE:
      return 0;
    case VIT_DISTORTION_RT4:
    case VIT_DISTORTION_KB4:
      return 4;
    case VIT_DISTORTION_RT5:
      return kRt5;
    case VIT_DISTORTION_RT8: {
      const std::uint32_t given = std::min(calibration.distortion_count, kRt8);
      const bool is_rt5 = std::all_of(calibration.distortion + std::min(given, kRt5),
                                      calibration.distortion + given,
                                      [](double k) { return k == 0.0; });
      return is_rt5 ? std::optional<std::uint32_t>(kRt5) : std::nullopt;
    }
  }
  return std::nullopt;
}

/// Also false for what is not finite.
bool isRotation(const Mat3d& R) {
  const double off = (R * R.transpose() - Mat3d::Identity()).cwiseAbs().maxCoeff();
  return R.allFinite() && off < kRotationTolerance && R.determinant() > 0.0;
}

/// The identity when nothing was filled in.
Result<SE3d> rigidOf(const double (&m)[16]) {
  if (std::all_of(std::begin(m), std::end(m), [](double x) { return x == 0.0; })) return SE3d{};
  Mat3d R;
  R << m[0], m[1], m[2], m[4], m[5], m[6], m[8], m[9], m[10];
  const Vec3d t(m[3], m[7], m[11]);
  if (!isRotation(R) || !t.allFinite())
    return Error{ErrorCode::invalid_argument, "transform is no rotation and translation"};
  return SE3d{Eigen::Quaterniond(R).normalized(), t};
}

}  // namespace

std::optional<ImageU8> toLuma(const vit_img_sample& sample) {
  if (!isReadable(sample)) return std::nullopt;
  ImageU8 luma(static_cast<int>(sample.width), static_cast<int>(sample.height));
  for (int y = 0; y < luma.height(); ++y) {
    const std::size_t offset = static_cast<std::size_t>(y) * sample.stride;
    convertRow(sample, sample.data + offset, luma.row(y));
  }
  return luma;
}

Result<VitCamera> toCamera(const vit_camera_calibration& calibration) {
  const std::optional<std::uint32_t> count = coefficientCount(calibration);
  if (!count) return Error{ErrorCode::unsupported, "the lens model is not supported"};
  if (calibration.distortion_count < *count)
    return Error{ErrorCode::invalid_argument, "too few distortion coefficients"};
  VitCamera camera;
  camera.intrinsics.width = calibration.width;
  camera.intrinsics.height = calibration.height;
  camera.intrinsics.fx = calibration.fx;
  camera.intrinsics.fy = calibration.fy;
  camera.intrinsics.cx = calibration.cx;
  camera.intrinsics.cy = calibration.cy;
  if (*count > 0) {
    camera.intrinsics.distortion = calibration.model == VIT_DISTORTION_KB4
                                       ? DistortionModel::kannala_brandt4
                                       : DistortionModel::radial_tangential;
  }
  camera.intrinsics.coefficients.assign(calibration.distortion, calibration.distortion + *count);
  const Result<CameraModel> model = CameraModel::create(camera.intrinsics);
  if (!model) return model.error();
  const Result<SE3d> T_imu_cam = rigidOf(calibration.transform);
  if (!T_imu_cam) return T_imu_cam.error();
  camera.T_imu_cam = *T_imu_cam;
  return camera;
}

}  // namespace glide
