#pragma once

#include "replay/app/options.h"

#include "glide/config.h"
#include "glide/result.h"

#include <memory>

namespace glide::replay {

/// Keeps a GL context current on this thread while it lives; holds none when the run needs none.
class GlBackend {
 public:
  /// A context for Backend::gles and for textures as input (unsupported when there is none), and
  /// for Backend::automatic when the machine has a GPU that one may belong to.
  static Result<GlBackend> create(Backend backend, InputKind input);

  GlBackend(GlBackend&&) noexcept;
  GlBackend& operator=(GlBackend&&) noexcept;
  ~GlBackend();

 private:
  struct Context;
  GlBackend();
  std::unique_ptr<Context> context_;
};

}  // namespace glide::replay
