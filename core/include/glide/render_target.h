#pragma once

#include "glide/config.h"
#include "glide/render_types.h"
#include "glide/result.h"
#include "glide/version.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace glide {

/// A framebuffer without a window: colour (RGBA8, multisampled where the context can) and depth.
/// For pictures and videos; reading back waits for the GPU. Every call but abandonGl() is made with
/// a context of OpenGL ES 3.1 current. Another one than before gets a framebuffer of its own, and
/// what was drawn is gone. The state of the context stays, whatever it is, but for what begin()
/// binds.
class GLIDE_API RenderTarget {
 public:
  /// invalid_argument when a side is not positive or more than the context can; gl when there is
  /// no memory; missing_context and unsupported as GL contexts are.
  static Result<RenderTarget> create(int width, int height);

  RenderTarget(RenderTarget&&) noexcept;
  RenderTarget& operator=(RenderTarget&&) noexcept;
  ~RenderTarget();

  int width() const;
  int height() const;

  /// Binds it for drawing (GL_DRAW_FRAMEBUFFER) and clears it to the colour. The app binds its own
  /// framebuffer again. Errors as of create(), in a context that has nothing of it yet or where
  /// none is current; then what was bound stays bound.
  Status begin(const Color& background);
  /// What was drawn: rows of red, green, blue bytes, the uppermost first, no padding. What is bound
  /// stays bound. Empty when the current context is not the one in which begin() succeeded last, or
  /// there is none.
  std::vector<std::uint8_t> readRgb();

  /// The context is gone: forgets the names without a GL call.
  void abandonGl();

 private:
  class Impl;
  explicit RenderTarget(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
