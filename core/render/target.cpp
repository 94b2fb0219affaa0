#include "render/gl_render_state.h"
#include "render/target_state.h"
#include "render/target_surface.h"

#include "gpu/gl_caps.h"
#include "gpu/gl_home.h"
#include "gpu/gl_query.h"
#include "gpu/gl_raster_state.h"

#include "glide/render_target.h"

#include <algorithm>
#include <optional>
#include <string>
#include <utility>

namespace glide {
namespace {

// What every OpenGL ES 3.1 has for RGBA8, if it is multisampled at all.
constexpr GLint kSamples = 4;

/// Around all GL work here: whatever the app has set stays.
struct TargetVisit {
  ScopedState<GlTargetState> target{GlStatePolicy::preserve};
  ScopedState<GlRasterState> raster{GlStatePolicy::preserve};
};

GLint supportedSamples() {
  GLint most = 0;  // the first of a list that begins with the largest
  glGetInternalformativ(GL_RENDERBUFFER, GL_RGBA8, GL_SAMPLES, 1, &most);
  return std::min(most, kSamples);
}

Status checkSize(int width, int height) {
  if (width <= 0 || height <= 0)
    return Error{ErrorCode::invalid_argument,
                 "render target: width and height must be positive, not " + std::to_string(width) +
                     "x" + std::to_string(height)};
  const GLint most = glInteger(GL_MAX_RENDERBUFFER_SIZE);
  if (width > most || height > most)
    return Error{ErrorCode::invalid_argument,
                 "render target: " + std::to_string(width) + "x" + std::to_string(height) +
                     " is more than this context's " + std::to_string(most) + " px"};
  return Unit{};
}

/// What lies in one context.
struct TargetObjects {
  GlHome home;
  TargetSurface drawn;     ///< multisampled where the context can, with depth
  TargetSurface resolved;  ///< what is read back; not made where the first is not multisampled
  bool is_multisampled = false;

  /// Inside of a TargetVisit.
  static Result<TargetObjects> create(int width, int height) {
    Result<GlHome> home = GlHome::create();
    if (!home) return home.error();
    TargetObjects made{std::move(*home), {}, {}, supportedSamples() > 1};
    const GLint samples = made.is_multisampled ? supportedSamples() : 0;
    made.drawn = TargetSurface::allocate({width, height, samples, TargetSurface::Depth::attached});
    bool complete = made.drawn.isComplete();
    if (made.is_multisampled) {
      made.resolved = TargetSurface::allocate({width, height, 0, TargetSurface::Depth::none});
      complete = complete && made.resolved.isComplete();
    }
    if (!complete) return outOfMemory("a render target");
    return made;
  }
  void abandon() { abandonAll(home, drawn, resolved); }
  void abandonFramebuffers() {
    drawn.abandonFramebuffer();
    resolved.abandonFramebuffer();
  }
};

/// Of RGBA rows the lowest first.
std::vector<std::uint8_t> upperRowFirst(const std::vector<std::uint8_t>& rgba, int width) {
  const auto columns = static_cast<std::size_t>(width);
  const std::size_t rows = rgba.size() / (4 * columns);
  std::vector<std::uint8_t> rgb(rows * columns * 3);
  std::uint8_t* out = rgb.data();
  for (std::size_t row = rows; row-- > 0;) {
    const std::uint8_t* in = rgba.data() + row * columns * 4;
    for (std::size_t i = 0; i < columns; ++i, in += 4) out = std::copy_n(in, 3, out);
  }
  return rgb;
}

}  // namespace

class RenderTarget::Impl {
 public:
  Impl(int width, int height) : width_(width), height_(height) {}
  Impl(const Impl&) = delete;
  Impl& operator=(const Impl&) = delete;
  ~Impl() { leave(); }

  int width() const { return width_; }
  int height() const { return height_; }
  Status settle();
  Status begin(const Color& background);
  std::vector<std::uint8_t> readRgb() const;
  void abandonGl() {
    if (objects_) objects_->abandon();
    objects_.reset();
  }

 private:
  bool isHere() const { return objects_ && objects_->home.isHere() && objects_->home.isCreator(); }
  void leave();

  int width_, height_;
  std::optional<TargetObjects> objects_;
};

/// Makes the objects in the current context, unless they are there.
Status RenderTarget::Impl::settle() {
  if (isHere()) return Unit{};
  if (const Result<GlCaps> caps = GlCaps::query(); !caps) return caps.error();
  if (Status size = checkSize(width_, height_); !size) return size;
  leave();
  const TargetVisit visit;
  Result<TargetObjects> made = TargetObjects::create(width_, height_);
  if (!made) return made.error();
  objects_.emplace(std::move(*made));
  return Unit{};
}

/// Deletes of the objects what the current context has.
void RenderTarget::Impl::leave() {
  if (!objects_) return;
  if (!objects_->home.isHere()) return abandonGl();
  if (!objects_->home.isCreator()) objects_->abandonFramebuffers();
  objects_.reset();
}

Status RenderTarget::Impl::begin(const Color& background) {
  if (Status settled = settle(); !settled) return settled;
  const ScopedState<GlRasterState> raster(GlStatePolicy::preserve);
  const ScopedRenderState depth(GlStatePolicy::preserve);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, objects_->drawn.framebuffer());
  glClearBufferfv(GL_COLOR, 0, background.data());
  constexpr GLfloat kFarthest = 1.0F;
  glClearBufferfv(GL_DEPTH, 0, &kFarthest);
  return Unit{};
}

std::vector<std::uint8_t> RenderTarget::Impl::readRgb() const {
  if (!isHere()) return {};
  const TargetVisit visit;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, objects_->drawn.framebuffer());
  if (objects_->is_multisampled) {
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, objects_->resolved.framebuffer());
    glBlitFramebuffer(
        0, 0, width_, height_, 0, 0, width_, height_, GL_COLOR_BUFFER_BIT, GL_NEAREST);
    glBindFramebuffer(GL_READ_FRAMEBUFFER, objects_->resolved.framebuffer());
  }
  std::vector<std::uint8_t> rgba(static_cast<std::size_t>(width_) *
                                 static_cast<std::size_t>(height_) * 4);
  glReadPixels(0, 0, width_, height_, GL_RGBA, GL_UNSIGNED_BYTE, rgba.data());
  return upperRowFirst(rgba, width_);
}

Result<RenderTarget> RenderTarget::create(int width, int height) {
  auto impl = std::make_unique<Impl>(width, height);
  if (Status settled = impl->settle(); !settled) return settled.error();
  return RenderTarget(std::move(impl));
}

RenderTarget::RenderTarget(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
RenderTarget::RenderTarget(RenderTarget&&) noexcept = default;
RenderTarget& RenderTarget::operator=(RenderTarget&&) noexcept = default;
RenderTarget::~RenderTarget() = default;

int RenderTarget::width() const { return impl_->width(); }
int RenderTarget::height() const { return impl_->height(); }
Status RenderTarget::begin(const Color& background) { return impl_->begin(background); }
std::vector<std::uint8_t> RenderTarget::readRgb() { return impl_->readRgb(); }
void RenderTarget::abandonGl() { impl_->abandonGl(); }

}  // namespace glide
