#include "session/frame_report.h"

namespace glide {
namespace {

constexpr double kDegreesPerRadian = 57.29577951308232;

}  // namespace

void describePose(const AnchoredPose& pose, const MapSnapshot& map, FrameResult* result) {
  result->T_world_cam = toPose(pose.T_cam_world(map).inverse());
  result->reference_keyframe = pose.keyframe.value;
  result->T_ref_cam = toPose(pose.T_cam_key.inverse());
  result->reference_scale = pose.key_scale;
}

void addTimes(const FrameStats& earlier, FrameStats* stats) {
  stats->mapping_ms += earlier.mapping_ms;
  stats->pyramid_ms += earlier.pyramid_ms;
  stats->align_ms += earlier.align_ms;
  stats->features_ms += earlier.features_ms;
  stats->match_ms += earlier.match_ms;
  stats->pose_ms += earlier.pose_ms;
}

std::optional<WorldCorrection> correctionBetween(const MapSnapshot& before,
                                                 const MapSnapshot& after,
                                                 const AnchoredPose& pose) {
  const bool is_same_map = before.generation() == after.generation();
  if (!is_same_map || before.corrections() == after.corrections()) return std::nullopt;
  const SE3d T_world_cam_before = pose.T_cam_world(before).inverse();
  const SE3d T_world_cam_after = pose.T_cam_world(after).inverse();
  WorldCorrection correction;
  correction.translation = (T_world_cam_after.t - T_world_cam_before.t).norm();
  correction.rotation_deg =
      so3Log(T_world_cam_before.q.conjugate() * T_world_cam_after.q).norm() * kDegreesPerRadian;
  correction.scale = pose.growth(after) / pose.growth(before);
  return correction;
}

}  // namespace glide
