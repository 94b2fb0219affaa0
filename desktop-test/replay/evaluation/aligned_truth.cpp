#include "replay/evaluation/aligned_truth.h"

#include "geometry/align_sim3.h"

#include <cstddef>
#include <utility>

namespace glide::replay {
namespace {

constexpr std::size_t kMostPoses = 2000;

std::optional<Sim3d> similarity(const Trajectory& truth,
                                const Trajectory& estimate,
                                const std::vector<PosePair>& pairs) {
  std::vector<Vec3d> p_truth, p_estimate;
  for (const PosePair& pair : pairs) {
    p_truth.push_back(truth[pair.truth].T_world_rig.t);
    p_estimate.push_back(estimate[pair.estimate].T_world_rig.t);
  }
  const auto S_truth_estimate = alignSim3(p_truth, p_estimate, AlignScale::estimated);
  if (!S_truth_estimate) return std::nullopt;
  return S_truth_estimate->inverse();
}

/// The poses from the estimate's first time to its last, thinned out.
Trajectory during(const Trajectory& truth, const Trajectory& estimate) {
  Trajectory part;
  for (const StampedPose& pose : truth) {
    const bool is_within = pose.t_ns >= estimate.front().t_ns && pose.t_ns <= estimate.back().t_ns;
    if (is_within) part.push_back(pose);
  }
  const std::size_t stride = 1 + part.size() / kMostPoses;
  Trajectory thin;
  for (std::size_t i = 0; i < part.size(); i += stride) thin.push_back(part[i]);
  return thin;
}

}  // namespace

std::optional<AlignedTruth> alignTruth(const Trajectory& truth, const Trajectory& estimate) {
  std::vector<PosePair> pairs = associate(truth, estimate);
  const std::optional<Sim3d> S_estimate_truth = similarity(truth, estimate, pairs);
  if (!S_estimate_truth) return std::nullopt;
  AlignedTruth aligned{*S_estimate_truth, std::move(pairs), during(truth, estimate)};
  for (StampedPose& pose : aligned.path) {
    SE3d& T_world_rig = pose.T_world_rig;
    T_world_rig = {(S_estimate_truth->q * T_world_rig.q).normalized(),
                   *S_estimate_truth * T_world_rig.t};
  }
  return aligned;
}

}  // namespace glide::replay
