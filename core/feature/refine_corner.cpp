#include "feature/refine_corner.h"

#include <array>
#include <cmath>
#include <cstddef>

namespace glide {
namespace {

constexpr int kRadius = kRefineReach - 1;  ///< of the window, px; gradients reach one pixel further
/// A neighbourhood whose smaller eigenvalue is below this share of the larger one is an edge.
constexpr float kMinEigenRatio = 0.02F;
/// A larger step, in px, means that the detector and the edges do not mean the same point.
constexpr float kMaxStep = 1.0F;

/// Binomial weights (1 6 15 20 15 6 1) / 20 of a row or column: a Gaussian of sigma 1.2 px.
constexpr std::array<float, 2 * kRadius + 1> kWeights{
    0.05F, 0.30F, 0.75F, 1.0F, 0.75F, 0.30F, 0.05F};

}  // namespace

Vec2f refineCorner(const ImageViewU8& image, int x, int y) {
  float a = 0.0F, b = 0.0F, c = 0.0F;  // structure tensor [a b; b c]
  float rx = 0.0F, ry = 0.0F;          // its product with the positions
  for (int v = -kRadius; v <= kRadius; ++v) {
    const std::uint8_t* row = image.row(y + v) + x;
    const std::uint8_t* above = image.row(y + v - 1) + x;
    const std::uint8_t* below = image.row(y + v + 1) + x;
    for (int u = -kRadius; u <= kRadius; ++u) {
      const float weight = kWeights[static_cast<std::size_t>(u + kRadius)] *
                           kWeights[static_cast<std::size_t>(v + kRadius)];
      const float gx = static_cast<float>(row[u + 1] - row[u - 1]);
      const float gy = static_cast<float>(below[u] - above[u]);
      const float xx = weight * gx * gx, xy = weight * gx * gy, yy = weight * gy * gy;
      const float fu = static_cast<float>(u), fv = static_cast<float>(v);
      a += xx;
      b += xy;
      c += yy;
      rx += xx * fu + xy * fv;
      ry += xy * fu + yy * fv;
    }
  }
  const Vec2f corner(static_cast<float>(x), static_cast<float>(y));
  const float determinant = a * c - b * b, trace = a + c;
  // det / trace^2 = ratio / (1 + ratio)^2 for eigenvalues whose quotient is ratio.
  if (determinant <= kMinEigenRatio * trace * trace) return corner;
  const Vec2f step((c * rx - b * ry) / determinant, (a * ry - b * rx) / determinant);
  if (std::abs(step.x()) > kMaxStep || std::abs(step.y()) > kMaxStep) return corner;
  return corner + step;
}

}  // namespace glide
