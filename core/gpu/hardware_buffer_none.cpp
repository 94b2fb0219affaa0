#include "gpu/hardware_buffer.h"

namespace glide {

Result<Texture> HardwareBufferTexture::import(const HardwareBuffer&, GlStatePolicy) {
  return Error{ErrorCode::unsupported, "the image: hardware buffers are of Android only"};
}

}  // namespace glide
