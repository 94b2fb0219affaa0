#include "photometric/point_residuals.h"

#include <algorithm>
#include <optional>

namespace glide {
namespace {

constexpr int kFinestOnly = 1;  // levels

}  // namespace

PointResiduals::PointResiduals(const Config::Direct& config, const CameraModel& camera)
    : config_(config),
      camera_(camera),
      layout_(PatchLayout::ofSize(config.patch_size)),
      evaluator_(config) {
  reference_.reserve(kFinestOnly, config.max_points, layout_);
  residuals_.reserve(static_cast<std::size_t>(config.max_points));
}

void PointResiduals::setReference(const ImageViewU8& luma, std::span<const AlignPoint> points_ref) {
  buildPyramid(luma, kFinestOnly, &image_);
  buildReferenceCache(image_, camera_, layout_, points_ref, &reference_);
}

std::span<const PointResiduals::Residual> PointResiduals::evaluate(const ImageViewU8& luma,
                                                                   const AlignResult& align) {
  residuals_.clear();
  if (reference_.levels.front().size() == 0) return residuals_;
  buildPyramid(luma, kFinestOnly, &image_);
  AlignState state;
  state.T_cam_ref = align.T_cam_ref;
  state.gain = align.gain;
  state.bias = align.bias;
  // What the aligner's next iteration would use.
  const double threshold = std::max(config_.huber_factor * align.rms, config_.huber_floor);
  const LevelPair pair{image_.levels.front(), camera_, reference_, reference_.levels.front()};
  for (const LevelEvaluator::Sample& sample : evaluator_.compare(pair, state)) {
    const Vec3d p_cam = align.T_cam_ref * reference_.points[sample.point].p_ref;
    if (const std::optional<Vec2d> uv = camera_.project(p_cam))
      residuals_.push_back({sample.point, *uv, sample.rho, sample.rho <= threshold});
  }
  return residuals_;
}

}  // namespace glide
