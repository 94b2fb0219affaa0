#pragma once

#include "glide/config.h"
#include "glide/result.h"

#include <memory>

namespace glide::replay {

/// Keeps a GL context current on this thread while it lives; holds none when the run needs none.
class GlBackend {
 public:
  /// A context for Backend::gles (unsupported when there is none), and for Backend::automatic when
  /// the machine has a GPU that one may belong to.
  static Result<GlBackend> create(Backend backend);

  GlBackend(GlBackend&&) noexcept;
  GlBackend& operator=(GlBackend&&) noexcept;
  ~GlBackend();

 private:
  struct Context;
  GlBackend();
  std::unique_ptr<Context> context_;
};

}  // namespace glide::replay
