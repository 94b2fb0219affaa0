#pragma once

#include "gpu/align_layout.h"
#include "photometric/align_types.h"

#include <array>
#include <span>
#include <vector>

namespace glide {

/// A reference's points in an order in which a level's valid points come first, on every level: a
/// patch that fits into a coarse level fits into the finer ones. Kernels then run over the head of
/// the list only, with no idle invocation in between. Allocates at creation only.
class PointOrder {
 public:
  explicit PointOrder(const GpuAlignSpec& spec);

  /// Takes the first max_points of `points_ref`. Those of one class keep their order.
  void sort(std::span<const AlignPoint> points_ref);

  /// Without points that are valid nowhere.
  std::span<const AlignPoint> points() const { return sorted_; }
  /// The first so many points hold all that are valid at `level`, and hardly another: which of them
  /// are is the kernels' decision.
  int count(int level) const { return counts_[static_cast<std::size_t>(level)]; }

 private:
  int coarsestLevel(const Vec3d& p_ref) const;

  CameraModel camera_;
  int levels_, half_patch_;
  std::size_t max_points_;
  std::vector<AlignPoint> sorted_;
  std::vector<int> coarsest_;  ///< level of each given point, kNowhere for none
  std::array<int, kMaxAlignLevels> counts_{};
};

}  // namespace glide
