#pragma once

#include "gpu/gl_home.h"
#include "gpu/gpu_commands.h"
#include "gpu/hardware_buffer.h"
#include "gpu/texture_pass.h"

#include "image/image.h"

#include <memory>

namespace glide {

/// Brings the frame that an app's texture shows to the CPU as 8-bit luma
/// (shaders/texture_to_bytes.comp), the same bytes that TextureUpload makes the levels of: one
/// dispatch, one fence, one mapped read. Lives on the GL thread as GpuAligner does; its calls leave
/// the app's GL state as the policy says.
class TextureReader {
 public:
  /// gl when there is no memory. Programs are built when a texture comes.
  static Result<std::unique_ptr<TextureReader>> create(const GlCaps& caps,
                                                       FrameSize frame,
                                                       GlStatePolicy policy,
                                                       const ProgramCache& programs);
  ~TextureReader();
  TextureReader(const TextureReader&) = delete;
  TextureReader& operator=(const TextureReader&) = delete;

  /// The texture that shows an Android buffer until the next call (gpu/hardware_buffer.h).
  Result<Texture> import(const HardwareBuffer& buffer);

  /// Whether the texture can be read. invalid_argument or unsupported naming what is wrong with it,
  /// gl when a shader does not build.
  Status check(const Texture& texture);

  /// Waits for the GPU and copies the frame out; false when the GPU does not answer in time. The
  /// texture passed check(). Sizes `luma`.
  bool read(const Texture& texture, ImageU8* luma);

  /// As Aligner::isUsable.
  bool isUsable() const { return home_.isHere(); }
  /// As Aligner::abandon.
  void abandon();

 private:
  TextureReader(GlHome home, TexturePass pass, GlBuffer bytes, GlStatePolicy policy);
  void submit(const Texture& texture, int words_per_row);

  GlHome home_;
  TexturePass pass_;
  GlBuffer bytes_;
  HardwareBufferTexture buffer_texture_;
  GlStatePolicy policy_;
  GpuCommands commands_;
};

}  // namespace glide
