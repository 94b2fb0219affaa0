#pragma once

#include "capi/status.h"

#include <algorithm>
#include <cstddef>

namespace glide {

/// The array and count of the two-call idiom.
template <class T>
struct CountedOut {
  std::size_t capacity = 0;
  T* values = nullptr;
  std::size_t* count = nullptr;

  bool isValid() const { return count != nullptr && (values != nullptr || capacity == 0); }

  /// Writes value(i) for i < size as far as there is room.
  template <class Value>
  glide_status fill(std::size_t size, Value&& value) const {
    *count = size;
    const std::size_t written = std::min(size, capacity);
    for (std::size_t i = 0; i < written; ++i) values[i] = value(i);
    return size > capacity ? GLIDE_TRUNCATED : GLIDE_OK;
  }
};

}  // namespace glide
