#include "gpu/point_order.h"

#include <algorithm>
#include <optional>

namespace glide {
namespace {

constexpr int kNowhere = -1;

/// The kernels project in float: a point counts as valid when it misses by less, px of the level.
constexpr double kSlack = 0.05;

}  // namespace

PointOrder::PointOrder(const GpuAlignSpec& spec)
    : camera_(spec.camera),
      levels_(spec.levels),
      half_patch_(spec.direct.patch_size / 2),
      max_points_(static_cast<std::size_t>(spec.direct.max_points)) {
  sorted_.reserve(max_points_);
  coarsest_.reserve(max_points_);
}

void PointOrder::sort(std::span<const AlignPoint> points_ref) {
  points_ref = points_ref.first(std::min(points_ref.size(), max_points_));
  coarsest_.clear();
  for (const AlignPoint& point : points_ref) coarsest_.push_back(coarsestLevel(point.p_ref));
  sorted_.clear();
  for (int level = levels_ - 1; level >= 0; --level) {
    for (std::size_t i = 0; i < points_ref.size(); ++i) {
      if (coarsest_[i] == level) sorted_.push_back(points_ref[i]);
    }
    counts_[static_cast<std::size_t>(level)] = static_cast<int>(sorted_.size());
  }
}

int PointOrder::coarsestLevel(const Vec3d& p_ref) const {
  const std::optional<Vec2d> uv = camera_.project(p_ref);
  if (!uv) return kNowhere;
  const double low = half_patch_ + 1 - kSlack;
  const double high = half_patch_ + 2 - kSlack;
  int width = camera_.width();
  int height = camera_.height();
  int coarsest = kNowhere;
  Vec2d uv_level = *uv;
  for (int level = 0; level < levels_; ++level) {
    const bool fits =
        uv_level.minCoeff() >= low && uv_level.x() < width - high && uv_level.y() < height - high;
    if (!fits) break;
    coarsest = level;
    uv_level *= 0.5;
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
  return coarsest;
}

}  // namespace glide
