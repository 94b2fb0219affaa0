#pragma once

#include "gpu/gl.h"

#include <array>

namespace glide {

/// Saves the GL state that core/gpu touches, makes it neutral, and puts it back on destruction:
/// program; active texture; of unit 0 the 2-D texture and the sampler; image unit 0; the indexed
/// shader storage bindings 0..3 and uniform binding 0 with the generic bindings of both;
/// GL_PIXEL_UNPACK_BUFFER, alignment, row length, skipped rows and pixels. docs/gl-contract.md
/// lists the same.
class ScopedGlState {
 public:
  ScopedGlState();
  ~ScopedGlState();
  ScopedGlState(const ScopedGlState&) = delete;
  ScopedGlState& operator=(const ScopedGlState&) = delete;

  /// Shader storage bindings 0..3: what ES 3.1 guarantees, and all that our kernels use.
  static constexpr int kStorageBindings = 4;

 private:
  struct IndexedBuffer {
    GLint name = 0;
    GLint64 start = 0, size = 0;
  };
  struct ImageUnit {
    GLint name = 0, level = 0, layered = 0, layer = 0, access = 0, format = 0;
  };
  struct PixelUnpack {
    GLint buffer = 0, alignment = 0, row_length = 0, skip_rows = 0, skip_pixels = 0;
  };

  void saveTextures();
  void saveBuffers();
  void restoreTextures() const;
  void restoreBuffers() const;

  GLint program_ = 0, active_texture_ = 0, texture_ = 0, sampler_ = 0;
  ImageUnit image_;
  PixelUnpack unpack_;
  GLint storage_ = 0, uniform_ = 0;
  std::array<IndexedBuffer, kStorageBindings> storage_bindings_{};
  IndexedBuffer uniform_binding_;
};

}  // namespace glide
