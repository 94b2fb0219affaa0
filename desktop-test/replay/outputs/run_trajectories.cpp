#include "replay/outputs/run_trajectories.h"

#include <unordered_map>

namespace glide::replay {
namespace {

bool isTracked(const FrameRecord& frame) { return frame.result.state == TrackingState::tracking; }

/// The first frame after the last start-over that a tracked frame follows.
std::size_t lastMapStart(const std::vector<FrameRecord>& frames) {
  std::size_t end = frames.size();
  while (end > 0 && !isTracked(frames[end - 1])) --end;
  while (end > 0 && frames[end - 1].result.state != TrackingState::initializing) --end;
  return end;
}

}  // namespace

SE3d toSE3(const Pose& pose) {
  const auto& [x, y, z, w] = pose.q_xyzw;
  const auto& t = pose.t_xyz;
  return {Eigen::Quaterniond(w, x, y, z).normalized(), Vec3d(t[0], t[1], t[2])};
}

RunTrajectories buildTrajectories(const RunRecord& run) {
  RunTrajectories result;
  struct Key {
    SE3d T_world_key;
    double scale = 1.0;
  };
  std::unordered_map<std::uint64_t, Key> keys;
  for (const MapView::Keyframe& keyframe : run.map->keyframes) {
    keys[keyframe.id] = {toSE3(keyframe.T_world_cam), keyframe.scale};
    if (keyframe.retired) continue;
    result.camera.keyframes.push_back({keyframe.t_ns, toSE3(keyframe.T_world_cam)});
  }
  const std::size_t start = lastMapStart(run.frames);
  result.kept.assign(run.frames.size(), false);
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const FrameResult& frame = run.frames[i].result;
    if (!isTracked(run.frames[i])) continue;
    const auto reference = keys.find(frame.reference_keyframe);
    if (i < start || reference == keys.end()) {
      ++result.of_older_maps;
      continue;
    }
    result.kept[i] = true;
    SE3d T_key_cam = toSE3(frame.T_ref_cam);
    T_key_cam.t *= reference->second.scale / frame.reference_scale;
    result.camera.recomposed.push_back({frame.t_ns, reference->second.T_world_key * T_key_cam});
    result.camera.live.push_back({frame.t_ns, toSE3(frame.T_world_cam)});
  }
  return result;
}

}  // namespace glide::replay
