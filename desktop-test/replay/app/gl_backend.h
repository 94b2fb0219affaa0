#pragma once

#include "replay/app/options.h"
#include "replay/render/viewer_window.h"

#include "glide/config.h"
#include "glide/result.h"

#include <memory>

namespace glide::replay {

/// What a replay may need a GL context for.
struct GlDemand {
  Backend backend = Backend::automatic;
  InputKind input = InputKind::luma;
  bool renders = false;     ///< --render
  bool has_viewer = false;  ///< --viewer: the context is that of a window
};

/// Keeps a GL context current on this thread while it lives; holds none when the run needs none.
class GlBackend {
 public:
  /// A context for Backend::gles, for textures as input and for pictures (unsupported, naming the
  /// option, when there is none), and for Backend::automatic when the machine has a GPU that one
  /// may belong to.
  static Result<GlBackend> create(const GlDemand& demand);

  GlBackend(GlBackend&&) noexcept;
  GlBackend& operator=(GlBackend&&) noexcept;
  ~GlBackend();

  /// What the session is to be made with: pictures alone are no reason for Backend::automatic to
  /// take the context.
  Backend sessionBackend() const { return session_backend_; }
  /// Null without --viewer.
  ViewerWindow* window();

 private:
  struct Context;
  GlBackend();
  std::unique_ptr<Context> context_;
  Backend session_backend_ = Backend::automatic;
};

}  // namespace glide::replay
