#include "report/samples/sample_runs.h"

#include "report/samples/sample_room.h"

#include "geometry/lie.h"

#include <cmath>
#include <cstdint>
#include <memory>
#include <utility>

namespace glide::replay {
namespace {

constexpr int kTourFrames = 260, kFirstTracked = 14;
constexpr int kFramesPerKeyframe = 9;
constexpr int kLostFrom = 150, kLostTo = 158;
constexpr int kDroppedAt = 90, kDropped = 6;
constexpr std::int64_t kPeriodNs = 50'000'000;
constexpr std::int64_t kStartNs = 1'403'636'584'763'555'584;
constexpr SwitchReason kReasons[] = {SwitchReason::baseline,
                                     SwitchReason::rotation,
                                     SwitchReason::too_few_visible,
                                     SwitchReason::photometric_error,
                                     SwitchReason::max_direct_frames};

Pose toPose(const SE3d& T) {
  return {{T.t.x(), T.t.y(), T.t.z()}, {T.q.x(), T.q.y(), T.q.z(), T.q.w()}};
}

RunRecord newRun(const std::string& name, int frames) {
  RunRecord run;
  run.source = {"tum", "/data/" + name, name, frames, frames, 480, 300};
  run.config.camera = sampleCamera();
  run.map = std::make_shared<MapView>();
  run.startup_ms = 21.0;
  run.wall_s = 4.2;
  return run;
}

FrameRecord frameAt(int i, TrackingState state) {
  FrameRecord record;
  record.index = i < kDroppedAt ? i : i + kDropped;
  record.result.t_ns = kStartNs + record.index * kPeriodNs;
  record.result.state = state;
  record.result.stats.update_ms = 9.0 + 2.0 * std::sin(0.4 * i);
  record.result.stats.features_ms = 6.0;
  return record;
}

void fillDirect(int i, FrameResult* frame) {
  FrameStats& stats = frame->stats;
  frame->tracker = TrackerKind::direct;
  stats.pyramid_ms = 0.5 + 0.1 * std::sin(0.9 * i);
  stats.precompute_ms = i % 5 == 0 ? 0.6 : 0.0;
  stats.align_ms = 1.2 + 0.5 * std::sin(0.23 * i);
  stats.features_ms = 0.0;
  stats.update_ms = stats.pyramid_ms + stats.precompute_ms + stats.align_ms + 0.2;
  stats.rms = 6.0 + std::sin(0.1 * i);
}

void fillIndirect(int i, FrameResult* frame) {
  FrameStats& stats = frame->stats;
  frame->tracker = TrackerKind::indirect;
  frame->switch_reason = kReasons[(i / 6) % 5];
  stats.pyramid_ms = 0.5;
  stats.align_ms = 0.9;
  stats.match_ms = 1.4 + 0.4 * std::sin(0.7 * i);
  stats.pose_ms = 0.8;
  stats.update_ms = 10.2 + 1.6 * std::sin(0.31 * i);
  stats.rms = 0.7;
}

/// Which frames go to the indirect tracker: one of six, and a stretch without a break.
bool isIndirect(int i) { return i == kFirstTracked || i % 6 == 0 || (i > 190 && i < 200); }

FrameRecord tourFrame(int i, const std::vector<SE3d>& poses, int key) {
  if (i < kFirstTracked) return frameAt(i, TrackingState::initializing);
  if (i >= kLostFrom && i < kLostTo) {
    FrameRecord lost = frameAt(i, TrackingState::lost);
    lost.result.switch_reason = SwitchReason::too_few_visible;
    return lost;
  }
  FrameRecord record = frameAt(i, TrackingState::tracking);
  FrameResult& frame = record.result;
  if (isIndirect(i)) {
    fillIndirect(i, &frame);
  } else {
    fillDirect(i, &frame);
  }
  frame.stats.visible = 320 + static_cast<int>(90 * std::sin(0.05 * i));
  frame.stats.inliers = frame.stats.visible - 30 - static_cast<int>(25 * std::sin(0.33 * i));
  frame.stats.keyframe = i % kFramesPerKeyframe == 0;
  frame.reference_keyframe = static_cast<std::uint64_t>(key);
  const auto at = [&](int frame_index) { return poses[static_cast<std::size_t>(frame_index)]; };
  frame.T_ref_cam = toPose(at(key).inverse() * at(i));
  frame.T_world_cam = toPose(at(i));
  return record;
}

/// The tour with a slow drift, turned, moved and at 1.7 m per unit of the map.
Trajectory driftedTruth(const RunRecord& run, const std::vector<SE3d>& poses) {
  const SE3d T_truth_world{so3Exp(Vec3d(0.4, 1.0, -0.2)), Vec3d(3, -2, 1)};
  constexpr double kMetersPerUnit = 1.7, kDrift = 0.02;
  Trajectory truth;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    SE3d pose = poses[i];
    const double phase = 0.035 * static_cast<double>(i);
    pose.t += kDrift * Vec3d(std::sin(phase), 0.5 * std::cos(2 * phase), std::cos(phase));
    pose.t *= kMetersPerUnit;
    truth.push_back({run.frames[i].result.t_ns, T_truth_world * pose});
  }
  return truth;
}

void addPictures(const std::vector<SE3d>& poses, SampleRun* sample) {
  constexpr std::size_t kStride = 6;
  for (std::size_t i = 0; i < poses.size(); ++i) {
    const bool is_keyframe = sample->run.frames[i].result.stats.keyframe;
    if (!is_keyframe && i % kStride != 0) continue;
    const SampleView view = sampleView(sample->run.map->landmarks, poses[i]);
    sample->pictures.push_back({i, is_keyframe, thumbnailJpeg(view.frame)});
    sample->colors.add(sample->run.map->generation, view.frame, view.points);
  }
}

}  // namespace

