#include "synthetic/living_room/color_canvas.h"

#include "synthetic/shape_coverage.h"

#include <algorithm>
#include <cmath>

namespace glide::synthetic {

void fill(ColorCanvas* canvas, const Rgb& color) {
  for (int y = 0; y < canvas->height(); ++y)
    std::fill_n(canvas->color.row(y), canvas->width(), color);
}

void draw(ColorCanvas* canvas, const Shape& shape, const Rgb& color) {
  const auto paint = [&](int x, int y, float cover) {
    Rgb& texel = canvas->color.row(y)[x];
    texel += cover * (color - texel);
  };
  forEachCovered(canvas->width(), canvas->height(), shape, paint);
}

Shape shapeAt(ShapeKind kind, const Vec2f& center, const Vec2f& half_size) {
  Shape shape;
  shape.kind = kind;
  shape.x = center.x();
  shape.y = center.y();
  shape.half_w = half_size.x();
  shape.half_h = half_size.y();
  return shape;
}

void drawRect(ColorCanvas* canvas, const Rect& rect, const Rgb& color) {
  const Vec2f half(0.5F * rect.width, 0.5F * rect.height);
  draw(canvas, shapeAt(ShapeKind::rectangle, Vec2f(rect.x, rect.y) + half, half), color);
}

void Pen::rect(const Rect& rect, const Rgb& color) {
  const float k = canvas_->texels_per_m;
  drawRect(canvas_, {k * rect.x, k * rect.y, k * rect.width, k * rect.height}, color);
}

void Pen::oval(const Vec2f& center, const Vec2f& radii, const Rgb& color) {
  const float k = canvas_->texels_per_m;
  draw(canvas_, shapeAt(ShapeKind::ellipse, k * center, k * radii), color);
}

void Pen::triangle(const Vec2f& center, const Vec2f& half_size, const Rgb& color) {
  const float k = canvas_->texels_per_m;
  draw(canvas_, shapeAt(ShapeKind::triangle, k * center, k * half_size), color);
}

void Pen::line(const Vec2f& from, const Vec2f& to, float breadth, const Rgb& color) {
  stroke(ShapeKind::rectangle, from, to, breadth, color);
}

void Pen::petal(const Vec2f& from, const Vec2f& to, float breadth, const Rgb& color) {
  stroke(ShapeKind::ellipse, from, to, breadth, color);
}

void Pen::stroke(
    ShapeKind kind, const Vec2f& from, const Vec2f& to, float breadth, const Rgb& color) {
  const float k = 0.5F * canvas_->texels_per_m;
  const Vec2f way = to - from;
  Shape shape = shapeAt(kind, k * (from + to), k * Vec2f(way.norm(), breadth));
  shape.angle = std::atan2(way.y(), way.x());
  draw(canvas_, shape, color);
}

void tint(ColorCanvas* canvas, const Rect& rect, const Rgb& factor) {
  const int x0 = std::max(0, static_cast<int>(rect.x));
  const int x1 = std::min(canvas->width(), static_cast<int>(rect.x + rect.width));
  const int y1 = std::min(canvas->height(), static_cast<int>(rect.y + rect.height));
  for (int y = std::max(0, static_cast<int>(rect.y)); y < y1; ++y) {
    for (int x = x0; x < x1; ++x)
      canvas->color.row(y)[x] = canvas->color.row(y)[x].cwiseProduct(factor);
  }
}

void mottle(ColorCanvas* canvas, const Noise& noise, Random* random) {
  Canvas gray;
  gray.albedo.resize(canvas->width(), canvas->height());
  fill(&gray, 1.0F);
  addNoise(&gray, noise, random);
  for (int y = 0; y < canvas->height(); ++y) {
    for (int x = 0; x < canvas->width(); ++x)
      canvas->color.row(y)[x] *= std::max(0.0F, gray.albedo.row(y)[x]);
  }
}

void fillDown(ColorCanvas* canvas, const Rect& rect, const Rgb& top, const Rgb& bottom) {
  const int x0 = std::max(0, static_cast<int>(rect.x));
  const int x1 = std::min(canvas->width(), static_cast<int>(rect.x + rect.width));
  const int y1 = std::min(canvas->height(), static_cast<int>(rect.y + rect.height));
  for (int y = std::max(0, static_cast<int>(rect.y)); y < y1; ++y) {
    const Rgb color = mix(top, bottom, (static_cast<float>(y) - rect.y) / rect.height);
    for (int x = x0; x < x1; ++x) canvas->color.row(y)[x] = color;
  }
}

}  // namespace glide::synthetic
