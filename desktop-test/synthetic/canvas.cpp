#include "synthetic/canvas.h"

#include "synthetic/shape_coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace glide::synthetic {

namespace {

/// One octave of white noise in -1..1.
ImageF whiteNoise(int width, int height, Random* random) {
  constexpr float kUnit = 2.0F / 65536.0F;
  ImageF noise(width, height);
  for (int y = 0; y < height; ++y) {
    float* row = noise.row(y);
    std::uint64_t bits = 0;
    for (int x = 0; x < width; ++x) {
      bits = x % 4 == 0 ? random->next() : bits >> 16;
      row[x] = static_cast<float>(bits & 0xFFFFU) * kUnit - 1.0F;
    }
  }
  return noise;
}

/// Doubles the size of an image by Chaikin's corner cutting (a quadratic B-spline), cropped to the
/// size asked for.
ImageF doubled(const ImageF& image, int width, int height) {
  const int w = image.width(), h = image.height();
  ImageF wide(width, h);
  for (int y = 0; y < h; ++y) {
    const float* in = image.row(y);
    float* out = wide.row(y);
    for (int x = 0; x < width; ++x) {
      const int near = std::min(x / 2, w - 1);
      const int far = std::clamp(near + (x % 2 == 0 ? -1 : 1), 0, w - 1);
      out[x] = 0.75F * in[near] + 0.25F * in[far];
    }
  }
  ImageF large(width, height);
  for (int y = 0; y < height; ++y) {
    const int near = std::min(y / 2, h - 1);
    const int far = std::clamp(near + (y % 2 == 0 ? -1 : 1), 0, h - 1);
    const float *a = wide.row(near), *b = wide.row(far);
    float* out = large.row(y);
    for (int x = 0; x < width; ++x) out[x] = 0.75F * a[x] + 0.25F * b[x];
  }
  return large;
}

void addScaled(const ImageF& source, float factor, ImageF* target) {
  for (int y = 0; y < target->height(); ++y) {
    const float* in = source.row(y);
    float* out = target->row(y);
    for (int x = 0; x < target->width(); ++x) out[x] += factor * in[x];
  }
}

int ceilShift(int value, int shift) { return (value + (1 << shift) - 1) >> shift; }

}  // namespace

void fill(Canvas* canvas, float value) {
  for (int y = 0; y < canvas->height(); ++y) {
    std::fill_n(canvas->albedo.row(y), canvas->width(), value);
  }
}

void draw(Canvas* canvas, const Shape& shape) {
  const auto paint = [&](int x, int y, float cover) {
    float& texel = canvas->albedo.row(y)[x];
    texel += cover * (shape.value - texel);
  };
  forEachCovered(canvas->width(), canvas->height(), shape, paint);
}

void drawRect(Canvas* canvas, const Rect& rect, float value) {
  Shape shape;
  shape.half_w = 0.5F * rect.width;
  shape.half_h = 0.5F * rect.height;
  shape.x = rect.x + shape.half_w;
  shape.y = rect.y + shape.half_h;
  shape.value = value;
  draw(canvas, shape);
}

void addNoise(Canvas* canvas, const Noise& noise, Random* random) {
  const int octaves = std::max(1, static_cast<int>(std::log2(std::max(2.0F, noise.coarsest_px))));
  const int w = canvas->width(), h = canvas->height();
  ImageF sum = whiteNoise(ceilShift(w, octaves), ceilShift(h, octaves), random);
  float weight = 1.0F;
  for (int octave = octaves - 1; octave >= 0; --octave) {
    sum = doubled(sum, ceilShift(w, octave), ceilShift(h, octave));
    weight *= noise.persistence;
    addScaled(whiteNoise(sum.width(), sum.height(), random), weight, &sum);
  }
  addScaled(sum, noise.amplitude, &canvas->albedo);
}

void strew(Canvas* canvas, const Strewing& strewing, Random* random) {
  constexpr std::array kKinds{ShapeKind::rectangle, ShapeKind::ellipse, ShapeKind::triangle};
  const Rect& region = strewing.region;
  for (float size = strewing.max_px; size >= strewing.min_px; size *= 0.5F) {
    const float count = strewing.coverage * region.width * region.height / (size * size);
    for (int i = 0; i < static_cast<int>(std::ceil(count)); ++i) {
      Shape shape;
      shape.kind = kKinds[static_cast<std::size_t>(random->below(kKinds.size()))];
      shape.x = region.x + random->uniform() * region.width;
      shape.y = region.y + random->uniform() * region.height;
      shape.half_w = 0.5F * size * random->uniform(0.6F, 1.2F);
      shape.half_h = 0.5F * size * random->uniform(0.3F, 1.0F);
      shape.angle = random->uniform(0.0F, 6.2831853F);
      shape.value = random->uniform(strewing.low, strewing.high);
      shape.opacity = strewing.opacity;
      draw(canvas, shape);
    }
  }
}

}  // namespace glide::synthetic
