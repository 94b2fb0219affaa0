#pragma once

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/map_view.h"
#include "glide/result.h"
#include "glide/version.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace glide {

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
  /// seconds, predicted up to 100 ms after the last frame, else not valid. Any thread.
  LocatedCamera locate(std::int64_t t_ns) const;

  /// A copy of the current map; never null. Any thread.
  std::shared_ptr<const MapView> map() const;

  /// Drops the map and starts over with the next frame; a paused session stays paused. May wait
  /// until the mapper has room for one more message.
  void reset();

  /// Until resume(), update() looks at no frame and answers TrackingState::paused; the map stays.
  /// The camera may move meanwhile: it is found again by relocalisation if need be.
  void pause();
  void resume();

  /// Frees what the session has in the GL context, which is current: before an app gives its
  /// context away. The map stays; the next update() chooses the backend anew, in the context that
  /// is current then (any context, any driver), and tracking goes on: the frame is placed by the
  /// indirect tracker. Without a context, like abandonGl(). Nothing with Backend::cpu.
  void releaseGl();
  /// The same when the context is gone or lost: forgets the GL names without a GL call.
  void abandonGl();

  /// Writes the map as it is now to `path`, under a temporary name first: the file is whole or not
  /// there. Format: docs/map-format.md. io when it cannot be written. A map without keyframes is
  /// written, too, but loadMap refuses it. Any thread; does not hold up update().
  Status saveMap(const std::filesystem::path& path) const;
  /// The bytes that saveMap would write. Any thread.
  Result<std::vector<std::byte>> saveMap() const;

  /// Takes the place of the present map; the camera is lost until it is recognised in it, and poses
  /// are in the loaded map's frame from then on. Waits until the mapper has taken it over. io when
  /// the file cannot be read, invalid_data or unknown_version when it is no map that this library
  /// reads, invalid_argument when it was made with another camera or other feature levels; then
  /// nothing is changed.
  Status loadMap(const std::filesystem::path& path);
  Status loadMap(std::span<const std::byte> bytes);

  /// Blocks until every keyframe handed over so far is mapped, and loops that this closed are
  /// worked in (offline use: lossless replay).
  void waitForMapping();

  /// As of the last update(), which may replace it.
  const BackendInfo& backend() const;

 private:
  class Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
