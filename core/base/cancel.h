#pragma once

#include <atomic>

namespace glide {

/// Whether work that was given this flag should end early; null means that nobody will ask it to.
inline bool isCancelled(const std::atomic<bool>* cancel) {
  return cancel != nullptr && cancel->load();
}

}  // namespace glide
