#include "render/map_programs.h"

#include "render/render_program.h"

#include <glm/gtc/type_ptr.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <utility>

namespace glide {
namespace {

// Locations of uniforms: render_map_view.glsl ...
constexpr GLint kEyeFromWorld = 0, kClipFromEye = 1, kCue = 2;
// ... render_map_points.vert ...
constexpr GLint kLargestPx = 3, kCount = 4, kHeights = 5;
// ... render_map_stroke.glsl, render_map_frusta.vert ...
constexpr GLint kViewportPx = 3, kStroke = 4, kImagePlane = 5, kLook = 6;
// ... render_map_panel.frag.
constexpr GLint kPanelColor = 0, kArea = 1;

constexpr GLsizei kStripVertices = 4;
/// An image plane and eight edges, two triangles each.
constexpr GLsizei kFrustumVertices = 6 + 8 * 6;
/// How far lines that follow each other overlap, so that bends have no gaps.
constexpr float kJointPx = 0.25F;

/// Where an attribute's values lie.
struct Attribute {
  GLuint location;
  GLint components;
  GLenum type;
  GLuint offset;  ///< in the record, bytes
};

/// Feeds `attribute` of the vertex array from binding point `binding`. Colours are normalised.
void feed(const Attribute& attribute, GLuint binding) {
  const GLboolean normalized = attribute.type == GL_UNSIGNED_BYTE ? GL_TRUE : GL_FALSE;
  glEnableVertexAttribArray(attribute.location);
  glVertexAttribFormat(
      attribute.location, attribute.components, attribute.type, normalized, attribute.offset);
  glVertexAttribBinding(attribute.location, binding);
}

constexpr GLuint kEachVertex = 0, kEachInstance = 1;

}  // namespace

Result<MapPrograms> MapPrograms::create() {
  struct Part {
    GlProgram MapPrograms::*program;
    std::string_view vertices, fragments;
  };
  constexpr std::array<Part, 4> kParts{{
      {&MapPrograms::panel_, "render_map_panel", "render_map_panel"},
      {&MapPrograms::points_, "render_map_points", "render_map_points"},
      {&MapPrograms::lines_, "render_map_lines", "render_map_stroke"},
      {&MapPrograms::frusta_, "render_map_frusta", "render_map_stroke"},
  }};
  MapPrograms programs;
  for (const Part& part : kParts) {
    Result<GlProgram> built = buildRenderProgram(part.vertices, part.fragments);
    if (!built) return built.error();
    programs.*part.program = std::move(*built);
  }
  return programs;
}

void MapPrograms::begin(const Picture& picture) { picture_ = picture; }

void MapPrograms::use(const GlProgram& program) const {
  glUseProgram(program.get());
  glUniformMatrix4fv(kEyeFromWorld, 1, GL_FALSE, glm::value_ptr(picture_.view.eye_from_world));
  glUniformMatrix4fv(kClipFromEye, 1, GL_FALSE, glm::value_ptr(picture_.view.clip_from_eye));
  glUniform2fv(kCue, 1, glm::value_ptr(picture_.cue));
  if (program.get() == points_.get()) return;
  const Viewport& viewport = picture_.view.viewport;
  glUniform2f(kViewportPx, static_cast<float>(viewport.width), static_cast<float>(viewport.height));
}

void MapPrograms::drawPanel(const Color& color) const {
  const Viewport& area = picture_.view.viewport;
  glUseProgram(panel_.get());
  glUniform4fv(kPanelColor, 1, color.data());
  glUniform4f(kArea,
              static_cast<float>(area.x),
              static_cast<float>(area.y),
              static_cast<float>(area.x + area.width),
              static_cast<float>(area.y + area.height));
  glDrawArrays(GL_TRIANGLES, 0, 3);
}

void MapPrograms::drawPoints(GLuint landmarks, GLsizei count, const Points& look) const {
  use(points_);
  glUniform1f(kLargestPx, look.largest_px);
  glUniform1fv(kHeights, static_cast<GLsizei>(look.heights.size()), look.heights.data());
  glUniform1f(kCount, look.by_age ? static_cast<float>(count) : 0.0F);
  feed({0, 4, GL_FLOAT, 0}, 0);
  glVertexBindingDivisor(0, kEachVertex);
  glBindVertexBuffer(0, landmarks, 0, sizeof(LandmarkRecord));
  glDrawArrays(GL_POINTS, 0, count);
}

void MapPrograms::drawLines(GLuint points, GLsizei count, const Lines& look) const {
  constexpr GLuint kBegin = 0, kEnd = 1;  // binding points
  use(lines_);
  glUniform2f(kStroke, look.width_px, kJointPx);
  feed({0, 3, GL_FLOAT, 0}, kBegin);
  feed({1, 3, GL_FLOAT, 0}, kEnd);
  feed({2, 4, GL_UNSIGNED_BYTE, look.layout.color}, kEnd);
  glVertexBindingDivisor(kBegin, kEachInstance);
  glVertexBindingDivisor(kEnd, kEachInstance);
  glBindVertexBuffer(kBegin, points, 0, look.layout.stride);
  glBindVertexBuffer(kEnd, points, look.layout.end, look.layout.stride);
  glDrawArraysInstanced(GL_TRIANGLE_STRIP, 0, kStripVertices, count);
}

void MapPrograms::drawFrusta(GLuint cameras, GLsizei count, const Frusta& look) const {
  use(frusta_);
  glUniform2f(kStroke, look.line_px, 0.5F * look.line_px);  // round corners
  glUniform4fv(kImagePlane, 1, glm::value_ptr(look.image_plane));
  glUniform3f(kLook, look.size, look.plane_alpha, look.edge_alpha);
  feed({0, 3, GL_FLOAT, offsetof(PoseRecord, p_world)}, 0);
  feed({1, 4, GL_FLOAT, offsetof(PoseRecord, q_world_cam_xyzw)}, 0);
  feed({2, 4, GL_UNSIGNED_BYTE, offsetof(PoseRecord, color)}, 0);
  glVertexBindingDivisor(0, kEachInstance);
  const auto first = static_cast<GLintptr>(sizeof(PoseRecord)) * look.first;
  glBindVertexBuffer(0, cameras, first, sizeof(PoseRecord));
  glDrawArraysInstanced(GL_TRIANGLES, 0, kFrustumVertices, count);
}

}  // namespace glide
