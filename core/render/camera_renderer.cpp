#include "glide/camera_renderer.h"

#include "render/camera_ar.h"
#include "render/camera_ink.h"
#include "render/camera_picture.h"
#include "render/camera_points.h"
#include "render/render_visit.h"

#include "gpu/gl_caps.h"
#include "gpu/gl_home.h"

#include "geometry/pose_conversion.h"

#include <optional>
#include <utility>

namespace glide {
namespace {

/// What lies in one share group.
struct CameraObjects {
  GlHome home;
  CameraPicture picture;
  CameraInk ink;

  static Result<CameraObjects> create(GlStatePolicy policy) {
    const Result<GlCaps> caps = GlCaps::query();
    if (!caps) return caps.error();
    const ScopedGlState state(policy);
    Result<GlHome> home = GlHome::create();
    if (!home) return home.error();
    Result<CameraPicture> picture = CameraPicture::create(*caps, policy);
    if (!picture) return picture.error();
    Result<CameraInk> ink = CameraInk::create();
    if (!ink) return ink.error();
    return CameraObjects{std::move(*home), std::move(*picture), std::move(*ink)};
  }
  void abandon() { abandonAll(home, picture, ink); }
};

}  // namespace

class CameraRenderer::Impl {
 public:
  Impl(GlStatePolicy policy, const CameraModel& camera)
      : policy_(policy), camera_(camera), picture_size_(cameraSize()) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { releaseGl(); }

  /// For what is drawn from now on.
  void setCamera(const CameraModel& camera) { camera_ = camera; }

  Status drawPicture(const Picture& picture, const Viewport& viewport);
  Status drawPoints(std::span<const TrackedPoint> points,
                    TrackerKind tracker,
                    const Viewport& viewport);
  Status drawAr(const ArContent& content, const Pose& T_world_cam, const Viewport& viewport);

  void releaseGl() {
    if (objects_ && !objects_->home.isHere()) objects_->abandon();
    objects_.reset();
  }
  void abandonGl() {
    if (objects_) objects_->abandon();
    objects_.reset();
  }

 private:
  FrameSize cameraSize() const { return {camera_.width(), camera_.height()}; }
  /// Makes the objects, unless they are in the context that is current, and looks where they are
  /// to draw.
  Status settle();
  Status drawShapes(const PictureLayout& layout);

  GlStatePolicy policy_;
  CameraModel camera_;
  FrameSize picture_size_;  ///< of the picture drawn last
  PointTrails trails_;
  std::vector<InkShape> shapes_;  ///< of one call; kept for its memory
  std::optional<CameraObjects> objects_;
};

Status CameraRenderer::Impl::settle() {
  if (objects_ && objects_->home.isHere()) return checkFramebuffer();
  Result<CameraObjects> made = CameraObjects::create(policy_);
  if (!made) return made.error();
  abandonGl();
  objects_.emplace(std::move(*made));
  return checkFramebuffer();
}

Status CameraRenderer::Impl::drawPicture(const Picture& picture, const Viewport& viewport) {
  if (Status checked = checkViewport(viewport); !checked) return checked;
  if (Status checked = checkPicture(picture, cameraSize()); !checked) return checked;
  if (Status settled = settle(); !settled) return settled;
  const FrameSize size = pictureSize(picture, cameraSize());
  const RenderVisit visit(&objects_->home, policy_);
  Status drawn = objects_->picture.draw(picture, cameraSize(), PictureLayout::fit(size, viewport));
  if (drawn) picture_size_ = size;
  return drawn;
}

Status CameraRenderer::Impl::drawShapes(const PictureLayout& layout) {
  if (Status settled = settle(); !settled) return settled;
  const RenderVisit visit(&objects_->home, policy_);
  return objects_->ink.draw(shapes_, layout);
}

Status CameraRenderer::Impl::drawPoints(std::span<const TrackedPoint> points,
                                        TrackerKind tracker,
                                        const Viewport& viewport) {
  if (Status checked = checkViewport(viewport); !checked) return checked;
  const PictureLayout layout = PictureLayout::fit(picture_size_, viewport);
  trails_.add(points);
  shapes_.clear();
  PointInk{cameraSize(), layout, tracker}.append(points, trails_, &shapes_);
  return drawShapes(layout);
}

Status CameraRenderer::Impl::drawAr(const ArContent& content,
                                    const Pose& T_world_cam,
                                    const Viewport& viewport) {
  if (Status checked = checkViewport(viewport); !checked) return checked;
  const PictureLayout layout = PictureLayout::fit(picture_size_, viewport);
  const ArLens lens{camera_, layout};
  shapes_.clear();
  ArInk(lens, fromPose(T_world_cam).inverse()).append(content, &shapes_);
  return drawShapes(layout);
}

Result<CameraRenderer> CameraRenderer::create(GlStatePolicy policy,
                                              const CameraIntrinsics& camera) {
  const Result<CameraModel> model = CameraModel::create(camera);
  if (!model) return model.error();
  const Result<GlCaps> caps = GlCaps::query();
  if (!caps) return caps.error();
  return CameraRenderer(std::make_unique<Impl>(policy, *model));
}

CameraRenderer::CameraRenderer(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
CameraRenderer::CameraRenderer(CameraRenderer&&) noexcept = default;
CameraRenderer& CameraRenderer::operator=(CameraRenderer&&) noexcept = default;
CameraRenderer::~CameraRenderer() = default;

Status CameraRenderer::setIntrinsics(const CameraIntrinsics& camera) {
  const Result<CameraModel> model = CameraModel::create(camera);
  if (!model) return model.error();
  impl_->setCamera(*model);
  return Unit{};
}

Status CameraRenderer::drawPicture(const Picture& picture, const Viewport& viewport) {
  return impl_->drawPicture(picture, viewport);
}

Status CameraRenderer::drawPoints(std::span<const TrackedPoint> points,
                                  TrackerKind tracker,
                                  const Viewport& viewport) {
  return impl_->drawPoints(points, tracker, viewport);
}

Status CameraRenderer::drawAr(const ArContent& content,
                              const Pose& T_world_cam,
                              const Viewport& viewport) {
  return impl_->drawAr(content, T_world_cam, viewport);
}

void CameraRenderer::releaseGl() { impl_->releaseGl(); }
void CameraRenderer::abandonGl() { impl_->abandonGl(); }

}  // namespace glide
