#include "map/feature_refinement.h"

#include "feature/patch_alignment.h"

#include "geometry/patch_warp.h"

#include <cmath>

namespace glide {
namespace {

// Beyond this change of scale or shear the patches hold different detail.
constexpr double kMaxAreaRatio = 3.0;

}  // namespace

std::optional<FeatureMove> refineFeature(const RefinementContext& context,
                                         const PosedFeature& source,
                                         const PosedFeature& target,
                                         const Vec3d& p_world) {
  if (!source.features->hasPatches() || !target.features->hasPatches()) return std::nullopt;
  const auto i = static_cast<std::size_t>(source.feature);
  const auto j = static_cast<std::size_t>(target.feature);
  const SE3d T_target_source = target.T_cam_world * source.T_cam_world.inverse();
  const std::optional<Mat2d> warp =
      patchWarp(*context.camera, T_target_source, source.T_cam_world * p_world);
  if (!warp) return std::nullopt;
  const double scale_source = context.levels->scale(source.features->feature(i).level);
  const double scale_target = context.levels->scale(target.features->feature(j).level);
  const Mat2d A_target_source = *warp * (scale_source / scale_target);
  const double area = std::abs(A_target_source.determinant());
  if (!(area < kMaxAreaRatio && area > 1.0 / kMaxAreaRatio)) return std::nullopt;

  const std::optional<Vec2f> offset = alignPatch(
      source.features->patch(i), target.features->patch(j), A_target_source.cast<float>());
  if (!offset) return std::nullopt;
  const Vec2f moved = *offset - target.features->patch(j).offset;
  const Vec2f uv = target.features->feature(j).uv + moved * static_cast<float>(scale_target);
  return FeatureMove{target.feature, uv, *offset};
}

}  // namespace glide
