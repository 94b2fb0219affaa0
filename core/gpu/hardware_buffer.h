#pragma once

#include "gpu/gl_objects.h"

#include "glide/config.h"
#include "glide/frame.h"
#include "glide/result.h"

namespace glide {

/// The external texture through which Android's hardware buffers are sampled. Implemented in
/// hardware_buffer_android.cpp and, for all other systems, hardware_buffer_none.cpp.
class HardwareBufferTexture {
 public:
  /// Lets the texture show `buffer`, whose memory it keeps until the next one comes. Inside of a
  /// ScopedGlState of that policy. invalid_argument or unsupported naming what is wrong with the
  /// buffer, gl when the driver does not take it.
  Result<Texture> import(const HardwareBuffer& buffer, GlStatePolicy policy);
  void abandon() { texture_.abandon(); }

 private:
  GlName<deleteTexture> texture_;
};

}  // namespace glide
