#include "render/map_painter.h"

#include "render/render_visit.h"

namespace glide {
namespace {

// Against the trajectory's width: what is there to be overlooked, and what is not.
constexpr float kEdgeWidth = 0.6F, kLoopWidth = 1.2F, kFrustumWidth = 0.75F, kCameraWidth = 1.4F;
// Alpha of image planes and edges. Every frame's would hide all else, were they not faint.
constexpr float kPlaneAlpha = 0.12F, kFramePlaneAlpha = 0.03F, kCameraPlaneAlpha = 0.4F;
constexpr float kEdgeAlpha = 0.85F, kFrameEdgeAlpha = 0.3F;
// Against a keyframe's frustum: every frame's, and the current camera's (map_renderer.h).
constexpr float kFrameSize = 0.4F, kCameraSize = 2.0F;
/// The current camera of a plan is a mark, whatever the scale: its frustum's depth.
constexpr float kCameraInPlanPx = 14.0F;
/// Landmarks of a plan are the ground that the way is drawn on.
constexpr float kLandmarkInPlan = 0.6F;

void setUp(const MapPainter::Look& look) {
  const Viewport& area = look.view.viewport;
  glViewport(area.x, area.y, area.width, area.height);
  // Points and lines reach over the edge of the viewport, and a clear knows none.
  glScissor(area.x, area.y, area.width, area.height);
  glEnable(GL_SCISSOR_TEST);
  setBlending(Blending::on);
  if (look.content == MapContent::plan) return;  // what is drawn later is above
  glEnable(GL_DEPTH_TEST);
  glClear(GL_DEPTH_BUFFER_BIT);
}

GLsizei glCount(std::size_t count) { return static_cast<GLsizei>(count); }

/// Of lines that connect `points` points.
std::size_t polylineCount(std::size_t points) { return points > 0 ? points - 1 : 0; }

}  // namespace

Result<MapPainter> MapPainter::create() {
  Result<MapPrograms> programs = MapPrograms::create();
  if (!programs) return programs.error();
  return MapPainter(std::move(*programs));
}

Result<bool> MapPainter::update(MapScene* scene) {
  const bool is_new = scene->isChanged();
  const bool fits = landmarks_.update(&scene->landmarks()) &&
                    keyframes_.update(&scene->keyframes()) && frames_.update(&scene->frames()) &&
                    covisibility_.update(&scene->covisibility()) &&
                    loops_.update(&scene->loops()) && truth_.update(&scene->truth());
  if (!fits) return outOfMemory("the map");
  return is_new;
}

int MapPainter::paint(const MapScene& scene, const Look& look) {
  draw_calls_ = 0;
  setUp(look);
  const bool is_plan = look.content == MapContent::plan;
  programs_.begin({look.view, is_plan ? kNoDepthCue : depthCue(look.view, scene.bounds())});
  if (is_plan) paintGround(scene);
  paintLandmarks(scene, look);
  // Lines end where others begin: with depths their soft edges would cut notches into each other.
  glDepthMask(GL_FALSE);
  if (!is_plan) paintEdges(scene);
  if (!is_plan) paintFrusta(scene, look);
  paintPaths(scene);
  paintCurrentCamera(scene, look);
  return draw_calls_;
}

void MapPainter::paintGround(const MapScene& scene) {
  if (scene.style().mini_map_ground[3] <= 0.0F) return;
  programs_.drawPanel(scene.style().mini_map_ground);
  ++draw_calls_;
}

void MapPainter::paintLandmarks(const MapScene& scene, const Look& look) {
  const MapStyle& style = scene.style();
  if (!style.landmarks || scene.landmarks().size() == 0) return;
  MapPrograms::Points points;
  points.largest_px = style.landmark_px;
  if (look.content == MapContent::plan) points.largest_px *= kLandmarkInPlan;
  points.heights = scene.bounds().heights;
  points.by_age = style.coloring == LandmarkColoring::recency;
  programs_.drawPoints(landmarks_.get(), glCount(scene.landmarks().size()), points);
  ++draw_calls_;
}

void MapPainter::paintEdges(const MapScene& scene) {
  const MapStyle& style = scene.style();
  if (!style.covisibility) return;
  drawLines(covisibility_,
            scene.covisibility().size() / 2,
            {MapPrograms::kPairs, kEdgeWidth * style.line_px});
}

void MapPainter::paintPaths(const MapScene& scene) {
  const MapStyle& style = scene.style();
  if (style.loops)
    drawLines(loops_, scene.loops().size() / 2, {MapPrograms::kPairs, kLoopWidth * style.line_px});
  drawLines(truth_, polylineCount(scene.truth().size()), {MapPrograms::kPolyline, style.line_px});
  if (style.trajectory)
    drawLines(frames_, polylineCount(scene.frames().size()), {MapPrograms::kPath, style.line_px});
}

void MapPainter::paintFrusta(const MapScene& scene, const Look& look) {
  const MapStyle& style = scene.style();
  MapPrograms::Frusta frusta;
  frusta.image_plane = look.image_plane;
  frusta.line_px = kFrustumWidth * style.line_px;
  frusta.size = kFrameSize * style.frustum_size;
  frusta.plane_alpha = kFramePlaneAlpha;
  frusta.edge_alpha = kFrameEdgeAlpha;
  if (style.frame_frusta) drawFrusta(frames_, scene.frames().size(), frusta);
  frusta.size = style.frustum_size;
  frusta.plane_alpha = kPlaneAlpha;
  frusta.edge_alpha = kEdgeAlpha;
  if (style.keyframes) drawFrusta(keyframes_, scene.keyframes().size(), frusta);
}

void MapPainter::paintCurrentCamera(const MapScene& scene, const Look& look) {
  if (scene.frames().size() == 0) return;
  const MapStyle& style = scene.style();
  MapPrograms::Frusta frustum;
  frustum.image_plane = look.image_plane;
  frustum.line_px = kCameraWidth * style.line_px;
  frustum.plane_alpha = kCameraPlaneAlpha;
  frustum.size = kCameraSize * style.frustum_size;
  if (look.content == MapContent::plan) frustum.size = kCameraInPlanPx * unitsPerPixel(look.view);
  frustum.first = glCount(scene.frames().size() - 1);
  glDisable(GL_DEPTH_TEST);  // seen through everything
  drawFrusta(frames_, 1, frustum);
}

void MapPainter::drawLines(const SceneBuffer& buffer,
                           std::size_t count,
                           const MapPrograms::Lines& look) {
  if (count == 0) return;
  programs_.drawLines(buffer.get(), glCount(count), look);
  ++draw_calls_;
}

void MapPainter::drawFrusta(const SceneBuffer& buffer,
                            std::size_t count,
                            const MapPrograms::Frusta& look) {
  if (count == 0) return;
  programs_.drawFrusta(buffer.get(), glCount(count), look);
  ++draw_calls_;
}

}  // namespace glide
