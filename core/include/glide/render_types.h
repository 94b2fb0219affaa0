#pragma once

#include "glide/frame.h"
#include "glide/types.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <variant>

namespace glide {

/// A 4x4 matrix as OpenGL takes it: column-major.
using Matrix4 = std::array<float, 16>;

/// Red, green, blue and alpha from 0 to 1, not premultiplied.
using Color = std::array<float, 4>;

/// Part of the framebuffer that is bound when a renderer draws, in px from its lower left corner.
/// Nothing outside is touched; what is inside is drawn over, not cleared.
struct Viewport {
  int x = 0, y = 0;
  int width = 0, height = 0;
};

/// From where a scene is seen. `view` maps points of the map's world (docs/conventions.md: OpenCV
/// axes, x right, y down, z forward of the first keyframe) to OpenGL's eye axes (x right, y up, -z
/// forward); `projection` maps these to clip space.
struct ViewCamera {
  Matrix4 view{};
  Matrix4 projection{};
};

/// A colour image that the caller owns: rows of red, green, blue bytes, the uppermost first.
struct Rgb {
  const std::uint8_t* pixels = nullptr;
  int width = 0;              ///< px
  int height = 0;             ///< px
  std::ptrdiff_t stride = 0;  ///< bytes from one row to the next, at least 3 * width
};

/// A camera image as a picture: pixels, or a texture as Session::update takes it. Read only during
/// the call.
using Picture = std::variant<Luma, Rgb, Texture>;

/// What the public colours mean everywhere (renderers, report): safe for the colour-blind.
inline constexpr Color kDirectColor{1.0F, 0.549F, 0.0F, 1.0F};      ///< orange: direct frames
inline constexpr Color kIndirectColor{0.0F, 0.271F, 0.667F, 1.0F};  ///< dark blue: indirect frames
inline constexpr Color kLoopColor{0.835F, 0.078F, 0.471F, 1.0F};    ///< magenta: loop edges
inline constexpr Color kTruthColor{0.0F, 0.588F, 0.412F, 1.0F};     ///< green: ground truth

}  // namespace glide
