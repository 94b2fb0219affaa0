#include "gpu/texture_placement.h"

#include "gpu/gl.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace glide {
namespace {

// How far from a texel's centre a pixel may lie and still be that texel: SurfaceTexture's matrices
// are exact to 1e-7, which is 4e-4 of a texel at the end of 4096.
constexpr double kTexelTolerance = 0.02;
// The transforms of cropped camera buffers shrink by up to a texel on each side against bleeding.
constexpr double kMaxStretch = 0.02;
// A frame may reach that far out of the texture, in texels; the border is repeated.
constexpr double kMaxOverhang = 1.5;

using Vec2 = std::array<double, 2>;

/// The placement in texels: the centre of the texture's first texel is (0.5, 0.5).
struct TexelPlacement {
  Vec2 origin, per_column, per_row;
};

Vec2 transformed(const TextureTransform& m, double s, double t) {
  return {m[0] * s + m[4] * t + m[12], m[1] * s + m[5] * t + m[13]};
}

/// Pixel (x, y) of the frame is s = (x + 1/2) / width, t = 1 - (y + 1/2) / height.
TexelPlacement inTexels(const Texture& texture, FrameSize frame) {
  const TextureTransform& m = texture.transform;
  const double columns = 1.0 / frame.width;
  const double rows = 1.0 / frame.height;
  const Vec2 first = transformed(m, 0.5 * columns, 1.0 - 0.5 * rows);
  const double w = texture.width;
  const double h = texture.height;
  return {{first[0] * w, first[1] * h},
          {m[0] * columns * w, m[1] * columns * h},
          {-m[4] * rows * w, -m[5] * rows * h}};
}

bool isWhole(double value, double tolerance) {
  return std::abs(value - std::round(value)) <= tolerance;
}

/// One texel further, in some direction, for each pixel.
bool isTexelStep(const Vec2& step, int pixels) {
  const double tolerance = kTexelTolerance / pixels;
  return isWhole(step[0], tolerance) && isWhole(step[1], tolerance) &&
         std::abs(std::abs(step[0]) + std::abs(step[1]) - 1.0) < 0.5;
}

bool hitsTexels(const TexelPlacement& place, FrameSize frame) {
  return isTexelStep(place.per_column, frame.width) && isTexelStep(place.per_row, frame.height) &&
         isWhole(place.origin[0] - 0.5, kTexelTolerance) &&
         isWhole(place.origin[1] - 0.5, kTexelTolerance);
}

bool isAffine(const TextureTransform& m) {
  constexpr float kTolerance = 1e-6F;
  const bool finite =
      std::all_of(m.begin(), m.end(), [](float value) { return std::isfinite(value); });
  return finite && std::abs(m[3]) <= kTolerance && std::abs(m[7]) <= kTolerance &&
         std::abs(m[15] - 1.0F) <= kTolerance;
}

bool isInside(const TexelPlacement& place, const Texture& texture, FrameSize frame) {
  const Vec2 size{static_cast<double>(texture.width), static_cast<double>(texture.height)};
  for (const double x : {0.0, frame.width - 1.0}) {
    for (const double y : {0.0, frame.height - 1.0}) {
      for (std::size_t i = 0; i < 2; ++i) {
        const double at = place.origin[i] + x * place.per_column[i] + y * place.per_row[i];
        if (at < -kMaxOverhang || at > size[i] + kMaxOverhang) return false;
      }
    }
  }
  return true;
}

Error invalid(const std::string& what) { return {ErrorCode::invalid_argument, "the image" + what}; }

Status checkTransform(const Texture& texture, FrameSize frame) {
  if (!isAffine(texture.transform)) return invalid("'s transform is not affine");
  const TexelPlacement place = inTexels(texture, frame);
  const double across = std::hypot(place.per_column[0], place.per_column[1]);
  const double down = std::hypot(place.per_row[0], place.per_row[1]);
  const double longer = std::max(across, down);
  const double cross =
      place.per_column[0] * place.per_row[1] - place.per_column[1] * place.per_row[0];
  // Of a similarity the area of a pixel is the square of its side.
  if (!(longer > 0.0) || std::abs(cross) < (1.0 - kMaxStretch) * longer * longer)
    return invalid(": the texture of " + std::to_string(texture.width) + "x" +
                   std::to_string(texture.height) + " with its transform is stretched to the " +
                   std::to_string(frame.width) + "x" + std::to_string(frame.height) +
                   " of the camera: a pixel is " + std::to_string(across) + " texels wide and " +
                   std::to_string(down) + " high");
  if (!isInside(place, texture, frame)) return invalid("'s transform leaves the texture");
  return Unit{};
}

}  // namespace

TexturePlacement placeTexture(const Texture& texture, FrameSize frame) {
  const TexelPlacement place = inTexels(texture, frame);
  const auto coordinates = [&](const Vec2& texels) {
    return std::array<float, 2>{static_cast<float>(texels[0] / texture.width),
                                static_cast<float>(texels[1] / texture.height)};
  };
  return {coordinates(place.origin),
          coordinates(place.per_column),
          coordinates(place.per_row),
          hitsTexels(place, frame)};
}

Status checkPlacement(const Texture& texture, FrameSize frame) {
  if (texture.name == 0) return invalid("'s name is 0, which is no texture");
  if (texture.target != GL_TEXTURE_2D && texture.target != GL_TEXTURE_EXTERNAL_OES)
    return invalid("'s target " + std::to_string(texture.target) +
                   " is neither GL_TEXTURE_2D nor GL_TEXTURE_EXTERNAL_OES");
  if (texture.width <= 0 || texture.height <= 0)
    return invalid(": the texture's width and height must be positive");
  return checkTransform(texture, frame);
}

}  // namespace glide
