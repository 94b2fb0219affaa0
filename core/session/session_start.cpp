#include "session/session_impl.h"

#include <utility>

// What a session does until it has a map.
namespace glide {

FrameResult Session::Impl::initialize(Frame* frame) {
  TrackedFrame tracked;
  const ImageViewU8 luma = reader_.luma();
  Stopwatch watch;
  tracked.features = indirect_.extract(luma, config_.features.initialization_count);
  tracked.stats.features_ms = watch.lapMs();
  std::optional<InitialMap> start = initializer_.update(frame->t_ns, tracked.features);
  tracked.stats.pose_ms = watch.lapMs();
  if (start) startMap(std::move(*start), frame, &tracked);
  FrameResult result = toResult(*frame, tracked);
  result.initialization = initializer_.progress();
  if (tracked.ok) initializer_.reset();
  return result;
}

void Session::Impl::startMap(InitialMap start, Frame* frame, TrackedFrame* tracked) {
  start.a.id = KeyframeId{next_keyframe_id_++};
  start.b.id = KeyframeId{next_keyframe_id_++};
  map_start_ = start.a.id;
  tracked->pose = {start.b.id, SE3d{}, 1.0, start.b.T_cam_world, std::nullopt};
  tracked->stats.visible = tracked->stats.inliers = static_cast<int>(start.points.size());
  Stopwatch watch;
  tracked->ok = back_end_.offer(std::move(start));
  tracked->stats.mapping_ms = inlineMs(&watch);
  if (!tracked->ok)
    return;  // the mapper still works on the map that was given up: try the next frame
  ++generation_;
  const std::shared_ptr<const MapSnapshot> mapped = back_end_.snapshot();
  tracked->ok = !isStartRefused(*mapped);
  if (!tracked->ok) return giveUpStart(*mapped);
  if (mapped->generation() == generation_) frame->map = mapped;
  tracked->tracker = TrackerKind::indirect;
  tracked->confidence = 1.0;
  tracked->stats.keyframe = true;
  tracked->T_cam_world = tracked->pose.T_cam_world(*frame->map);
  last_keyframe_ = LastKeyframe{tracked->pose.keyframe, 0};
  last_pose_ = tracked->pose;
  lost_frames_ = 0;
  motion_.reset();
  motion_.update(frame->t_ns, tracked->pose, *frame->map);
}

// The mapper counts refused maps, too: the next one to be shown is the one after.
void Session::Impl::giveUpStart(const MapSnapshot& map) {
  generation_ = map.generation();
  forgetMap();
}

bool Session::Impl::isStartRefused(const MapSnapshot& map) const {
  if (map.generation() != generation_) return map.generation() > generation_;
  return !map.T_cam_world(map_start_).has_value();
}

FrameResult Session::Impl::waitForMap(const Frame& frame) const {
  FrameResult result = toResult(frame, TrackedFrame());
  if (is_restored_) return result;  // lost, as until the camera is recognised
  result.state = TrackingState::initializing;
  result.initialization.status = InitializationStatus::done;
  return result;
}

}  // namespace glide
