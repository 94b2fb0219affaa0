#pragma once

#include "render/camera_layout.h"
#include "render/packed_color.h"

#include "gpu/gl_objects.h"

#include <cstdint>
#include <span>

namespace glide {

/// The same colour with another alpha, 0 to 1.
PackedColor withAlpha(PackedColor color, float alpha);

/// One shape over the picture, in px of its rectangle: an instance of
/// shaders/render_camera_ink.vert.
struct InkShape {
  enum class Kind : std::uint32_t { stroke = 0, quad = 1 };

  std::array<float, 4> ab{};  ///< stroke: both ends; quad: the first two corners
  /// Stroke: its radius, and the radius of a hole (negative: none); quad: the other two corners.
  std::array<float, 4> cd{};
  std::array<PackedColor, 4> colors{};  ///< stroke: at both ends; quad: at the corners
  Kind kind = Kind::stroke;
};
static_assert(sizeof(InkShape) == 52, "the layout that CameraInk tells OpenGL");

/// A line with round ends.
struct InkLine {
  PointPx from{}, to{};
  float radius = 1.0F;
};
InkShape inkLine(const InkLine& line, PackedColor from, PackedColor to);
InkShape inkDisc(const PointPx& center, float radius, PackedColor color);
InkShape inkRing(const PointPx& center, float radius, float thickness, PackedColor color);
/// Corners row by row: upper left, upper right, lower left, lower right.
InkShape inkQuad(const std::array<PointPx, 4>& corners, const std::array<PackedColor, 4>& colors);

/// Draws shapes, each over the ones before, lines and discs anti-aliased. Lives in one share group;
/// its functions are called inside of a RenderVisit.
class CameraInk {
 public:
  static Result<CameraInk> create();

  /// gl when there is no memory.
  Status draw(std::span<const InkShape> shapes, const PictureLayout& layout);
  void abandon() { abandonAll(program_, shapes_); }

 private:
  explicit CameraInk(GlProgram program) : program_(std::move(program)) {}
  Status upload(std::span<const InkShape> shapes);

  GlProgram program_;
  GlBuffer shapes_;
};

}  // namespace glide
