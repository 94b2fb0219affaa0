#pragma once

#include "gpu/gl.h"
#include "gpu/scoped_state.h"

#include <array>

namespace glide {

/// The GL state that the compute kernels of core/gpu touch; docs/gl-contract.md lists the same. The
/// fields' defaults are the initial values of OpenGL ES.
struct GlComputeState {
  // The most that a shader of ours binds (a test looks at their layouts).
  static constexpr std::size_t kTextureUnits = 1;
  static constexpr std::size_t kImageUnits = 1;
  static constexpr std::size_t kStorageBindings = 4;  ///< what ES 3.1 guarantees
  static constexpr std::size_t kUniformBindings = 1;

  struct TextureUnit {
    GLint texture_2d = 0, sampler = 0;
  };
  struct ImageUnit {
    GLint name = 0, level = 0, layered = 0, layer = 0, access = GL_READ_ONLY, format = GL_R32UI;
  };
  struct IndexedBuffer {
    GLint name = 0;
    GLint64 start = 0, size = 0;
  };
  struct PixelUnpack {
    GLint buffer = 0, alignment = 4, row_length = 0, skip_rows = 0, skip_pixels = 0;
  };

  GLint program = 0;
  GLint active_texture = GL_TEXTURE0;
  std::array<TextureUnit, kTextureUnits> textures{};
  std::array<ImageUnit, kImageUnits> images{};
  PixelUnpack unpack;
  GLint storage_buffer = 0, uniform_buffer = 0;  ///< not indexed
  std::array<IndexedBuffer, kStorageBindings> storage{};
  std::array<IndexedBuffer, kUniformBindings> uniform{};
  /// The app's transform feedback was running: it is paused, since it forbids other programs.
  bool is_feedback_running = false;

  static GlComputeState current();
  static GlComputeState initial() { return {}; }
  void apply() const;
  /// No samplers on our units (one that filters linearly would make r32f textures incomplete); rows
  /// of pixels without gaps, from memory; a running transform feedback paused.
  static void neutralize();
};

/// Around all work of core/gpu in the app's context.
using ScopedGlState = ScopedState<GlComputeState>;

/// Likewise for one more texture target of unit 0, such as GL_TEXTURE_EXTERNAL_OES where the
/// extension is.
class ScopedTextureBinding {
 public:
  /// `binding` is the query of the target's binding, GL_TEXTURE_BINDING_*.
  ScopedTextureBinding(GlStatePolicy policy, GLenum target, GLenum binding);
  ~ScopedTextureBinding();
  ScopedTextureBinding(const ScopedTextureBinding&) = delete;
  ScopedTextureBinding& operator=(const ScopedTextureBinding&) = delete;

 private:
  GlStatePolicy policy_;
  GLenum target_;
  GLint texture_ = 0;
};

}  // namespace glide
