#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>

namespace glide {

/// Objects by the opaque handles that C callers hold. A handle is a number that is never given
/// twice, so that a stale one is recognised instead of followed. Any thread.
template <class T, class Handle>
class HandleTable {
 public:
  /// Handles of tables with another `first` (below 16) are never taken for this one's.
  explicit HandleTable(std::uintptr_t first) : next_(kStep + first) {}

  Handle* add(std::shared_ptr<T> object) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::uintptr_t number = next_;
    next_ += kStep;
    objects_.emplace(number, std::move(object));
    return reinterpret_cast<Handle*>(number);  // NOLINT(performance-no-int-to-ptr): never followed
  }
  /// Null when there is no such object.
  std::shared_ptr<T> find(const Handle* handle) const {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = objects_.find(reinterpret_cast<std::uintptr_t>(handle));
    return found == objects_.end() ? nullptr : found->second;
  }
  /// Takes it out; null when there is no such object.
  std::shared_ptr<T> remove(const Handle* handle) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = objects_.find(reinterpret_cast<std::uintptr_t>(handle));
    if (found == objects_.end()) return nullptr;
    std::shared_ptr<T> object = std::move(found->second);
    objects_.erase(found);
    return object;
  }

 private:
  static constexpr std::uintptr_t kStep = 16;  // looks like an aligned pointer, is none

  mutable std::mutex mutex_;
  std::unordered_map<std::uintptr_t, std::shared_ptr<T>> objects_;
  std::uintptr_t next_;
};

}  // namespace glide
