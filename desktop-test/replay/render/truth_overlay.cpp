#include "replay/render/truth_overlay.h"

#include "replay/evaluation/aligned_truth.h"
#include "replay/outputs/run_trajectories.h"

#include "geometry/pose_conversion.h"

#include <cstddef>
#include <optional>

namespace glide::replay {
namespace {

constexpr std::size_t kLeastPairs = 20;  // a shorter path aligns with anything

}  // namespace

void TruthOverlay::add(const FrameRecord& frame) {
  if (!truth_.empty()) run_.frames.push_back(frame);
}

std::vector<Pose> TruthOverlay::alignedTo(const std::shared_ptr<const MapView>& map) {
  if (truth_.empty()) return {};
  run_.map = map;
  const std::optional<AlignedTruth> aligned =
      alignTruth(truth_, buildTrajectories(run_).camera.recomposed);
  if (!aligned || aligned->pairs.size() < kLeastPairs) return {};
  std::vector<Pose> poses;
  for (const StampedPose& pose : aligned->path) poses.push_back(toPose(pose.T_world_rig));
  return poses;
}

}  // namespace glide::replay
