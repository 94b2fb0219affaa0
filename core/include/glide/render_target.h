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
/// For pictures and videos; reading back waits for the GPU.
class GLIDE_API RenderTarget {
 public:
  /// invalid_argument when a side is not positive or more than the context can; resource_exhausted
  /// when there is no memory.
  static Result<RenderTarget> create(int width, int height);

  RenderTarget(RenderTarget&&) noexcept;
  RenderTarget& operator=(RenderTarget&&) noexcept;
  ~RenderTarget();

  int width() const;
  int height() const;

  /// Binds it for drawing and clears it to the colour. The app binds its own framebuffer again.
  void begin(const Color& background);
  /// What was drawn: rows of red, green, blue bytes, the uppermost first, no padding. Binds nothing
  /// that was not bound before.
  std::vector<std::uint8_t> readRgb();

  /// The context is gone: forgets the names without a GL call.
  void abandonGl();

 private:
  class Impl;
  explicit RenderTarget(std::unique_ptr<Impl> impl);
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
