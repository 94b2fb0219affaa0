#include "synthetic/sequence.h"

#include "synthetic/random.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace glide::synthetic {

namespace {

constexpr std::int64_t kFirstTimestamp =
    1'000'000'000'000;  // ns; not zero, as clocks of cameras are not
constexpr double kNsPerS = 1e9;

Status checkOptions(const SequenceOptions& options) {
  const Sensor& sensor = options.sensor;
  const auto invalid = [](const std::string& what) {
    return Error{ErrorCode::invalid_argument, what};
  };
  if (options.frames < 1) return invalid("frames: must be at least 1");
  if (!(options.fps > 0.0)) return invalid("fps: must be greater than 0");
  if (!(sensor.noise >= 0.0)) return invalid("noise: must not be negative");
  if (!(sensor.gain_begin > 0.0 && sensor.gain_end > 0.0))
    return invalid("gain: must be greater than 0");
  if (sensor.shutter_samples < 1) return invalid("shutter samples: must be at least 1");
  const double frame_s = 1.0 / options.fps;
  if (!(sensor.shutter_s >= 0.0 && sensor.shutter_s <= frame_s)) {
    return invalid("shutter: must be between 0 and the time of one frame");
  }
  if (!(sensor.readout_s >= 0.0 && sensor.readout_s <= frame_s)) {
    return invalid("rolling shutter: must be between 0 and the time of one frame");
  }
  return Unit{};
}

void average(const ImageF& image, int samples, ImageF* sum) {
  const float weight = 1.0F / static_cast<float>(samples);
  for (int y = 0; y < image.height(); ++y) {
    const float* in = image.row(y);
    float* out = sum->row(y);
    for (int x = 0; x < image.width(); ++x) out[x] += weight * in[x];
  }
}

void clear(int width, int height, ImageF* image) {
  image->resize(width, height);
  for (int y = 0; y < height; ++y) std::fill_n(image->row(y), width, 0.0F);
}

}  // namespace

CameraIntrinsics makeCamera(DistortionModel model, int width, int height) {
  CameraIntrinsics camera;
  camera.width = width;
  camera.height = height;
  camera.distortion = model;
  double focal = 0.82;  // focal length over width
  if (model == DistortionModel::radial_tangential) {
    focal = 0.61;
    camera.coefficients = {-0.28, 0.074, 0.0002, -0.0001};
  }
  if (model == DistortionModel::kannala_brandt4) {
    focal = 0.38;
    camera.coefficients = {0.0035, 0.0007, -0.0021, 0.0002};
  }
  camera.fx = focal * width;
  camera.fy = camera.fx;
  camera.cx = 0.5 * (width - 1) + 0.005 * width;
  camera.cy = 0.5 * (height - 1) - 0.005 * width;
  return camera;
}

Result<Sequence> Sequence::create(const SequenceOptions& options) {
  if (const Status status = checkOptions(options); !status) return status.error();
  return create(options, std::make_shared<const Scene>(makeScene(options.scene, options.seed)));
}

Result<Sequence> Sequence::create(const SequenceOptions& options,
                                  std::shared_ptr<const Scene> scene) {
  if (const Status status = checkOptions(options); !status) return status.error();
  const Result<CameraModel> camera = CameraModel::create(options.camera);
  if (!camera) return camera.error();
  return Sequence(options, *camera, std::move(scene));
}

Sequence::Sequence(const SequenceOptions& options,
                   const CameraModel& camera,
                   std::shared_ptr<const Scene> scene)
    : options_(options), camera_(camera), scene_(std::move(scene)), renderer_(camera) {}

std::int64_t Sequence::timestamp(int frame) const {
  return kFirstTimestamp + static_cast<std::int64_t>(std::llround(seconds(frame) * kNsPerS));
}

SE3d Sequence::T_world_cam(int frame) const {
  return poseAt(options_.motion, scene_->viewpoint, seconds(frame));
}

void Sequence::renderAt(double t_s) {
  const double readout = options_.sensor.readout_s;
  const int rows = readout > 0.0 ? camera_.height() : 1;
  row_poses_.clear();
  for (int row = 0; row < rows; ++row) {
    const double offset = rows == 1 ? 0.0 : readout * (static_cast<double>(row) / (rows - 1) - 0.5);
    row_poses_.push_back(poseAt(options_.motion, scene_->viewpoint, t_s + offset));
  }
  renderer_.render(*scene_, row_poses_, &rendering_);
}

void Sequence::image(int frame, ImageU8* out) {
  const Sensor& sensor = options_.sensor;
  const int samples = sensor.shutter_s > 0.0 ? sensor.shutter_samples : 1;
  clear(camera_.width(), camera_.height(), &exposed_);
  for (int k = 0; k < samples; ++k) {
    renderAt(seconds(frame) + sensor.shutter_s * ((k + 0.5) / samples - 0.5));
    average(rendering_.radiance, samples, &exposed_);
  }
  const double share =
      options_.frames > 1 ? static_cast<double>(frame) / (options_.frames - 1) : 0.0;
  const std::uint64_t seed = mixBits(options_.seed) + static_cast<std::uint64_t>(frame);
  develop(exposed_, exposureAt(sensor, share, seed), sensor.noise, seed, out);
}

const Rendering& Sequence::rendering(int frame) {
  renderAt(seconds(frame));
  return rendering_;
}

}  // namespace glide::synthetic
