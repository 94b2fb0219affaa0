#include "replay/outputs/report_truth.h"

#include "replay/evaluation/accuracy.h"

#include "geometry/align_sim3.h"

#include <cstdint>
#include <limits>

namespace glide::replay {
namespace {

constexpr std::size_t kMaxPathPoints = 2000;  // more are not to be told apart on a screen
constexpr float kNone = std::numeric_limits<float>::quiet_NaN();

std::array<float, 3> toFloats(const Vec3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

/// The poses of the truth from the trajectory's first time to its last.
Trajectory during(const Trajectory& truth, const Trajectory& trajectory) {
  Trajectory part;
  for (const StampedPose& pose : truth) {
    const bool is_within =
        pose.t_ns >= trajectory.front().t_ns && pose.t_ns <= trajectory.back().t_ns;
    if (is_within) part.push_back(pose);
  }
  return part;
}

std::vector<float> thinnedPath(const Trajectory& truth, const Sim3d& S_world_truth) {
  const std::size_t stride = 1 + truth.size() / kMaxPathPoints;
  std::vector<float> path;
  for (std::size_t i = 0; i < truth.size(); i += stride) {
    const std::array<float, 3> p_world = toFloats(S_world_truth * truth[i].T_world_rig.t);
    path.insert(path.end(), p_world.begin(), p_world.end());
  }
  return path;
}

}  // namespace

std::optional<ReportTruth> reportTruth(const Trajectory& truth, const Trajectory& trajectory) {
  const std::vector<PosePair> pairs = associate(truth, trajectory);
  std::vector<Vec3d> p_truth, p_world;
  for (const PosePair& pair : pairs) {
    p_truth.push_back(truth[pair.truth].T_world_rig.t);
    p_world.push_back(trajectory[pair.estimate].T_world_rig.t);
  }
  const std::optional<Sim3d> S_truth_world = alignSim3(p_truth, p_world, AlignScale::estimated);
  if (!S_truth_world) return std::nullopt;
  const Sim3d S_world_truth = S_truth_world->inverse();
  ReportTruth result;
  result.meters_per_unit = S_truth_world->s;
  result.path = thinnedPath(during(truth, trajectory), S_world_truth);
  result.matched.assign(trajectory.size(), {kNone, kNone, kNone});
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    result.matched[pairs[i].estimate] = toFloats(S_world_truth * p_truth[i]);
  }
  return result;
}

}  // namespace glide::replay
