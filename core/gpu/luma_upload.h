#pragma once

#include "gpu/compute_program.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_commands.h"

#include "image/image.h"

namespace glide {

/// Brings 8-bit images of one size to the GPU as level 0 of a pyramid (shaders/luma_to_float.comp).
class LumaUpload {
 public:
  static Result<LumaUpload> create(int width,
                                   int height,
                                   int group_size,
                                   const ProgramCache& programs);

  /// Copies `luma`, which has the size given at creation, and converts it into `level0`, barriered
  /// for texture fetches. Pixel unpack state is neutral (ScopedGlState); the row length is left
  /// changed.
  void run(const ImageViewU8& luma, const GlTexture& level0, GpuCommands& commands) const;
  bool isComplete() const { return bytes_.isComplete(); }
  void abandon() { abandonAll(bytes_, convert_); }

 private:
  LumaUpload(GlTexture bytes, ComputeProgram convert, int group_size)
      : bytes_(std::move(bytes)), convert_(std::move(convert)), group_size_(group_size) {}

  GlTexture bytes_;
  ComputeProgram convert_;
  int group_size_;
};

}  // namespace glide
