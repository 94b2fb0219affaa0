#include "render/scene_buffer.h"

#include <algorithm>

namespace glide {
namespace {

/// Of the smallest buffer: a small map is not worth growing for.
constexpr std::int64_t kMinBytes = 4096;

}  // namespace

bool SceneBuffer::write(const void* data, std::int64_t from, std::int64_t end) {
  if (end > buffer_.bytes()) {
    buffer_ = GlBuffer::allocate(std::max({end, 2 * buffer_.bytes(), kMinBytes}), GL_DYNAMIC_DRAW);
    if (!buffer_.isComplete()) return false;
    from = 0;
  }
  buffer_.writeRange(static_cast<const std::byte*>(data) + from, from, end - from);
  uploaded_bytes_ += end - from;
  return true;
}

}  // namespace glide
