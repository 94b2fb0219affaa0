#include "render/camera_ink.h"

#include "render/render_program.h"
#include "render/render_visit.h"

#include <cstddef>

namespace glide {
namespace {

// layout(location) of shaders/render_camera_ink.vert
constexpr GLuint kAb = 0, kCd = 1, kColors = 2, kKind = 6;
constexpr GLint kSize = 0;
// Corners of a shape, as a strip.
constexpr GLsizei kCorners = 4;
// The first buffer holds the points of a frame; it doubles from there.
constexpr std::size_t kFirstShapes = 1024;
constexpr float kNoHole = -2.0F;  // px: not even its soft rim reaches the centre

void describeFloats(GLuint location, GLint count, std::size_t offset) {
  glEnableVertexAttribArray(location);
  glVertexAttribFormat(location, count, GL_FLOAT, GL_FALSE, static_cast<GLuint>(offset));
  glVertexAttribBinding(location, 0);
}

void describeColors() {
  for (GLuint i = 0; i < kCorners; ++i) {
    const std::size_t offset = offsetof(InkShape, colors) + i * sizeof(PackedColor);
    glEnableVertexAttribArray(kColors + i);
    glVertexAttribFormat(kColors + i, 4, GL_UNSIGNED_BYTE, GL_TRUE, static_cast<GLuint>(offset));
    glVertexAttribBinding(kColors + i, 0);
  }
}

/// What the vertex array that is bound takes from `shapes`: one for each instance.
void describe(const GlBuffer& shapes) {
  describeFloats(kAb, 4, offsetof(InkShape, ab));
  describeFloats(kCd, 4, offsetof(InkShape, cd));
  describeColors();
  glEnableVertexAttribArray(kKind);
  glVertexAttribIFormat(kKind, 1, GL_UNSIGNED_INT, offsetof(InkShape, kind));
  glVertexAttribBinding(kKind, 0);
  glBindVertexBuffer(0, shapes.get(), 0, sizeof(InkShape));
  glVertexBindingDivisor(0, 1);
}

InkShape roundShape(const InkLine& line, float hole) {
  InkShape shape;
  shape.ab = {line.from[0], line.from[1], line.to[0], line.to[1]};
  shape.cd = {line.radius, hole, 0.0F, 0.0F};
  return shape;
}

}  // namespace

PackedColor withAlpha(PackedColor color, float alpha) {
  color[3] = packChannel(alpha);
  return color;
}

InkShape inkLine(const InkLine& line, PackedColor from, PackedColor to) {
  InkShape shape = roundShape(line, kNoHole);
  shape.colors = {from, to, from, to};
  return shape;
}

InkShape inkDisc(const PointPx& center, float radius, PackedColor color) {
  return inkLine({center, center, radius}, color, color);
}

InkShape inkRing(const PointPx& center, float radius, float thickness, PackedColor color) {
  InkShape shape = roundShape({center, center, radius}, radius - thickness);
  shape.colors.fill(color);
  return shape;
}

InkShape inkQuad(const std::array<PointPx, 4>& corners, const std::array<PackedColor, 4>& colors) {
  InkShape shape;
  shape.ab = {corners[0][0], corners[0][1], corners[1][0], corners[1][1]};
  shape.cd = {corners[2][0], corners[2][1], corners[3][0], corners[3][1]};
  shape.colors = colors;
  shape.kind = InkShape::Kind::quad;
  return shape;
}

Result<CameraInk> CameraInk::create() {
  Result<GlProgram> program = buildRenderProgram("render_camera_ink", "render_camera_ink");
  if (!program) return program.error();
  return CameraInk(std::move(*program));
}

Status CameraInk::upload(std::span<const InkShape> shapes) {
  const auto bytes = static_cast<std::int64_t>(shapes.size_bytes());
  if (bytes > shapes_.bytes()) {
    std::size_t room = kFirstShapes;
    while (room < shapes.size()) room *= 2;
    shapes_ =
        GlBuffer::allocate(static_cast<std::int64_t>(room * sizeof(InkShape)), GL_STREAM_DRAW);
    if (!shapes_.isComplete()) return outOfMemory("points and AR content");
  }
  shapes_.write(shapes.data(), bytes);
  return Unit{};
}

Status CameraInk::draw(std::span<const InkShape> shapes, const PictureLayout& layout) {
  if (shapes.empty()) return Unit{};
  if (Status uploaded = upload(shapes); !uploaded) return uploaded;
  const Viewport& area = layout.area;
  glViewport(area.x, area.y, area.width, area.height);
  setBlending(Blending::on);
  describe(shapes_);
  glUseProgram(program_.get());
  glUniform2f(kSize, static_cast<GLfloat>(area.width), static_cast<GLfloat>(area.height));
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kCorners, static_cast<GLsizei>(shapes.size()));
  return Unit{};
}

}  // namespace glide
