#include "session/session_impl.h"

#include "session/frame_report.h"
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

// Of the first map that will be started; what the mapper publishes before is of generation 0.
constexpr std::uint64_t kFirstGeneration = 1;

constexpr std::int64_t kNever = std::numeric_limits<std::int64_t>::min();

double distanceToReference(const TrackedFrame& tracked) {
  return tracked.pose.T_cam_key.inverse().t.norm() / std::max(tracked.median_depth, 1e-9);
}

}  // namespace

Session::Impl::Impl(const Config& config, const CameraModel& camera, ChosenAligner aligner)
    : config_(config),
      camera_(camera),
      back_end_(config, camera),
      no_map_(std::make_shared<const MapSnapshot>()),
      timeline_(std::make_shared<const PoseTimeline>(kFirstGeneration)),
      frame_map_(std::make_shared<const SnapshotMap>(no_map_, kFirstGeneration, 0)),
      newest_map_(frame_map_.load()),
      backend_(aligner.info),
      indirect_(config, camera),
      initializer_(config, camera),
      reader_(config, aligner.info.backend),
      last_t_ns_(kNever),
      used_answer_t_ns_(kNever) {
  if (config.tracker == TrackerMode::hybrid)
    direct_.emplace(config.direct, std::move(aligner.aligner));
  if (config.tracked_points != ReportPoints::off) reporter_.emplace(config.direct, camera);
}

Status Session::Impl::take(const FrameInput& input) {
  if (input.t_ns <= last_t_ns_)
    return Error{ErrorCode::out_of_order,
                 "the frame's t_ns " + std::to_string(input.t_ns) +
                     " does not increase (the frame before had " + std::to_string(last_t_ns_) +
                     ")"};
  if (is_paused_) return reader_.check(input.image);
  if (Status ready = ensureAligner(); !ready) return ready;
  return reader_.take(input.image);
}

FrameResult Session::Impl::update(const FrameInput& input) {
  Stopwatch watch;
  last_t_ns_ = input.t_ns;
  tracked_points_.clear();
  if (is_paused_) return pausedResult(input.t_ns);
  Frame frame{input.t_ns, currentMap()};
  const std::optional<WorldCorrection> correction =
      correctionBetween(frame_map_.load()->snapshot(), *frame.map, last_pose_);
  FrameResult result;
  if (!last_keyframe_) {
    result = isMapping() ? initialize(&frame) : toResult(frame, TrackedFrame());
  } else if (isMapPending(frame)) {
    result = waitForMap(frame);
  } else {
    result = track(&frame);
  }
  frame_map_.store(shown(frame.map, generation()));
  result.correction = correction;
  result.stats.readback_ms = reader_.readback_ms();
  remember(frame, result);
  result.stats.update_ms = watch.lapMs() - result.stats.mapping_ms;
  return result;
}

FrameResult Session::Impl::track(Frame* frame) {  // the schedule of the paper, section II
  const SE3d T_cam_world_guess =
      motion_.predict(frame->t_ns, *frame->map).value_or(last_pose_.T_cam_world(*frame->map));
  TrackedFrame tracked = trackDirect(*frame, T_cam_world_guess);
  if (!tracked.ok) tracked = trackIndirect(*frame, tracked);
  if (!tracked.ok) tracked = relocalize(*frame, tracked);
  if (tracked.ok) {
    onTracked(*frame, &tracked);
  } else {
    onLost();
  }
  if (!last_keyframe_) {  // the map was given up
    initializer_.reset();
    frame->map = no_map_;
  }
  return toResult(*frame, tracked);
}

TrackedFrame Session::Impl::trackDirect(const Frame& frame, const SE3d& T_cam_world_guess) {
  if (direct_) return direct_->track(frame, reader_.image(), T_cam_world_guess);
  TrackedFrame tracked;
  tracked.T_cam_world = T_cam_world_guess;
  tracked.switch_reason = SwitchReason::disabled;
  return tracked;
}

