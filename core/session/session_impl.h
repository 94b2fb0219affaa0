#pragma once

#include "session/aligner_factory.h"
#include "session/mapping_thread.h"
#include "track/direct_tracker.h"
#include "track/indirect_tracker.h"
#include "track/initializer.h"
#include "track/motion_model.h"

#include "glide/session.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>

namespace glide {

/// The trackers and the mapper of one session. Belongs to the thread that calls update(), but for
/// snapshot() and resets(), which any thread may call.
class Session::Impl {
 public:
  Impl(const Config& config, const CameraModel& camera, ChosenAligner aligner);

  /// invalid_argument naming what is wrong with the input.
  Status check(const FrameInput& input) const;
  FrameResult update(const FrameInput& input);

  std::shared_ptr<const MapSnapshot> snapshot() const { return mapping_.snapshot(); }
  std::uint64_t resets() const { return resets_.load(); }
  void waitForMapping() { mapping_.waitIdle(); }
  const BackendInfo& backend() const { return backend_; }

 private:
  /// The keyframe that the tracker made last.
  struct LastKeyframe {
    KeyframeId id;
    int frames_since = 0;
  };

  FrameResult initialize(const Frame& frame);
  void startMap(const Frame& frame, InitialMap start, TrackedFrame* tracked);
  /// The mapper has not published the map that was started last.
  bool isMapPending(const Frame& frame) const;
  FrameResult waitForMap(const Frame& frame) const;
  FrameResult track(const Frame& frame);
  TrackedFrame trackDirect(const Frame& frame, const SE3d& T_cam_world_guess);
  TrackedFrame trackIndirect(const Frame& frame, const TrackedFrame& direct);
  void onTracked(const Frame& frame, TrackedFrame* tracked);
  void offerKeyframe(const Frame& frame, TrackedFrame* tracked);
  void onLost();
  void countSightings(const TrackedFrame& tracked);
  NewKeyframe makeKeyframe(const Frame& frame, const TrackedFrame& tracked);
  FrameResult toResult(const Frame& frame, const TrackedFrame& tracked) const;

  const Config config_;
  const CameraModel camera_;
  const BackendInfo backend_;
  MappingThread mapping_;
  std::atomic<std::uint64_t> resets_{0};

  // The thread of update().
  std::optional<DirectTracker> direct_;  ///< none in TrackerMode::indirect
  IndirectTracker indirect_;
  Initializer initializer_;
  MotionModel motion_;
  std::optional<LastKeyframe> last_keyframe_;  ///< none before a map is started
  KeyframeId map_start_;                       ///< first keyframe of that map
  AnchoredPose last_pose_;
  std::int64_t last_t_ns_;
  std::uint64_t next_keyframe_id_ = 0;
  int lost_frames_ = 0;
  std::unordered_map<LandmarkId, LandmarkSighting> sightings_;  ///< since the last keyframe
};

}  // namespace glide
