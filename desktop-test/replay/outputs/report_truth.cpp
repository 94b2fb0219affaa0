#include "replay/outputs/report_truth.h"

#include "replay/evaluation/aligned_truth.h"

#include <limits>

namespace glide::replay {
namespace {

constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

std::array<float, 3> toFloats(const Vec3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

}  // namespace

std::optional<ReportTruth> reportTruth(const Trajectory& truth, const Trajectory& trajectory) {
  const std::optional<AlignedTruth> aligned = alignTruth(truth, trajectory);
  if (!aligned) return std::nullopt;
  ReportTruth result;
  result.meters_per_unit = 1.0 / aligned->S_estimate_truth.s;
  for (const StampedPose& pose : aligned->path) {
    const std::array<float, 3> p_world = toFloats(pose.T_world_rig.t);
    result.path.insert(result.path.end(), p_world.begin(), p_world.end());
  }
  result.matched.assign(trajectory.size(), {kNone, kNone, kNone});
  for (const PosePair& pair : aligned->pairs) {
    result.matched[pair.estimate] =
        toFloats(aligned->S_estimate_truth * truth[pair.truth].T_world_rig.t);
  }
  return result;
}

}  // namespace glide::replay
