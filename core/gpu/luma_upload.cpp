#include "gpu/luma_upload.h"

#include <cassert>

namespace glide {

Result<LumaUpload> LumaUpload::create(int width,
                                      int height,
                                      int group_size,
                                      const ProgramCache& programs) {
  Result<ComputeProgram> convert = ComputeProgram::create(
      "luma_to_float.comp", {{"GROUP_ROWS", group_size / kGroupWidth}}, programs);
  if (!convert) return convert.error();
  return LumaUpload(GlTexture::allocate(GL_R8UI, width, height), std::move(*convert), group_size);
}

void LumaUpload::run(const ImageViewU8& luma,
                     const GlTexture& level0,
                     GpuCommands& commands) const {
  assert(luma.width == bytes_.width() && luma.height == bytes_.height());
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, bytes_.get());
  glPixelStorei(GL_UNPACK_ROW_LENGTH, static_cast<GLint>(luma.stride));
  glTexSubImage2D(
      GL_TEXTURE_2D, 0, 0, 0, luma.width, luma.height, GL_RED_INTEGER, GL_UNSIGNED_BYTE, luma.data);

  convert_.use();
  glBindImageTexture(0, level0.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
  // The previous frame's kernels have fetched what the image stores of this frame overwrite.
  commands.barrier(GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
  commands.dispatch(groupCount(luma.width, kGroupWidth),
                    groupCount(luma.height, group_size_ / kGroupWidth));
  commands.barrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // the pyramid fetches level 0
}

}  // namespace glide
