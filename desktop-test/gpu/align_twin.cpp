#include "gpu/align_twin.h"

#include <algorithm>
#include <cmath>

namespace glide::test {
namespace {

bool isInside(const Vec2d& uv, const ImageF& image, double low, double high) {
  return uv.x() >= low && uv.y() >= low && uv.x() < image.width() - high &&
         uv.y() < image.height() - high;
}

template <class Visit>
void forPatch(int patch_size, const Visit& visit) {
  const int h = patch_size / 2;
  for (int dy = -h; dy <= h; ++dy) {
    for (int dx = -h; dx <= h; ++dx) visit(dx, dy);
  }
}

struct Residuals {
  double squares = 0.0;
  Vec6d J_r = Vec6d::Zero();  ///< sum of J^T r
};

/// From the sums, as the contract says.
Residuals residualsOf(const TwinPoint& p, const TwinSums& s, const TwinState& state) {
  const double n = static_cast<double>(p.pixels.size());
  const double a = state.gain;
  const double c = p.m0 - state.bias - a * p.m0;
  Residuals out;
  out.squares = (s.s2 + 2.0 * c * s.s1 + n * c * c) / (a * a) - 2.0 * s.sc / a + p.E;
  out.J_r = p.Jx * ((s.sx + c * p.Gx) / a - p.Ex) + p.Jy * ((s.sy + c * p.Gy) / a - p.Ey);
  return out;
}

Mat6d hessianOf(const TwinPoint& p) {
  Mat6d H = Mat6d::Zero();
  for (const Vec3d& pixel : p.pixels) {
    const Vec6d J = pixel.y() * p.Jx + pixel.z() * p.Jy;
    H += J * J.transpose();
  }
  return H;
}

void estimateExposure(const std::vector<TwinPoint>& points,
                      const std::vector<TwinSums>& sums,
                      TwinState* state) {
  double frame = 0.0, reference = 0.0, frame_mean = 0.0, reference_mean = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!sums[i].visible) continue;
    const double n = static_cast<double>(points[i].pixels.size());
    const double w = state->weights[i];
    frame += w * (sums[i].s2 - sums[i].s1 * sums[i].s1 / n);
    reference += w * points[i].E;
    frame_mean += w * (sums[i].s1 / n + points[i].m0);
    reference_mean += w * points[i].m0;
    weight += w;
  }
  state->gain = std::clamp(std::sqrt(frame / reference), 0.2, 5.0);
  state->bias = (frame_mean - state->gain * reference_mean) / weight;
}

double huberThreshold(const std::vector<double>& rho,
                      const std::vector<TwinSums>& sums,
                      const Config::Direct& direct,
                      const TwinState& state) {
  double weighted = 0.0, weight = 0.0;
  for (std::size_t i = 0; i < rho.size(); ++i) {
    if (!sums[i].visible) continue;
    weighted += state.weights[i] * rho[i];
    weight += state.weights[i];
  }
  return std::max(direct.huber_factor * weighted / weight, direct.huber_floor);
}

bool update(const Vec6d& b, TwinState* state) {
  const Vec6d scale = state->H.diagonal().cwiseSqrt().cwiseInverse();
  const Mat6d A = scale.asDiagonal() * state->H * scale.asDiagonal();
  const Eigen::LLT<Mat6d> llt(A + 1e-6 * Mat6d::Identity());
  if (!(state->H.diagonal().minCoeff() > 1e-9) || llt.info() != Eigen::Success) return false;
  state->delta = scale.cwiseProduct(llt.solve(scale.cwiseProduct(b)));
  state->T_cam_ref = state->T_cam_ref * SE3d::exp(-state->delta);
  return true;
}

}  // namespace

double sampleTwin(const ImageF& image, double u, double v) {
  const int x = static_cast<int>(std::floor(u));
  const int y = static_cast<int>(std::floor(v));
  const double fx = u - x;
  const double fy = v - y;
  const auto at = [&](int dx, int dy) { return static_cast<double>(image.at(x + dx, y + dy)); };
  return (1.0 - fy) * ((1.0 - fx) * at(0, 0) + fx * at(1, 0)) +
         fy * ((1.0 - fx) * at(0, 1) + fx * at(1, 1));
}

