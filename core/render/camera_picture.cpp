#include "render/camera_picture.h"

#include "render/render_program.h"
#include "render/render_visit.h"

#include "gpu/gl_sampler.h"
#include "gpu/gl_state.h"
#include "gpu/texture_check.h"

#include <string>
#include <string_view>
#include <utility>

namespace glide {
namespace {

// One triangle that covers the rectangle: no diagonal along which fragments are made twice.
constexpr std::array<float, 6> kCorners{-1.0F, -1.0F, 3.0F, -1.0F, -1.0F, 3.0F};
// Where four samples lie of a pixel that covers several of the picture's, px from its centre.
constexpr float kTap = 0.25F;

Error invalid(const std::string& what) { return {ErrorCode::invalid_argument, "picture" + what}; }

/// Messages of the textures' checks begin with what is the image of a frame there.
Error ofPicture(const Error& error) {
  constexpr std::string_view kField = "the image";
  const std::string_view message = error.message;
  if (message.substr(0, kField.size()) != kField) return error;
  return {error.code, std::string("picture").append(message.substr(kField.size()))};
}

Status checkPixels(const void* pixels,
                   FrameSize size,
                   std::ptrdiff_t row_bytes,
                   std::ptrdiff_t stride) {
  if (pixels == nullptr || size.width <= 0 || size.height <= 0) return invalid(" has no pixels");
  if (stride < row_bytes) return invalid(".stride is less than a row");
  return Unit{};
}

/// Where pixels lie in a texture of ours of their size, the uppermost row first.
TexturePlacement placePixels(FrameSize size) {
  const Texture own{1, GL_TEXTURE_2D, size.width, size.height, kUpperRowFirst};
  return placeTexture(own, size);
}

}  // namespace

FrameSize pictureSize(const Picture& picture, FrameSize camera) {
  if (const auto* luma = std::get_if<Luma>(&picture)) return {luma->width, luma->height};
  if (const auto* rgb = std::get_if<Rgb>(&picture)) return {rgb->width, rgb->height};
  return camera;
}

Status checkPicture(const Picture& picture, FrameSize camera) {
  const FrameSize size = pictureSize(picture, camera);
  if (const auto* luma = std::get_if<Luma>(&picture))
    return checkPixels(luma->pixels, size, size.width, luma->stride);
  if (const auto* rgb = std::get_if<Rgb>(&picture))
    return checkPixels(rgb->pixels, size, std::ptrdiff_t{3} * size.width, rgb->stride);
  const Status placed = checkPlacement(std::get<Texture>(picture), camera);
  if (!placed) return ofPicture(placed.error());
  return Unit{};
}

Result<CameraPicture::Painter> CameraPicture::Painter::create(const char* name) {
  Result<GlProgram> program = buildRenderProgram(name, name);
  if (!program) return program.error();
  Painter made;
  const GLuint id = program->get();
  made.corner = static_cast<GLuint>(glGetAttribLocation(id, "corner"));
  made.upper_left = glGetUniformLocation(id, "upper_left");
  made.origin = glGetUniformLocation(id, "origin");
  made.per_x = glGetUniformLocation(id, "per_x");
  made.per_y = glGetUniformLocation(id, "per_y");
  made.tap = glGetUniformLocation(id, "tap");
  made.grey = glGetUniformLocation(id, "grey");
  made.program = std::move(*program);
  return made;
}

CameraPicture::CameraPicture(Painter painter, GlBuffer corners) noexcept
    : plain_(std::move(painter)),
      corners_(std::move(corners)),
      nearest_(makeClampedSampler(GL_NEAREST)),
      linear_(makeClampedSampler(GL_LINEAR)) {}

Result<CameraPicture> CameraPicture::create(const GlCaps& caps, GlStatePolicy policy) {
  Result<Painter> painter = Painter::create("render_camera_picture");
  if (!painter) return painter.error();
  GlBuffer corners = GlBuffer::allocate(sizeof(kCorners), GL_STATIC_DRAW);
  if (!corners.isComplete()) return outOfMemory("the camera's picture");
  corners.write(kCorners.data(), sizeof(kCorners));
  CameraPicture made(std::move(*painter), std::move(corners));
  made.has_external_ = caps.has_external;
  made.policy_ = policy;
  if (made.nearest_.get() == 0 || made.linear_.get() == 0) return outOfMemory("a sampler object");
  return made;
}

Status CameraPicture::draw(const Picture& picture, FrameSize camera, const PictureLayout& layout) {
  if (const auto* texture = std::get_if<Texture>(&picture)) {
    const Status drawn = texture->target == GL_TEXTURE_EXTERNAL_OES
                             ? drawExternal(*texture, camera, layout)
                             : drawTexture(*texture, camera, layout);
    if (!drawn) return ofPicture(drawn.error());
    return Unit{};
  }
  const auto* luma = std::get_if<Luma>(&picture);
  Status uploaded =
      luma != nullptr ? pixels_.upload(*luma) : pixels_.upload(std::get<Rgb>(picture));
  if (!uploaded) return uploaded;
  const FrameSize size = pictureSize(picture, camera);
  paint(plain_, {placePixels(size), size, luma != nullptr}, layout);
  return Unit{};
}

Status CameraPicture::drawTexture(const Texture& texture,
                                  FrameSize camera,
                                  const PictureLayout& layout) {
  Status checked = checkTextureObject(texture, GlStatePolicy::none);
  if (!checked) return checked;
  glBindTexture(GL_TEXTURE_2D, texture.name);
  paint(plain_, {placeTexture(texture, camera), camera, isBoundTextureGrey()}, layout);
  return Unit{};
}

Status CameraPicture::drawExternal(const Texture& texture,
                                   FrameSize camera,
                                   const PictureLayout& layout) {
  if (!has_external_)
    return Error{ErrorCode::unsupported,
                 "picture: this OpenGL ES has no GL_OES_EGL_image_external"};
  if (!external_) {
    Result<Painter> built = Painter::create("render_camera_external");
    if (!built) return built.error();
    external_ = std::move(*built);
  }
  const ScopedTextureBinding binding(
      policy_, GL_TEXTURE_EXTERNAL_OES, GL_TEXTURE_BINDING_EXTERNAL_OES);
  Status checked = checkTextureObject(texture, GlStatePolicy::none);
  if (!checked) return checked;
  glBindTexture(GL_TEXTURE_EXTERNAL_OES, texture.name);
  paint(*external_, {placeTexture(texture, camera), camera, false}, layout);
  return Unit{};
}

void CameraPicture::paint(const Painter& painter,
                          const Source& source,
                          const PictureLayout& layout) const {
  const Viewport& area = layout.area;
  const bool is_one_to_one = area.width == source.size.width && area.height == source.size.height;
  const TexturePlacement& place = source.place;
  const float columns = static_cast<float>(source.size.width) / static_cast<float>(area.width);
  const float rows = static_cast<float>(source.size.height) / static_cast<float>(area.height);
  glViewport(area.x, area.y, area.width, area.height);
  glBindSampler(0, is_one_to_one && place.hits_texels ? nearest_.get() : linear_.get());
  glUseProgram(painter.program.get());
  glUniform2f(
      painter.upper_left, static_cast<GLfloat>(area.x), static_cast<GLfloat>(area.y + area.height));
  // The corner of the first pixel, not its centre.
  glUniform2f(painter.origin,
              place.origin[0] - 0.5F * (place.per_column[0] + place.per_row[0]),
              place.origin[1] - 0.5F * (place.per_column[1] + place.per_row[1]));
  glUniform2f(painter.per_x, columns * place.per_column[0], columns * place.per_column[1]);
  glUniform2f(painter.per_y, rows * place.per_row[0], rows * place.per_row[1]);
  glUniform1f(painter.tap, columns > 1.0F ? kTap : 0.0F);
  glUniform1f(painter.grey, source.is_grey ? 1.0F : 0.0F);
  glEnableVertexAttribArray(painter.corner);
  glVertexAttribFormat(painter.corner, 2, GL_FLOAT, GL_FALSE, 0);
  glVertexAttribBinding(painter.corner, 0);
  glBindVertexBuffer(0, corners_.get(), 0, 2 * sizeof(float));
  setBlending(Blending::off);
  glDrawArrays(GL_TRIANGLES, 0, 3);
  glDisableVertexAttribArray(painter.corner);
  glBindSampler(0, 0);
}

void CameraPicture::abandon() {
  plain_.program.abandon();
  if (external_) external_->program.abandon();
  abandonAll(corners_, nearest_, linear_, pixels_);
}

}  // namespace glide
