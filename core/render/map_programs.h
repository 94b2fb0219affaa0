#pragma once

#include "render/map_view_point.h"
#include "render/scene_bounds.h"
#include "render/scene_records.h"

#include "gpu/gl_objects.h"

#include "glide/result.h"

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include <array>

namespace glide {

/// The programs of the map, inside of a RenderVisit. Each draw call is one of these
/// functions: it binds what it needs. Buffers hold records (scene_records.h).
class MapPrograms {
 public:
  static Result<MapPrograms> create();

  /// What all draw calls of one picture share.
  struct Picture {
    MapViewPoint view;
    glm::vec2 cue{0.0F, 1.0F};  ///< depthCue()
  };
  void begin(const Picture& picture);

  /// Fills the viewport.
  void drawPanel(const Color& color) const;

  struct Points {
    float largest_px = 1.0F;
    std::array<float, kHeightSteps + 1> heights{};  ///< of the colours, ascending
    bool by_age = false;                            ///< colours tell age, not height
  };
  void drawPoints(GLuint landmarks, GLsizei count, const Points& look) const;

  /// Where the ends of lines lie in a buffer. Bytes.
  struct LineLayout {
    GLsizei stride;  ///< from one line to the next
    GLuint end;      ///< from a line's begin to its end
    GLuint color;    ///< of the line: in the record of its end
  };
  static constexpr LineLayout kPairs{
      2 * sizeof(PointRecord), sizeof(PointRecord), offsetof(PointRecord, color)};
  static constexpr LineLayout kPolyline{
      sizeof(PointRecord), sizeof(PointRecord), offsetof(PointRecord, color)};
  static constexpr LineLayout kPath{
      sizeof(PoseRecord), sizeof(PoseRecord), offsetof(PoseRecord, color)};
  struct Lines {
    LineLayout layout;
    float width_px = 1.0F;
  };
  void drawLines(GLuint points, GLsizei count, const Lines& look) const;

  struct Frusta {
    glm::vec4 image_plane;  ///< imagePlane()
    float size = 1.0F;      ///< distance of the image plane, scene units
    float line_px = 1.0F;
    float plane_alpha = 0.0F;
    float edge_alpha = 1.0F;
    GLsizei first = 0;  ///< record of the first camera
  };
  void drawFrusta(GLuint cameras, GLsizei count, const Frusta& look) const;

  void abandon() { abandonAll(panel_, points_, lines_, frusta_); }

 private:
  MapPrograms() = default;
  void use(const GlProgram& program) const;

  GlProgram panel_, points_, lines_, frusta_;
  Picture picture_;
};

}  // namespace glide
