#pragma once

#include "render/map_programs.h"
#include "render/map_scene.h"
#include "render/scene_buffer.h"

#include "glide/result.h"

#include <glm/vec4.hpp>

#include <cstddef>
#include <utility>

namespace glide {

/// What a picture shows of the scene.
enum class MapContent {
  all,
  plan,  ///< what tells from above where the camera is and was
};

/// The GL objects of one MapRenderer: programs and the GPU's copy of a scene. Owned by the GL
/// thread; all calls inside of a RenderVisit.
class MapPainter {
 public:
  /// gl when the shaders do not build.
  static Result<MapPainter> create();

  /// Uploads what is new in `scene`; whether there was something. gl when there is no memory.
  Result<bool> update(MapScene* scene);

  struct Look {
    MapViewPoint view;
    MapContent content = MapContent::all;
    glm::vec4 image_plane{};  ///< imagePlane()
  };
  /// Draws into the framebuffer that is bound; the number of draw calls.
  int paint(const MapScene& scene, const Look& look);

  void abandon() {
    abandonAll(programs_, landmarks_, keyframes_, frames_, covisibility_, loops_, truth_);
  }

 private:
  explicit MapPainter(MapPrograms programs) : programs_(std::move(programs)) {}

  void paintGround(const MapScene& scene);
  void paintLandmarks(const MapScene& scene, const Look& look);
  void paintEdges(const MapScene& scene);
  void paintFrusta(const MapScene& scene, const Look& look);
  void paintPaths(const MapScene& scene);
  void paintCurrentCamera(const MapScene& scene, const Look& look);
  void drawLines(const SceneBuffer& buffer, std::size_t count, const MapPrograms::Lines& look);
  void drawFrusta(const SceneBuffer& buffer, std::size_t count, const MapPrograms::Frusta& look);

  MapPrograms programs_;
  SceneBuffer landmarks_, keyframes_, frames_, covisibility_, loops_, truth_;
  int draw_calls_ = 0;  ///< of the picture
};

}  // namespace glide