SampleRun sampleTour() {
  const std::vector<SE3d> poses = sampleTourPoses(kTourFrames);
  SampleRun sample;
  sample.run = newRun("</script><script>alert(\"tour\")</script>", kTourFrames);
  sample.run.pace = Pace::realtime;
  sample.run.dropped = kDropped;
  sample.run.skips.push_back({"images are truncated", 2, "rgb/<b>17</b>.png"});
  auto map = std::make_shared<MapView>();
  map->landmarks = sampleRoom();
  int key = 0;
  for (int i = 0; i < kTourFrames; ++i) {
    const bool is_key = i == 0 || (i > kFirstTracked && i % kFramesPerKeyframe == 0);
    if (is_key && (i < kLostFrom || i >= kLostTo)) key = i;
    sample.run.frames.push_back(tourFrame(i, poses, key));
    if (key != i) continue;
    MapView::Keyframe keyframe;
    keyframe.id = static_cast<std::uint64_t>(i);
    keyframe.t_ns = sample.run.frames.back().result.t_ns;
    keyframe.T_world_cam = toPose(poses[static_cast<std::size_t>(i)]);
    map->keyframes.push_back(keyframe);
  }
  map->loops = {{map->keyframes.back().id, 0}, {252, 18}};
  sample.run.map = map;
  sample.truth = driftedTruth(sample.run, poses);
  addPictures(poses, &sample);
  return sample;
}

SampleRun sampleWithoutMap() {
  constexpr int kFrames = 20;
  SampleRun sample;
  sample.run = newRun("turning", kFrames);
  for (int i = 0; i < kFrames; ++i) {
    FrameRecord frame = frameAt(i, TrackingState::initializing);
    frame.result.initialization.status = InitializationStatus::pure_rotation;
    sample.run.frames.push_back(frame);
  }
  return sample;
}

SampleRun sampleGivenUp() {
  SampleRun sample = sampleWithoutMap();
  sample.run.source.name = "given up";
  for (std::size_t i = 5; i < 10; ++i) {
    sample.run.frames[i].result.state = TrackingState::tracking;
    fillDirect(static_cast<int>(i), &sample.run.frames[i].result);
  }
  return sample;
}

SampleRun sampleWithoutFrames() { return {newRun("empty", 0), std::nullopt, {}, {}}; }

}  // namespace glide::replay
