#pragma once

#include "synthetic/canvas.h"

#include <algorithm>
#include <cmath>

namespace glide::synthetic {

/// Signed distance (about) from a point in the shape's own axes to its outline, negative inside.
inline float signedDistance(const Shape& shape, float x, float y) {
  const float ax = std::abs(x), ay = std::abs(y);
  switch (shape.kind) {
    case ShapeKind::rectangle:
      return std::max(ax - shape.half_w, ay - shape.half_h);
    case ShapeKind::ellipse:
      return (std::hypot(x / shape.half_w, y / shape.half_h) - 1.0F) *
             std::min(shape.half_w, shape.half_h);
    case ShapeKind::triangle: {
      const float slope = shape.half_w / (2.0F * shape.half_h);
      const float side = (ax - slope * (y + shape.half_h)) / std::hypot(1.0F, slope);
      return std::max(side, ay - shape.half_h);
    }
  }
  return 0.0F;
}

/// Inclusive.
struct PixelBox {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
};

inline PixelBox boundingBox(int width, int height, const Shape& shape) {
  const float c = std::abs(std::cos(shape.angle)), s = std::abs(std::sin(shape.angle));
  const float rx = c * shape.half_w + s * shape.half_h + 1.0F;
  const float ry = s * shape.half_w + c * shape.half_h + 1.0F;
  return {std::max(0, static_cast<int>(std::floor(shape.x - rx))),
          std::max(0, static_cast<int>(std::floor(shape.y - ry))),
          std::min(width - 1, static_cast<int>(std::ceil(shape.x + rx))),
          std::min(height - 1, static_cast<int>(std::ceil(shape.y + ry)))};
}

/// Calls visit(x, y, share of the texel that the shape covers times its opacity) for the texels of
/// a canvas of this size around the shape.
template <class Visit>
void forEachCovered(int width, int height, const Shape& shape, const Visit& visit) {
  const PixelBox box = boundingBox(width, height, shape);
  const float c = std::cos(shape.angle), s = std::sin(shape.angle);
  for (int y = box.y0; y <= box.y1; ++y) {
    const float dy = static_cast<float>(y) + 0.5F - shape.y;
    for (int x = box.x0; x <= box.x1; ++x) {
      const float dx = static_cast<float>(x) + 0.5F - shape.x;
      const float distance = signedDistance(shape, c * dx + s * dy, c * dy - s * dx);
      visit(x, y, std::clamp(0.5F - distance, 0.0F, 1.0F) * shape.opacity);
    }
  }
}

}  // namespace glide::synthetic
