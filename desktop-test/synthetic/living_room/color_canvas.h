#pragma once

#include "synthetic/canvas.h"
#include "synthetic/texture.h"

#include <cstdint>
#include <functional>
#include <span>

namespace glide::synthetic {

/// Red, green and blue as a screen shows them (gamma-encoded), 0..1.
using Rgb = Vec3f;

/// 0xRRGGBB
inline Rgb hex(std::uint32_t code) {
  constexpr float kUnit = 1.0F / 255.0F;
  return kUnit * Rgb(static_cast<float>(code >> 16 & 0xFFU),
                     static_cast<float>(code >> 8 & 0xFFU),
                     static_cast<float>(code & 0xFFU));
}

inline Rgb mix(const Rgb& a, const Rgb& b, float share_b) { return a + share_b * (b - a); }

/// One of them.
inline Rgb pick(std::span<const Rgb> colors, Random* random) {
  return colors[static_cast<std::size_t>(random->below(static_cast<int>(colors.size())))];
}

/// What a rectangular surface looks like in white light, while it is being painted.
struct ColorCanvas {
  ImageRgb color;
  float texels_per_m = 1.0F;

  int width() const { return color.width(); }
  int height() const { return color.height(); }
  /// Metres to texels.
  float px(float metres) const { return metres * texels_per_m; }
  Rect whole() const {
    return {0.0F, 0.0F, static_cast<float>(width()), static_cast<float>(height())};
  }
};

/// Paints a whole canvas.
using Painter = std::function<void(ColorCanvas*, Random*)>;

void fill(ColorCanvas* canvas, const Rgb& color);
/// Shape::value is not looked at.
void draw(ColorCanvas* canvas, const Shape& shape, const Rgb& color);
void drawRect(ColorCanvas* canvas, const Rect& rect, const Rgb& color);

/// A shape about a point; everything in texels and radians.
Shape shapeAt(ShapeKind kind, const Vec2f& center, const Vec2f& half_size);

/// Lightens and darkens by noise: `noise.amplitude` is a share of the brightness.
void mottle(ColorCanvas* canvas, const Noise& noise, Random* random);

/// Draws in metres from the canvas's first corner.
class Pen {
 public:
  explicit Pen(ColorCanvas* canvas) : canvas_(canvas) {}

  float width() const { return static_cast<float>(canvas_->width()) / canvas_->texels_per_m; }
  float height() const { return static_cast<float>(canvas_->height()) / canvas_->texels_per_m; }

  void rect(const Rect& rect, const Rgb& color);
  void oval(const Vec2f& center, const Vec2f& radii, const Rgb& color);
  /// A rectangle around the line, or an ellipse of that length and breadth.
  void line(const Vec2f& from, const Vec2f& to, float breadth, const Rgb& color);
  void petal(const Vec2f& from, const Vec2f& to, float breadth, const Rgb& color);
  /// Standing on its base.
  void triangle(const Vec2f& center, const Vec2f& half_size, const Rgb& color);

 private:
  void stroke(ShapeKind kind, const Vec2f& from, const Vec2f& to, float breadth, const Rgb& color);

  ColorCanvas* canvas_;
};

/// Multiplies what is there.
void tint(ColorCanvas* canvas, const Rect& rect, const Rgb& factor);

/// From the first row's colour to the last row's.
void fillDown(ColorCanvas* canvas, const Rect& rect, const Rgb& top, const Rgb& bottom);

}  // namespace glide::synthetic
