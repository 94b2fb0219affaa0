#pragma once

#include "render/scene_array.h"

#include "gpu/gl_objects.h"

#include <cstdint>

namespace glide {

/// The GPU's copy of a SceneArray: takes what has changed, and grows. Inside of a ScopedGlState.
class SceneBuffer {
 public:
  /// Uploads what has changed of `array`, if anything has; false when there is no memory.
  template <class T>
  bool update(SceneArray<T>* array) {
    if (!array->isChanged()) return true;
    constexpr auto kItem = static_cast<std::int64_t>(sizeof(T));
    const auto size = static_cast<std::int64_t>(array->size());
    const auto from = static_cast<std::int64_t>(array->changedFrom());
    if (!write(array->items().data(), kItem * from, kItem * size)) return false;
    array->markUploaded();
    return true;
  }

  GLuint get() const { return buffer_.get(); }
  /// All that was uploaded so far.
  std::int64_t uploadedBytes() const { return uploaded_bytes_; }
  void abandon() { buffer_.abandon(); }

 private:
  /// `data` begins at the buffer's begin; bytes from `from` to `end` are new.
  bool write(const void* data, std::int64_t from, std::int64_t end);

  GlBuffer buffer_;
  std::int64_t uploaded_bytes_ = 0;
};

}  // namespace glide
