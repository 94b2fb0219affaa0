#include "gpu/texture_upload.h"

namespace glide {

TextureUpload::TextureUpload(const GlCaps& caps,
                             FrameSize frame,
                             int group_size,
                             const ProgramCache& programs)
    : pass_({"texture_to_float.comp", group_size, programs}, caps, frame) {}

Status TextureUpload::run(const Texture& texture,
                          const GlTexture& level0,
                          GlStatePolicy policy,
                          GpuCommands& commands) {
  if (!pass_.isPrepared(texture)) {
    Status prepared = pass_.prepare(texture, policy);
    if (!prepared) return prepared;
  }
  TextureBinding binding;
  pass_.bind(texture, policy, &binding);
  glBindImageTexture(0, level0.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  // The previous frame's kernels have fetched what the image stores of this frame overwrite.
  commands.barrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  commands.dispatch(groupCount(pass_.frame().width, kGroupWidth),
                    groupCount(pass_.frame().height, pass_.groupSize() / kGroupWidth));
  commands.barrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // the pyramid fetches level 0
  return Unit{};
}

}  // namespace glide
