#pragma once

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/map_view.h"
#include "glide/result.h"
#include "glide/version.h"

#include <memory>
#include <string>

namespace glide {

/// Which device does the direct tracking.
struct BackendInfo {
  Backend backend = Backend::cpu;         ///< never automatic
  std::string vendor, renderer, version;  ///< of the GL, empty on the CPU
};

/// Monocular SLAM: frames in, poses out. One thread calls update(); when the backend is gles, that
/// thread has the same GL context current at create(), every update() and destruction.
class GLIDE_API Session {
 public:
  /// Checks the config (validate) and, for Backend::gles, the current context.
  static Result<Session> create(const Config& config);

  Session(Session&&) noexcept;
  Session& operator=(Session&&) noexcept;
  ~Session();

  /// Tracks one frame. Never waits for mapping unless Execution::inline_. A wrong image size, null
  /// pixels or a timestamp that does not increase is invalid_argument and changes nothing.
  Result<FrameResult> update(const FrameInput& frame);

  /// A copy of the current map; never null.
  std::shared_ptr<const MapView> map() const;

  /// Blocks until every keyframe handed over so far is mapped (offline use: lossless replay).
  void waitForMapping();

  BackendInfo backend() const;

 private:
  class Impl;
  explicit Session(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