TwinPoint describeTwin(const ImageF& level_image,
                       const CameraModel& camera,
                       const Vec3d& p_ref,
                       int patch_size) {
  TwinPoint point;
  point.p_ref = p_ref;
  const std::optional<Projection> projection = camera.projectWithJacobian(p_ref);
  const int h = patch_size / 2;
  if (!projection || !isInside(projection->uv, level_image, h + 1, h + 2)) return point;
  point.valid = true;
  Eigen::Matrix<double, 3, 6> J_point_twist;
  J_point_twist << Mat3d::Identity(), -skew(p_ref);
  const Mat26d J = projection->J_uv_point * J_point_twist;
  point.Jx = J.row(0);
  point.Jy = J.row(1);
  const Vec2d& uv = projection->uv;
  const auto sample = [&](int dx, int dy) {
    return sampleTwin(level_image, uv.x() + dx, uv.y() + dy);
  };
  forPatch(patch_size, [&](int dx, int dy) {
    point.pixels.emplace_back(sample(dx, dy),
                              (sample(dx + 1, dy) - sample(dx - 1, dy)) / 2.0,
                              (sample(dx, dy + 1) - sample(dx, dy - 1)) / 2.0);
    point.m0 += point.pixels.back().x() / (patch_size * patch_size);
  });
  for (Vec3d& pixel : point.pixels) {
    pixel.x() -= point.m0;
    point.E += pixel.x() * pixel.x();
    point.Ex += pixel.x() * pixel.y();
    point.Ey += pixel.x() * pixel.z();
    point.Gx += pixel.y();
    point.Gy += pixel.z();
    point.Gxx += pixel.y() * pixel.y();
    point.Gxy += pixel.y() * pixel.z();
    point.Gyy += pixel.z() * pixel.z();
  }
  return point;
}

TwinSums sumTwin(const ImageF& level_image,
                 const CameraModel& camera,
                 const SE3d& T_cam_ref,
                 const TwinPoint& point) {
  TwinSums sums;
  if (!point.valid) return sums;
  const int patch_size = static_cast<int>(std::lround(std::sqrt(point.pixels.size())));
  const int h = patch_size / 2;
  const std::optional<Vec2d> uv = camera.project(T_cam_ref * point.p_ref);
  if (!uv || !isInside(*uv, level_image, h, h + 1)) return sums;
  sums.visible = true;
  std::size_t k = 0;
  forPatch(patch_size, [&](int dx, int dy) {
    const double i = sampleTwin(level_image, uv->x() + dx, uv->y() + dy) - point.m0;
    const Vec3d& pixel = point.pixels[k++];
    sums.s1 += i;
    sums.s2 += i * i;
    sums.sc += i * pixel.x();
    sums.sx += i * pixel.y();
    sums.sy += i * pixel.z();
  });
  return sums;
}

bool solveTwin(const std::vector<TwinPoint>& points,
               const std::vector<TwinSums>& sums,
               const Config::Direct& direct,
               TwinState* state) {
  if (direct.photometric == PhotometricModel::gain_bias) estimateExposure(points, sums, state);
  std::vector<double> rho(points.size(), 0.0);
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!sums[i].visible) continue;
    const double squares = residualsOf(points[i], sums[i], *state).squares;
    rho[i] = std::sqrt(std::max(squares, 0.0) / static_cast<double>(points[i].pixels.size()));
  }
  const double threshold = huberThreshold(rho, sums, direct, *state);
  const bool constant = direct.hessian == HessianMode::constant;
  Vec6d b = Vec6d::Zero();
  double weight = 0.0;
  state->H.setZero();
  state->rms = state->contrast = 0.0;
  state->visible = state->inliers = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (points[i].valid && constant) state->H += hessianOf(points[i]);
    if (!sums[i].visible) continue;
    const double w = constant ? 1.0 : std::min(1.0, threshold / rho[i]);
    state->weights[i] = w;
    if (!constant) state->H += w * hessianOf(points[i]);
    b += w * residualsOf(points[i], sums[i], *state).J_r;
    weight += w;
    state->rms += w * rho[i];
    state->contrast += std::sqrt(points[i].E / static_cast<double>(points[i].pixels.size()));
    state->inliers += rho[i] <= threshold ? 1 : 0;
    ++state->visible;
  }
  state->rms /= weight;
  state->contrast /= state->visible;
  return update(b, state);
}

GpuPointRecord packRecord(const TwinPoint& p) {
  const auto f = [](double value) { return static_cast<float>(value); };
  GpuPointRecord record{};
  for (int i = 0; i < 3; ++i) record.p_ref[i] = f(p.p_ref[i]);
  record.p_ref[3] = p.valid ? 1.0F : 0.0F;
  for (int i = 0; i < 6; ++i) {
    record.jx_jy[i] = f(p.Jx[i]);
    record.jx_jy[6 + i] = f(p.Jy[i]);
  }
  const double moments[] = {p.m0, p.E, p.Ex, p.Ey};
  const double gradients[] = {p.Gx, p.Gy, p.Gxx, p.Gxy};
  std::transform(std::begin(moments), std::end(moments), record.moments, f);
  std::transform(std::begin(gradients), std::end(gradients), record.gradients, f);
  record.rest[0] = f(p.Gyy);
  return record;
}

GpuPointSums packSums(const TwinSums& sums) {
  const auto f = [](double value) { return static_cast<float>(value); };
  return {{f(sums.s1), f(sums.s2), f(sums.sc), f(sums.sx)},
          {f(sums.sy), sums.visible ? 1.0F : 0.0F, 0.0F, 0.0F}};
}

}  // namespace glide::test
