#pragma once

#include "replay/outputs/run_record.h"

#include <cstdint>
#include <memory>

namespace glide::replay {

/// A run of hand-made frames 100 ms apart.
class RunFixture {
 public:
  RunFixture() {
    run.map = map_;
    run.source = {"tum", "/data/desk", "desk", 6, 6, 640, 480};
    run.config.camera = {640, 480, 500, 500, 319.5, 239.5, DistortionModel::none, {}};
  }

  void add(TrackingState state, TrackerKind tracker) {
    FrameRecord record;
    record.index = static_cast<int>(run.frames.size());
    record.result.t_ns = record.index * std::int64_t{100'000'000};
    record.result.state = state;
    record.result.tracker = tracker;
    record.result.stats.update_ms = 1.0 + record.index;
    run.frames.push_back(record);
  }
  void addInitializing() { add(TrackingState::initializing, TrackerKind::none); }
  void addLost() { add(TrackingState::lost, TrackerKind::none); }
  void addTracked(TrackerKind tracker, std::uint64_t reference) {
    add(TrackingState::tracking, tracker);
    run.frames.back().result.reference_keyframe = reference;
  }
  /// A keyframe that stands at x in the final map.
  void addKeyframe(std::uint64_t id, double x, bool retired) {
    MapView::Keyframe keyframe;
    keyframe.id = id;
    keyframe.t_ns = static_cast<std::int64_t>(id);
    keyframe.T_world_cam.t_xyz = {x, 0, 0};
    keyframe.retired = retired;
    map_->keyframes.push_back(keyframe);
  }
  MapView& map() { return *map_; }

  RunRecord run;

 private:
  std::shared_ptr<MapView> map_ = std::make_shared<MapView>();
};

}  // namespace glide::replay
