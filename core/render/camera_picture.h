#pragma once

#include "render/camera_layout.h"
#include "render/camera_pixels.h"

#include "gpu/gl_caps.h"
#include "gpu/gl_objects.h"

#include "glide/config.h"

#include <optional>

namespace glide {

/// Size of what the picture shows, px: a texture shows a frame of the camera's size.
FrameSize pictureSize(const Picture& picture, FrameSize camera);

/// invalid_argument when it has no pixels, or is a texture that cannot show a frame of that size.
Status checkPicture(const Picture& picture, FrameSize camera);

/// Draws pictures into rectangles of the framebuffer: pixel by pixel where both have the same size,
/// else filtered. Lives in one share group; its functions are called inside of a RenderVisit.
class CameraPicture {
 public:
  static Result<CameraPicture> create(const GlCaps& caps, GlStatePolicy policy);

  /// The picture, which passed checkPicture, into the whole rectangle. invalid_argument naming what
  /// is wrong with a texture, unsupported for an external one without the extension, gl when there
  /// is no memory or a shader does not build.
  Status draw(const Picture& picture, FrameSize camera, const PictureLayout& layout);
  void abandon();

 private:
  /// A program for one kind of texture.
  struct Painter {
    GlProgram program;
    GLuint corner = 0;  ///< attribute
    GLint upper_left = -1, origin = -1, per_x = -1, per_y = -1, tap = -1, grey = -1;
    static Result<Painter> create(const char* name);
  };
  /// What is sampled, and how the picture lies in it.
  struct Source {
    TexturePlacement place;  ///< of the picture's pixels
    FrameSize size;          ///< of the picture, px
    bool is_grey = false;
  };

  CameraPicture(Painter painter, GlBuffer corners) noexcept;
  Status drawTexture(const Texture& texture, FrameSize camera, const PictureLayout& layout);
  Status drawExternal(const Texture& texture, FrameSize camera, const PictureLayout& layout);
  void paint(const Painter& painter, const Source& source, const PictureLayout& layout) const;

  Painter plain_;
  std::optional<Painter> external_;  ///< built when the first such texture comes
  GlBuffer corners_;
  GlSampler nearest_, linear_;
  CameraPixels pixels_;
  bool has_external_ = false;
  GlStatePolicy policy_ = GlStatePolicy::preserve;
};

}  // namespace glide