TrackedFrame Session::Impl::trackIndirect(const Frame& frame, const TrackedFrame& direct) {
  IndirectGuess guess{direct.T_cam_world, GuessQuality::predicted, last_pose_.keyframe};
  if (direct.tracker == TrackerKind::direct) guess.quality = GuessQuality::aligned;
  if (lost_frames_ > 0) guess.quality = GuessQuality::lost;
  TrackedFrame tracked = indirect_.track(frame, reader_.luma(), guess);
  tracked.switch_reason = direct.switch_reason;
  tracked.stats.pyramid_ms = direct.stats.pyramid_ms;
  tracked.stats.align_ms = direct.stats.align_ms;
  return tracked;
}

TrackedFrame Session::Impl::relocalize(const Frame& frame, const TrackedFrame& lost) {
  if (std::optional<TrackedFrame> found = tryAnswer(frame, lost)) return *found;
  Stopwatch watch;
  const bool is_asked = back_end_.ask({frame.t_ns, lost.features});
  TrackedFrame result = lost;
  result.stats.mapping_ms += inlineMs(&watch);
  if (!is_asked) return result;
  // Inline execution has the answer already; a thread has it for a later frame.
  return tryAnswer(frame, result).value_or(result);
}

std::optional<TrackedFrame> Session::Impl::tryAnswer(const Frame& frame, const TrackedFrame& lost) {
  const std::shared_ptr<const RelocalizationAnswer> answer = back_end_.answer();
  if (!answer || !answer->found || answer->t_ns <= used_answer_t_ns_) return std::nullopt;
  used_answer_t_ns_ = answer->t_ns;
  const Relocalization& found = *answer->found;
  if (frame.map->keyframe(found.keyframe) == nullptr) return std::nullopt;
  const AnchoredPose pose{found.keyframe, found.T_cam_key, found.key_scale, SE3d{}, std::nullopt};
  const IndirectGuess guess{pose.T_cam_world(*frame.map), GuessQuality::lost, found.keyframe};
  TrackedFrame tracked = indirect_.track(frame, lost.features, guess);
  if (!tracked.ok) return std::nullopt;
  tracked.switch_reason = lost.switch_reason;
  addTimes(lost.stats, &tracked.stats);
  return tracked;
}

void Session::Impl::onTracked(const Frame& frame, TrackedFrame* tracked) {
  lost_frames_ = 0;
  ++last_keyframe_->frames_since;
  if (tracked->tracker == TrackerKind::indirect) {
    if (isMapping()) {
      countSightings(*tracked);
      offerKeyframe(frame, tracked);
    }
    if (direct_) tracked->stats.precompute_ms = direct_->refreshReference(frame, *tracked);
  }
  if (reporter_) reportPoints(frame, *tracked);
  motion_.update(frame.t_ns, tracked->pose, *frame.map);
  last_pose_ = tracked->pose;
}

void Session::Impl::reportPoints(const Frame& frame, const TrackedFrame& tracked) {
  if (tracked.tracker == TrackerKind::indirect)
    reporter_->reportMatches(frame, tracked, &tracked_points_);
  if (!direct_ || config_.tracked_points != ReportPoints::on) return;
  if (tracked.tracker == TrackerKind::direct) {
    reporter_->reportAlignment(reader_.luma(), *direct_, &tracked_points_);
  } else {
    reporter_->setReference(reader_.luma(), *direct_);
  }
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
  Stopwatch watch;
  tracked->stats.keyframe = back_end_.offer(std::move(keyframe));
  tracked->stats.mapping_ms += inlineMs(&watch);
  if (!tracked->stats.keyframe) return;
  ++next_keyframe_id_;
  last_keyframe_ = LastKeyframe{id, 0};
  sightings_.clear();
  const AnchoredPose& measured = tracked->pose;
  const AnchoredPose::Support support{measured.keyframe, measured.T_cam_key, measured.key_scale};
  tracked->pose = {id, SE3d{}, 1.0, tracked->T_cam_world, support};
}

