#pragma once

#include "synthetic/random.h"

#include "image/image.h"

namespace glide::synthetic {

/// Reflectance 0..1 of a rectangular surface while it is being painted.
struct Canvas {
  ImageF albedo;
  float texels_per_m = 1.0F;

  int width() const { return albedo.width(); }
  int height() const { return albedo.height(); }
  /// Metres to texels.
  float px(float metres) const { return metres * texels_per_m; }
};

enum class ShapeKind { rectangle, ellipse, triangle };

/// A figure with a sharp, anti-aliased outline.
struct Shape {
  ShapeKind kind = ShapeKind::rectangle;
  float x = 0.0F, y = 0.0F;            ///< centre, texels
  float half_w = 1.0F, half_h = 1.0F;  ///< texels
  float angle = 0.0F;                  ///< radians
  float value = 0.0F;                  ///< reflectance
  float opacity = 1.0F;
};

/// An axis-aligned region in texels.
struct Rect {
  float x = 0.0F, y = 0.0F, width = 0.0F, height = 0.0F;
};

void fill(Canvas* canvas, float value);
void draw(Canvas* canvas, const Shape& shape);
void drawRect(Canvas* canvas, const Rect& rect, float value);

/// Adds noise of all wavelengths from `coarsest_px` down to one texel; each octave has
/// `persistence` times the amplitude of the coarser one.
struct Noise {
  float amplitude = 0.1F;
  float coarsest_px = 256.0F;
  float persistence = 0.7F;
};
void addNoise(Canvas* canvas, const Noise& noise, Random* random);

/// Strews figures of random kind over a region; their sizes are spread evenly over the scales, and
/// small ones are as many more as they cover less.
struct Strewing {
  Rect region;
  float min_px = 4.0F, max_px = 64.0F;  ///< diameter
  float coverage = 0.5F;          ///< area of the figures over the area of the region, per octave
  float low = 0.1F, high = 0.9F;  ///< reflectance
  float opacity = 1.0F;
};
void strew(Canvas* canvas, const Strewing& strewing, Random* random);

}  // namespace glide::synthetic
