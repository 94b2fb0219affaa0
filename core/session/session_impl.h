#pragma once

#include "session/aligner_factory.h"
#include "session/back_end.h"
#include "session/frame_reader.h"
#include "session/pose_timeline.h"
#include "session/snapshot_map.h"
#include "track/direct_tracker.h"
#include "track/indirect_tracker.h"
#include "track/initializer.h"
#include "track/motion_model.h"
#include "track/point_reporter.h"

#include "map/map_io.h"

#include "base/stopwatch.h"

#include "glide/session.h"

#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <unordered_map>
#include <vector>

namespace glide {

/// The trackers and the back end of one session. Belongs to the thread that calls update(), but for
/// view(), frameMap(), map(), stored(), locate() and waitForMapping(), which any thread may call.
class Session::Impl {
 public:
  Impl(const Config& config, const CameraModel& camera, ChosenAligner aligner);

  /// Takes the input for the next update; an error that names what is wrong with it changes
  /// nothing.
  Status take(const FrameInput& input);
  FrameResult update(const FrameInput& input);

  void reset();
  void pause();
  void resume();
  /// The next take() chooses the aligner anew.
  void releaseGl();
  void abandonGl();
  /// Takes a map from a file, without waiting until the mapper has; invalid_argument when it was
  /// made with another camera.
  Status restore(const StoredMap& stored);

  /// The map as it is to be seen: empty from the moment at which another is to take its place until
  /// the mapper has published that.
  std::shared_ptr<const MapSnapshot> map() const { return mapOf(generation()); }
  /// A copy of map(), the same one until there is a new revision.
  std::shared_ptr<const MapView> view() const;
  std::shared_ptr<const FrameMap> frameMap() const { return frame_map_.load(); }
  StoredMap stored() const;
  LocatedCamera locate(std::int64_t t_ns) const;

  void waitForMapping() { back_end_.waitIdle(); }
  const BackendInfo& backend() const { return backend_; }
  const std::vector<TrackedPoint>& trackedPoints() const { return tracked_points_; }

 private:
  /// The keyframe that the tracker made last.
  struct LastKeyframe {
    KeyframeId id;
    int frames_since = 0;
  };

  /// Makes another aligner when the one that was is not usable (released, abandoned, or its context
  /// is not the current one). An error changes nothing.
  Status ensureAligner();
  bool isMapping() const { return config_.mode == SessionMode::slam; }
  /// These put the map that the result is of into the frame: the one that it starts, or none.
  FrameResult initialize(Frame* frame);
  void startMap(InitialMap start, Frame* frame, TrackedFrame* tracked);
  /// Of the map to be seen, or to be started next.
  std::uint64_t generation() const { return timeline_.load()->generation(); }
  /// What the mapper has published when it is of this generation, else an empty map.
  std::shared_ptr<const MapSnapshot> mapOf(std::uint64_t generation) const;
  /// The mapper found that the two views of the start are no geometry, or ran out of memory and
  /// began anew: there is no map to track in.
  bool isStartRefused(const MapSnapshot& map) const;
  void giveUpStart(const MapSnapshot& map);
  /// The mapper has not published the map that was started or loaded last.
  bool isMapPending(const Frame& frame) const { return frame.map->generation() < generation_; }
  FrameResult waitForMap(const Frame& frame) const;
  FrameResult track(Frame* frame);
  TrackedFrame trackDirect(const Frame& frame, const SE3d& T_cam_world_guess);
  TrackedFrame trackIndirect(const Frame& frame, const TrackedFrame& direct);
  /// Asks the loop thread where the frame is, and tries its last answer.
  TrackedFrame relocalize(const Frame& frame, const TrackedFrame& lost);
  std::optional<TrackedFrame> tryAnswer(const Frame& frame, const TrackedFrame& lost);
  void onTracked(const Frame& frame, TrackedFrame* tracked);
  void offerKeyframe(const Frame& frame, TrackedFrame* tracked);
  void reportPoints(const Frame& frame, const TrackedFrame& tracked);
  void onLost();
  /// The map for the next frame; a start that the mapper refused is given up.
  std::shared_ptr<const MapSnapshot> currentMap();
  void forgetMap();
  /// A snapshot to look at; the same one until there is a new revision.
  std::shared_ptr<const SnapshotMap> shown(const std::shared_ptr<const MapSnapshot>& map,
                                           std::uint64_t generation) const;
  void countSightings(const TrackedFrame& tracked);
  NewKeyframe makeKeyframe(const Frame& frame, const TrackedFrame& tracked);
  FrameResult pausedResult(std::int64_t t_ns);
  FrameResult toResult(const Frame& frame, const TrackedFrame& tracked) const;
  /// For locate().
  void remember(const Frame& frame, const FrameResult& result);
  /// Time since the last lap when the back end works inside update(), else zero.
  double inlineMs(Stopwatch* watch) const;

  // Any thread.
  const Config config_;
  const CameraModel camera_;
  BackEnd back_end_;
  std::atomic<std::uint64_t> resets_{0};
  const std::shared_ptr<const MapSnapshot> no_map_;
  Published<PoseTimeline> timeline_;
  Published<SnapshotMap> frame_map_;
  mutable Published<SnapshotMap> newest_map_;  ///< of those that shown() has made

  // The thread of update().
  BackendInfo backend_;
  std::optional<DirectTracker> direct_;  ///< none in TrackerMode::indirect
  IndirectTracker indirect_;
  Initializer initializer_;
  FrameReader reader_;
  std::optional<PointReporter> reporter_;  ///< unless Config::tracked_points is off
  std::vector<TrackedPoint> tracked_points_;
  MotionModel motion_;
  std::optional<LastKeyframe> last_keyframe_;  ///< none before there is a map
  KeyframeId map_start_;                       ///< first keyframe of that map
  AnchoredPose last_pose_;
  std::int64_t last_t_ns_;
  std::int64_t used_answer_t_ns_;  ///< of the relocalisation that was tried last
  std::uint64_t next_keyframe_id_ = 0;
  std::uint64_t generation_ = 0;  ///< of the newest map that was asked for
  int lost_frames_ = 0;
  bool is_paused_ = false;
  bool is_restored_ = false;  ///< the map came from a file: it is never given up
  std::unordered_map<LandmarkId, LandmarkSighting> sightings_;  ///< since the last keyframe
};

}  // namespace glide
