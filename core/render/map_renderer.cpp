#include "glide/map_renderer.h"

#include "render/map_painter.h"
#include "render/map_scene.h"
#include "render/map_view_point.h"
#include "render/render_visit.h"

#include "gpu/gl_caps.h"
#include "gpu/gl_home.h"

#include <optional>
#include <utility>

namespace glide {
namespace {

/// What lives in one context.
struct GlSide {
  GlHome home;
  MapPainter painter;
};

}  // namespace

class MapRenderer::Impl {
 public:
  explicit Impl(GlStatePolicy policy) : policy_(policy) {}
  ~Impl() { releaseGl(); }
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;

  Status draw(const MapPainter::Look& look) {
    if (Status ready = enterContext(); !ready) return ready;
    if (Status viewport = checkViewport(look.view.viewport); !viewport) return viewport;
    if (Status target = checkFramebuffer(); !target) return target;
    const RenderVisit visit(&gl_->home, policy_);
    const Result<bool> uploaded = gl_->painter.update(&scene);
    if (!uploaded) return uploaded.error();
    if (*uploaded) gl_->home.publish();
    draw_calls = gl_->painter.paint(scene, look);
    return Unit{};
  }

  void releaseGl() {
    if (gl_ && !gl_->home.isHere()) return abandonGl();
    gl_.reset();
    scene.markLost();
  }
  void abandonGl() {
    if (gl_) abandonAll(gl_->home, gl_->painter);
    gl_.reset();
    scene.markLost();
  }

  MapScene scene;
  glm::vec4 image_plane = imagePlane({});
  int draw_calls = 0;

 private:
  /// Sees to it that the GL objects are of the context that is current.
  Status enterContext() {
    if (gl_ && gl_->home.isHere()) return Unit{};
    const Result<GlCaps> caps = GlCaps::query();
    if (!caps) return caps.error();
    abandonGl();
    Result<GlHome> home = GlHome::create();
    if (!home) return home.error();
    Result<MapPainter> painter = MapPainter::create();
    if (!painter) return painter.error();
    gl_.emplace(GlSide{std::move(*home), std::move(*painter)});
    return Unit{};
  }

  GlStatePolicy policy_;
  std::optional<GlSide> gl_;
};

Result<MapRenderer> MapRenderer::create(GlStatePolicy policy) {
  const Result<GlCaps> caps = GlCaps::query();
  if (!caps) return caps.error();
  return MapRenderer(std::make_unique<Impl>(policy));
}

MapRenderer::MapRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
MapRenderer::MapRenderer(MapRenderer&&) noexcept = default;
MapRenderer& MapRenderer::operator=(MapRenderer&&) noexcept = default;
MapRenderer::~MapRenderer() = default;

void MapRenderer::setStyle(const MapStyle& style) { impl_->scene.setStyle(style); }

void MapRenderer::setMap(std::shared_ptr<const MapView> map) {
  impl_->scene.setMap(std::move(map));
}

void MapRenderer::setIntrinsics(const CameraIntrinsics& camera) {
  impl_->image_plane = imagePlane(camera);
}

void MapRenderer::addFrame(const FrameResult& frame) { impl_->scene.addFrame(frame); }

void MapRenderer::setTruth(std::span<const Pose> T_world_cam) {
  impl_->scene.setTruth(T_world_cam);
}

Status MapRenderer::draw(const ViewCamera& camera, const Viewport& viewport) {
  return impl_->draw({viewPoint(camera, viewport), MapContent::all, impl_->image_plane});
}

Status MapRenderer::drawMiniMap(const Viewport& viewport) {
  const MapViewPoint view = viewFromAbove(groundOf(impl_->scene), viewport);
  return impl_->draw({view, MapContent::plan, impl_->image_plane});
}

int MapRenderer::drawCalls() const { return impl_->draw_calls; }
void MapRenderer::releaseGl() { impl_->releaseGl(); }
void MapRenderer::abandonGl() { impl_->abandonGl(); }

}  // namespace glide
