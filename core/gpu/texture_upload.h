#pragma once

#include "gpu/gpu_commands.h"
#include "gpu/texture_pass.h"

namespace glide {

/// Brings the frame that an app's texture shows to level 0 of a pyramid, in one pass
/// (shaders/texture_to_float.comp): the same grey levels as LumaUpload makes of the frame's pixels.
class TextureUpload {
 public:
  /// Makes no GL call: programs are built when a texture comes.
  TextureUpload(const GlCaps& caps, FrameSize frame, int group_size, const ProgramCache& programs);

  /// Converts into `level0`, barriered for texture fetches. Errors as TexturePass::prepare. Inside
  /// of a ScopedGlState of that policy.
  Status run(const Texture& texture,
             const GlTexture& level0,
             GlStatePolicy policy,
             GpuCommands& commands);
  void abandon() { pass_.abandon(); }

 private:
  TexturePass pass_;
};

}  // namespace glide