NewKeyframe Session::Impl::makeKeyframe(const Frame& frame, const TrackedFrame& tracked) {
  NewKeyframe keyframe;
  keyframe.id = KeyframeId{next_keyframe_id_};
  keyframe.t_ns = frame.t_ns;
  keyframe.features = tracked.features;
  keyframe.reference = tracked.pose.keyframe;
  keyframe.T_cam_ref = tracked.pose.T_cam_key;
  keyframe.reference_scale = tracked.pose.key_scale;
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
  const bool tiny = map()->keyframes().size() < kTinyMapKeyframes;
  const bool may_give_up = isMapping() && !is_restored_;
  if (!tiny || lost_frames_ < kLostFramesBeforeReset || !may_give_up) return;
  ++resets_;
  forgetMap();
}

std::shared_ptr<const MapSnapshot> Session::Impl::currentMap() {
  std::shared_ptr<const MapSnapshot> mapped = back_end_.snapshot();
  // Without a map of its own, too: a mapper that ran out of memory has begun another.
  const bool is_behind = mapped->generation() > generation_;
  if (is_behind || (last_keyframe_ && isStartRefused(*mapped))) giveUpStart(*mapped);
  return mapped->generation() == generation() ? mapped : no_map_;
}

void Session::Impl::forgetMap() {
  last_keyframe_.reset();
  last_pose_ = AnchoredPose{};  // it was of the world that is gone
  sightings_.clear();
  motion_.reset();
  if (direct_) direct_->dropReference();
  lost_frames_ = 0;
  tracked_points_.clear();
  used_answer_t_ns_ = last_t_ns_;  // later answers may be about a map that is gone
  is_restored_ = false;
  timeline_.store(std::make_shared<const PoseTimeline>(generation_ + 1));
  frame_map_.store(shown(no_map_, generation()));
}

FrameResult Session::Impl::pausedResult(std::int64_t t_ns) {
  const std::shared_ptr<const SnapshotMap> before = frame_map_.load();
  const std::shared_ptr<const SnapshotMap> now = shown(map(), generation());
  frame_map_.store(now);
  FrameResult result;
  result.t_ns = t_ns;
  result.state = TrackingState::paused;
  result.map_revision = now->revision();
  result.map_generation = generation();
  result.correction = correctionBetween(before->snapshot(), now->snapshot(), last_pose_);
  describePose(last_pose_, now->snapshot(), &result);
  return result;
}

FrameResult Session::Impl::toResult(const Frame& frame, const TrackedFrame& tracked) const {
  FrameResult result;
  result.t_ns = frame.t_ns;
  result.switch_reason = tracked.switch_reason;
  result.stats = tracked.stats;
  if (tracked.ok) {
    result.state = TrackingState::tracking;
    result.tracker = tracked.tracker;
    result.confidence = tracked.confidence;
    describePose(tracked.pose, *frame.map, &result);
    result.T_world_cam = toPose(tracked.T_cam_world.inverse());
  } else {
    const bool is_lost = last_keyframe_ || !isMapping();
    result.state = is_lost ? TrackingState::lost : TrackingState::initializing;
    describePose(last_pose_, *frame.map, &result);
  }
  result.map_revision = frame.map->revision();
  result.map_generation = generation();
  return result;
}

void Session::Impl::remember(const Frame& frame, const FrameResult& result) {
  if (!last_keyframe_) return;
  const bool is_tracked = result.state == TrackingState::tracking;
  timeline_.store(std::make_shared<const PoseTimeline>(
      timeline_.load()->with({frame.t_ns, is_tracked, last_pose_})));
}

double Session::Impl::inlineMs(Stopwatch* watch) const {
  return config_.execution == Execution::inline_ ? watch->lapMs() : 0.0;
}

}  // namespace glide
