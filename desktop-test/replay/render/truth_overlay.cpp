#include "replay/render/truth_overlay.h"

#include "replay/evaluation/accuracy.h"
#include "replay/outputs/run_trajectories.h"

#include "geometry/align_sim3.h"
#include "geometry/lie.h"

#include <algorithm>
#include <cstddef>
#include <optional>

namespace glide::replay {
namespace {

constexpr std::size_t kLeastPairs = 20;    // a shorter path aligns with anything
constexpr std::size_t kMostPoses = 2'000;  // of a picture; a truth at 200 Hz has many more

Pose transformed(const Sim3d& S_map_truth, const SE3d& T_truth_cam) {
  const Vec3d t = S_map_truth * T_truth_cam.t;
  const Eigen::Quaterniond q = (S_map_truth.q * T_truth_cam.q).normalized();
  return {{t.x(), t.y(), t.z()}, {q.x(), q.y(), q.z(), q.w()}};
}

std::optional<Sim3d> align(const Trajectory& truth, const Trajectory& estimate) {
  const std::vector<PosePair> pairs = associate(truth, estimate);
  if (pairs.size() < kLeastPairs) return std::nullopt;
  std::vector<Vec3d> p_truth, p_estimate;
  for (const PosePair& pair : pairs) {
    p_truth.push_back(truth[pair.truth].T_world_rig.t);
    p_estimate.push_back(estimate[pair.estimate].T_world_rig.t);
  }
  return alignSim3(p_estimate, p_truth, AlignScale::estimated);
}

/// What the truth tells of these times, thinned out.
Trajectory between(const Trajectory& truth, std::int64_t first_ns, std::int64_t last_ns) {
  Trajectory part;
  for (const StampedPose& pose : truth) {
    if (pose.t_ns >= first_ns && pose.t_ns <= last_ns) part.push_back(pose);
  }
  const std::size_t stride = 1 + part.size() / kMostPoses;
  Trajectory thin;
  for (std::size_t i = 0; i < part.size(); i += stride) thin.push_back(part[i]);
  return thin;
}

}  // namespace

void TruthOverlay::add(const FrameRecord& frame) {
  if (!truth_.empty()) run_.frames.push_back(frame);
}

std::vector<Pose> TruthOverlay::alignedTo(const std::shared_ptr<const MapView>& map) {
  if (truth_.empty()) return {};
  run_.map = map;
  const Trajectory estimate = buildTrajectories(run_).camera.recomposed;
  if (estimate.empty()) return {};
  const Trajectory part = between(truth_, estimate.front().t_ns, estimate.back().t_ns);
  const std::optional<Sim3d> S_map_truth = align(part, estimate);
  std::vector<Pose> poses;
  if (!S_map_truth) return poses;
  for (const StampedPose& pose : part) poses.push_back(transformed(*S_map_truth, pose.T_world_rig));
  return poses;
}

}  // namespace glide::replay
