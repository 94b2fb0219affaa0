#pragma once

#include "photometric/align_types.h"
#include "photometric/aligned_vector.h"
#include "photometric/normal_equations.h"
#include "photometric/patch_kernels.h"

#include "geometry/camera_model.h"
#include "image/pyramid.h"

#include <span>
#include <vector>

namespace glide {

/// A point of the reference and where it is seen at level 0.
struct ReferencePoint {
  Vec3d p_ref;
  Vec2d uv;           ///< not a number when the point does not project
  Mat26d J_uv_twist;  ///< by exp(twist) acting on p_ref, twist = (translation, rotation)
};

/// The inverse-compositional cache of one pyramid level: its valid points, one entry of each vector
/// per point ("slot").
struct ReferenceLevel {
  std::vector<std::size_t> point;  ///< index into ReferenceCache::points
  std::vector<PatchSite> sites;    ///< where the patches were sampled
  std::vector<PatchMoments> moments;
  AlignedVector<float> blocks;  ///< PatchLayout::blockSize() floats per slot
  AlignedVector<PointNormal> normals;
  Mat6d H_all = Mat6d::Zero();  ///< sum of all H_i, for HessianMode::constant

  int size() const { return static_cast<int>(point.size()); }
};

/// What is kept of a reference frame: its points and, per level, patches, gradients and normal
/// matrices. The image itself is not needed any more.
struct ReferenceCache {
  std::vector<ReferencePoint> points;
  std::vector<ReferenceLevel> levels;

  /// Takes memory for `levels_count` levels of `points_count` points, so that buildReferenceCache
  /// allocates nothing up to there.
  void reserve(int levels_count, int points_count, const PatchLayout& layout);
};

/// Fills the cache from the pyramid of the reference; `camera` is that of level 0.
void buildReferenceCache(const Pyramid& pyramid,
                         const CameraModel& camera,
                         const PatchLayout& layout,
                         std::span<const AlignPoint> points_ref,
                         ReferenceCache* out);

}  // namespace glide
