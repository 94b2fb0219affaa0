#pragma once

#include <memory>
#include <mutex>
#include <utility>

namespace glide {

/// The newest immutable value that one thread publishes to others. Any thread may call any member.
/// Holding what load() returned keeps that value alive and unchanged.
template <class T>
class Published {
 public:
  explicit Published(std::shared_ptr<const T> initial) : value_(std::move(initial)) {}

  std::shared_ptr<const T> load() const {
    const std::lock_guard lock(mutex_);
    return value_;
  }

  void store(std::shared_ptr<const T> value) {
    const std::lock_guard lock(mutex_);
    value_.swap(value);
  }  // the old value dies here, outside of nobody's critical path

 private:
  mutable std::mutex mutex_;
  std::shared_ptr<const T> value_;
};

}  // namespace glide
