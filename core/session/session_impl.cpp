#include "session/session_impl.h"

#include "session/pose_conversion.h"
#include "track/keyframe_policy.h"

#include "base/stopwatch.h"

#include <algorithm>
#include <limits>
#include <string>
#include <utility>

namespace glide {
namespace {

// A map this small is cheaper to start over than to find again.
constexpr std::size_t kTinyMapKeyframes = 5;
// Frames that a tiny map may be lost before it is given up.
constexpr int kLostFramesBeforeReset = 5;

Error invalid(const std::string& what) { return {ErrorCode::invalid_argument, what}; }

double distanceToReference(const TrackedFrame& tracked) {
  return tracked.pose.T_cam_key.inverse().t.norm() / std::max(tracked.median_depth, 1e-9);
}

}  // namespace

Session::Impl::Impl(const Config& config, const CameraModel& camera, ChosenAligner aligner)
    : config_(config),
      camera_(camera),
      backend_(aligner.info),
      mapping_(config, camera),
      indirect_(config, camera),
      initializer_(config, camera),
      last_t_ns_(std::numeric_limits<std::int64_t>::min()) {
  if (config.tracker == TrackerMode::hybrid)
    direct_.emplace(config.direct, std::move(aligner.aligner));
}

Status Session::Impl::check(const FrameInput& input) const {
  const Luma& image = input.image;
  if (image.pixels == nullptr) return invalid("FrameInput.image.pixels is null");
  if (image.width != camera_.width() || image.height != camera_.height())
    return invalid("FrameInput.image is " + std::to_string(image.width) + "x" +
                   std::to_string(image.height) + ", but the camera of the config is " +
                   std::to_string(camera_.width()) + "x" + std::to_string(camera_.height()));
  if (image.stride < image.width)
    return invalid("FrameInput.image.stride is smaller than the width");
  if (input.t_ns <= last_t_ns_)
    return invalid("FrameInput.t_ns " + std::to_string(input.t_ns) +
                   " does not increase (the frame before had " + std::to_string(last_t_ns_) + ")");
  return Unit{};
}

FrameResult Session::Impl::update(const FrameInput& input) {
  Stopwatch watch;
  last_t_ns_ = input.t_ns;
  const Luma& image = input.image;
  const Frame frame{
      input.t_ns, {image.pixels, image.width, image.height, image.stride}, mapping_.snapshot()};
  FrameResult result;
  if (!last_keyframe_) {
    result = initialize(frame);
  } else if (isMapPending(frame)) {
    result = waitForMap(frame);
  } else {
    result = track(frame);
  }
  result.stats.update_ms = watch.lapMs() - result.stats.mapping_ms;
  return result;
}

FrameResult Session::Impl::initialize(const Frame& frame) {
  TrackedFrame tracked;
  Stopwatch watch;
  tracked.features = indirect_.extract(frame.luma, config_.features.initialization_count);
  tracked.stats.features_ms = watch.lapMs();
  std::optional<InitialMap> start = initializer_.update(frame.t_ns, tracked.features);
  tracked.stats.pose_ms = watch.lapMs();
  if (start) startMap(frame, std::move(*start), &tracked);
  FrameResult result = toResult(frame, tracked);
  result.initialization = initializer_.progress();
  if (tracked.ok) initializer_.reset();
  return result;
}

void Session::Impl::startMap(const Frame& frame, InitialMap start, TrackedFrame* tracked) {
  start.a.id = KeyframeId{next_keyframe_id_++};
  start.b.id = KeyframeId{next_keyframe_id_++};
  map_start_ = start.a.id;
  tracked->pose = {start.b.id, SE3d{}, start.b.T_cam_world};
  tracked->stats.visible = tracked->stats.inliers = static_cast<int>(start.points.size());
  tracked->ok = mapping_.offer(std::move(start), &tracked->stats.mapping_ms);
  if (!tracked->ok)
    return;  // the mapper still works on the map that was given up: try the next frame
  tracked->tracker = TrackerKind::indirect;
  tracked->confidence = 1.0;
  tracked->stats.keyframe = true;
  const std::shared_ptr<const MapSnapshot> map = mapping_.snapshot();
  tracked->T_cam_world = tracked->pose.T_cam_world(*map);
  last_keyframe_ = LastKeyframe{tracked->pose.keyframe, 0};
  last_pose_ = tracked->pose;
  lost_frames_ = 0;
  motion_.reset();
  motion_.update(frame.t_ns, tracked->pose, *map);
}

bool Session::Impl::isMapPending(const Frame& frame) const {
  return !frame.map->T_cam_world(map_start_).has_value();
}

FrameResult Session::Impl::waitForMap(const Frame& frame) const {
  FrameResult result = toResult(frame, TrackedFrame());
  result.state = TrackingState::initializing;
  result.initialization.status = InitializationStatus::done;
  return result;
}

FrameResult Session::Impl::track(const Frame& frame) {  // the schedule of the paper, section II
  const SE3d T_cam_world_guess =
      motion_.predict(frame.t_ns, *frame.map).value_or(last_pose_.T_cam_world(*frame.map));
  TrackedFrame tracked = trackDirect(frame, T_cam_world_guess);
  if (!tracked.ok) tracked = trackIndirect(frame, tracked);
  if (tracked.ok) {
    onTracked(frame, &tracked);
  } else {
    onLost();
  }
  FrameResult result = toResult(frame, tracked);
  if (!last_keyframe_) initializer_.reset();
  return result;
}

TrackedFrame Session::Impl::trackDirect(const Frame& frame, const SE3d& T_cam_world_guess) {
  if (direct_) return direct_->track(frame, T_cam_world_guess);
  TrackedFrame tracked;
  tracked.T_cam_world = T_cam_world_guess;
  tracked.switch_reason = SwitchReason::disabled;
  return tracked;
}

TrackedFrame Session::Impl::trackIndirect(const Frame& frame, const TrackedFrame& direct) {
  IndirectGuess guess{direct.T_cam_world, GuessQuality::predicted, last_pose_.keyframe};
  if (direct.tracker == TrackerKind::direct) guess.quality = GuessQuality::aligned;
  TrackedFrame tracked = indirect_.track(frame, guess);
  tracked.switch_reason = direct.switch_reason;
  tracked.stats.pyramid_ms = direct.stats.pyramid_ms;
  tracked.stats.align_ms = direct.stats.align_ms;
  return tracked;
}

void Session::Impl::onTracked(const Frame& frame, TrackedFrame* tracked) {
  lost_frames_ = 0;
  ++last_keyframe_->frames_since;
  if (tracked->tracker == TrackerKind::indirect) {
    countSightings(*tracked);
    offerKeyframe(frame, tracked);
    if (direct_) tracked->stats.precompute_ms = direct_->refreshReference(frame, *tracked);
  }
  motion_.update(frame.t_ns, tracked->pose, *frame.map);
  last_pose_ = tracked->pose;
}

void Session::Impl::countSightings(const TrackedFrame& tracked) {
  for (const LandmarkSighting& sighting : tracked.sightings) {
    LandmarkSighting& sum = sightings_[sighting.id];
    sum.id = sighting.id;
    sum.visible += sighting.visible;
    sum.found += sighting.found;
  }
}

void Session::Impl::offerKeyframe(const Frame& frame, TrackedFrame* tracked) {
  const KeyframeEvidence evidence{last_keyframe_->frames_since,
                                  tracked->tracked_landmarks,
                                  tracked->reference_landmarks,
                                  distanceToReference(*tracked)};
  if (!wantsKeyframe(config_.keyframes, evidence)) return;
  NewKeyframe keyframe = makeKeyframe(frame, *tracked);
  const KeyframeId id = keyframe.id;
  tracked->stats.keyframe = mapping_.offer(std::move(keyframe), &tracked->stats.mapping_ms);
  if (!tracked->stats.keyframe) return;
  ++next_keyframe_id_;
  last_keyframe_ = LastKeyframe{id, 0};
  sightings_.clear();
  tracked->pose = {id, SE3d{}, tracked->T_cam_world};
}

NewKeyframe Session::Impl::makeKeyframe(const Frame& frame, const TrackedFrame& tracked) {
  NewKeyframe keyframe;
  keyframe.id = KeyframeId{next_keyframe_id_};
  keyframe.t_ns = frame.t_ns;
  keyframe.features = tracked.features;
  keyframe.reference = tracked.pose.keyframe;
  keyframe.T_cam_ref = tracked.pose.T_cam_key;
  keyframe.landmarks = tracked.landmarks;
  for (const auto& [id, sighting] : sightings_) keyframe.sightings.push_back(sighting);
  std::sort(keyframe.sightings.begin(), keyframe.sightings.end(), [](const auto& a, const auto& b) {
    return a.id < b.id;
  });
  return keyframe;
}

void Session::Impl::onLost() {
  motion_.stop();
  if (direct_) direct_->dropReference();
  ++lost_frames_;
  const bool tiny = mapping_.snapshot()->keyframes().size() < kTinyMapKeyframes;
  if (!tiny || lost_frames_ < kLostFramesBeforeReset) return;
  last_keyframe_.reset();
  sightings_.clear();
  ++resets_;
}

FrameResult Session::Impl::toResult(const Frame& frame, const TrackedFrame& tracked) const {
  FrameResult result;
  result.t_ns = frame.t_ns;
  result.tracker = tracked.tracker;
  result.switch_reason = tracked.switch_reason;
  result.stats = tracked.stats;
  result.map_revision = mapping_.snapshot()->revision();
  if (tracked.ok) {
    result.state = TrackingState::tracking;
    result.confidence = tracked.confidence;
    result.T_world_cam = toPose(tracked.T_cam_world.inverse());
    result.reference_keyframe = tracked.pose.keyframe.value;
    result.T_ref_cam = toPose(tracked.pose.T_cam_key.inverse());
    return result;
  }
  result.tracker = TrackerKind::none;
  result.state = last_keyframe_ ? TrackingState::lost : TrackingState::initializing;
  result.T_world_cam = toPose(last_pose_.T_cam_world(*frame.map).inverse());
  result.reference_keyframe = last_pose_.keyframe.value;
  result.T_ref_cam = toPose(last_pose_.T_cam_key.inverse());
  return result;
}

}  // namespace glide
