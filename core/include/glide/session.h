#pragma once

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/frame_map.h"
#include "glide/map_view.h"
#include "glide/result.h"
#include "glide/version.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace glide {

struct StoredMap;  // of the library

/// Which device does the direct tracking.
struct BackendInfo {
  Backend backend = Backend::cpu;         ///< never automatic
  std::string vendor, renderer, version;  ///< of the GL, empty on the CPU
  StageTimer timer = StageTimer::cpu;
};

/// Monocular SLAM: frames in, poses out. One thread calls update() and everything else that is not
/// marked "any thread"; when the backend is gles, that thread has the same GL context, or one that
/// shares objects with it, current at create(), every update(), releaseGl() and destruction
/// (docs/gl-contract.md). In a context that does not share, update() builds its GL objects anew.
class GLIDE_API Session {
 public:
  /// Checks the config (validate) and, for Backend::gles, the current context (unless
  /// Config::gl.creation says later).
  static Result<Session> create(const Config& config);

  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// Tracks one frame (docs/inputs.md: what it may be). Never waits for mapping unless
  /// Execution::inline_. A wrong image size or null pixels is invalid_argument, a timestamp that
  /// does not increase out_of_order; neither changes anything.
  Result<FrameResult> update(const FrameInput& frame);

  /// Where the camera was at `t_ns` (the clock of FrameInput): interpolated within the last few
  /// seconds, predicted up to 100 ms after the last frame, else not valid; in frameMap(). Any
  /// thread.
  LocatedCamera locate(std::int64_t t_ns) const;

  /// The current map, never null: a copy, shared by who asks before there is a new revision. Empty
  /// from reset(), or a start that is given up, until there is a new map. Any thread.
  std::shared_ptr<const MapView> map() const;

  /// The map that the last update() tracked its frame in, never null: with the pose of the frame,
  /// it is one world, while map() may be corrected already. Empty like map(). Any thread.
  std::shared_ptr<const FrameMap> frameMap() const;

  /// How large the current map is, without a copy of it. Any thread.
  MapSize mapSize() const;

  /// Drops the map and starts over with the next frame; a paused session stays paused.
  void reset();

  /// Until resume(), update() looks at no frame and answers TrackingState::paused; the map stays.
  /// The camera may move meanwhile: it is found again by relocalisation if need be.
  void pause();
  void resume();

  /// Frees what the session has in the GL context, which is current: before an app gives its
  /// context away. The map stays; the next update() chooses the backend anew, in the context that
  /// is current then (any context, any driver), and tracking goes on: the frame is placed by the
  /// indirect tracker. Without a context, like abandonGl(). Nothing with Backend::cpu and pixels.
  void releaseGl();
  /// The same when the context is gone or lost: forgets the GL names without a GL call.
  void abandonGl();

  /// Writes the map as it is now to `path`, under a temporary name first: the file is whole or not
  /// there. Format: docs/map-format.md. io when it cannot be written, no_map while there is
  /// none: then a file that is there stays as it is. Any thread; does not hold up update().
  Status saveMap(const std::filesystem::path& path) const;
  /// The bytes that saveMap would write. Any thread.
  Result<std::vector<std::byte>> saveMap() const;

  /// A map file that was read: what takes long about loading and needs no session. Any thread.
  class GLIDE_API MapFile {
   public:
    /// io when the file cannot be read, invalid_data or unknown_version when it is no map that this
    /// library reads.
    static Result<MapFile> read(const std::filesystem::path& path);
    static Result<MapFile> decode(std::span<const std::byte> bytes);

   private:
    friend class Session;
    explicit MapFile(std::shared_ptr<const StoredMap> stored) : stored_(std::move(stored)) {}
    std::shared_ptr<const StoredMap> stored_;
  };
  /// Takes the place of the present map; the camera is lost until it is recognised in it, and poses
  /// are in the loaded map's frame from then on. invalid_argument when the map was made with
  /// another camera or other feature levels; then nothing is changed. Does not wait: map() is empty
  /// until the mapper has taken it over (waitForMapping).
  Status takeMap(const MapFile& file);
  /// Reads, takes and waits; errors as of MapFile and takeMap.
  Status loadMap(const std::filesystem::path& path);
  Status loadMap(std::span<const std::byte> bytes);

  /// Blocks until every keyframe handed over so far is mapped, and loops that this closed are
  /// worked in (offline use: lossless replay). What update() hands over meanwhile is not waited
  /// for; it may put off the adjustment of the whole map after a loop. Any thread; does not hold up
  /// update().
  void waitForMapping();

  /// As of the last update(), which may replace it.
  const BackendInfo& backend() const;

  /// The landmarks that the last update() tracked the frame by: for pictures, not for tracking.
  /// Empty unless the frame was tracked and Config::tracked_points wants them, and for the frame
  /// that starts a map. Changes with the next update(), reset() or loadMap().
  const std::vector<TrackedPoint>& trackedPoints() const;

 private:
  class Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
