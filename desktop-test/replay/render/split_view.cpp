#include "replay/render/split_view.h"

#include "replay/outputs/run_trajectories.h"
#include "replay/render/framing.h"

#include <utility>

namespace glide::replay {
namespace {

constexpr int kTruthEvery = 10;          // frames: aligning anew is seen but costs
constexpr double kFieldOfView = 0.8;     // radians: little distortion at the edges
constexpr double kFrustumShare = 0.011;  // of the distance from which the scene is seen
constexpr double kAxesFrom = 4.0;        // axis lengths
constexpr float kLandmarkPx = 6.0F;

Lens lensOf(const Viewport& scene) {
  return {kFieldOfView, static_cast<double>(scene.width) / scene.height};
}

/// For a scene seen from so far: every frame's frustum shows who placed it, and frusta keep their
/// size in the picture, whatever the size of the map.
MapStyle styleOfScene(double distance) {
  MapStyle style;
  style.landmark_px = kLandmarkPx;
  style.frustum_size = static_cast<float>(kFrustumShare * distance);
  style.frame_frusta = true;
  return style;
}

}  // namespace

Result<SplitView> SplitView::create(const SplitViewSetup& setup) {
  auto map = MapRenderer::create(GlStatePolicy::preserve);
  if (!map) return map.error();
  auto picture = CameraRenderer::create(GlStatePolicy::preserve, setup.camera);
  if (!picture) return picture.error();
  auto strip = CameraRenderer::create(GlStatePolicy::preserve, setup.camera);
  if (!strip) return strip.error();
  const Result<CameraModel> camera = CameraModel::create(setup.camera);
  if (!camera) return camera.error();
  return SplitView(
      setup, ArScene(*camera), {std::move(*map), std::move(*picture), std::move(*strip)});
}

SplitView::SplitView(const SplitViewSetup& setup, ArScene ar, Renderers renderers)
    : renderers_(std::move(renderers)),
      view_(setup.view),
      camera_(setup.camera),
      timeline_(setup.frames),
      truth_(setup.truth),
      flight_(kFieldOfView),
      ar_(std::move(ar)),
      map_(std::make_shared<MapView>()) {
  renderers_.map.setIntrinsics(setup.camera);
}

void SplitView::show(const FrameMoment& moment) {
  show({moment.record, moment.frame, mapOf(moment), moment.session.trackedPoints()});
}

void SplitView::show(ShownFrame shown) {
  const FrameResult& frame = shown.record.result;
  keepPicture(shown.frame);
  points_ = std::move(shown.points);
  tracker_ = frame.tracker;
  timeline_.add(frame);
  truth_.add(shown.record);
  if (shown.map != map_) showMap(std::move(shown.map));
  renderers_.map.addFrame(frame);
  T_world_cam_ = frame.T_world_cam;
  is_tracked_ = frame.state == TrackingState::tracking;
  if (view_ == RenderView::ar) ar_.show(frame, *map_);
  if (shown_frames_++ % kTruthEvery == 0) renderers_.map.setTruth(truth_.alignedTo(map_));
  if (frame.state != TrackingState::tracking) return;
  const auto framing = frameAround(*map_, toSE3(frame.T_world_cam));
  if (framing) flight_.follow(*framing, static_cast<double>(frame.t_ns) * 1e-9);
}

/// The one that is shown, unless the frame has brought another one.
std::shared_ptr<const MapView> SplitView::mapOf(const FrameMoment& moment) const {
  const bool is_shown = moment.record.result.map_revision == map_->revision;
  return is_shown && !map_->keyframes.empty() ? map_ : moment.session.map();
}

void SplitView::showMap(std::shared_ptr<const MapView> map) {
  if (map_->resets != map->resets) flight_.jump();
  map_ = std::move(map);
  renderers_.map.setMap(map_);
  useCamera(map_->corrected_camera.value_or(camera_));
}

/// What is drawn into the picture goes through the lens that the poses were found with.
void SplitView::useCamera(const CameraIntrinsics& camera) {
  const Result<CameraModel> model = CameraModel::create(camera);
  if (!model || !renderers_.picture.setIntrinsics(camera)) return;  // a map's camera is always one
  renderers_.map.setIntrinsics(camera);
  ar_.setCamera(*model);
}

/// A copy: a viewer draws the frame again when it is long gone.
void SplitView::keepPicture(const SourceFrame& frame) {
  color_ = {frame.color.width, frame.color.height, frame.color.rgb};
  if (color_.rgb.empty()) gray_ = frame.image;
}

std::optional<Orbit> SplitView::shownFrom(const ViewControl& control) const {
  const std::optional<Orbit>& flight = flight_.orbit();
  if (!flight) return std::nullopt;
  return control.apply(*flight);
}

Status SplitView::draw(const PictureSize& size, const ViewControl& control) {
  const SplitLayout layout = layoutOf(view_, size, {camera_.width, camera_.height});
  Status drawn = isEmpty(layout.picture) ? Unit{} : drawPicture(layout.picture);
  if (drawn && !isEmpty(layout.timeline)) drawn = drawTimeline(layout.timeline);
  return drawn ? drawMap(layout, control) : drawn;
}

Status SplitView::drawMap(const SplitLayout& layout, const ViewControl& control) {
  const std::optional<Orbit>& flight = flight_.orbit();
  if (!flight) return Unit{};
  renderers_.map.setStyle(styleOfScene(flight->distance));
  if (!isEmpty(layout.mini_map)) {
    Status drawn = renderers_.map.drawMiniMap(layout.mini_map);
    if (!drawn) return drawn;
  }
  if (isEmpty(layout.scene)) return Unit{};
  return renderers_.map.draw(viewOf(control.apply(*flight), lensOf(layout.scene)), layout.scene);
}

Status SplitView::drawPicture(const Viewport& viewport) {
  const Picture picture =
      color_.rgb.empty()
          ? Picture(Luma{gray_.row(0), gray_.width(), gray_.height(), gray_.stride()})
          : Picture(viewOf(color_));
  const Status drawn = renderers_.picture.drawPicture(picture, viewport);
  return drawn ? drawOverPicture(viewport) : drawn;
}

Status SplitView::drawOverPicture(const Viewport& viewport) {
  if (view_ != RenderView::ar) return renderers_.picture.drawPoints(points_, tracker_, viewport);
  if (!is_tracked_) return Unit{};
  const std::vector<Pose> cubes = ar_.cubes();
  ArContent content;
  // From nearby an axis is all that one sees.
  content.axes = toSE3(T_world_cam_).t.norm() > kAxesFrom * content.axis_length;
  content.cubes = cubes;
  content.cube_edge = static_cast<float>(ar_.edge());
  return renderers_.picture.drawAr(content, T_world_cam_, viewport);
}

Status SplitView::drawTimeline(const Viewport& viewport) {
  const RgbPicture strip = timeline_.paint(viewport.width, viewport.height);
  return renderers_.strip.drawPicture(viewOf(strip), viewport);
}

}  // namespace glide::replay
