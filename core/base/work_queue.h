#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <mutex>
#include <optional>
#include <utility>

namespace glide {

/// Bounded, closable queue between threads; one consumer waits. Producers choose whether they wait
/// for room (push) or not (tryPush).
template <class T>
class WorkQueue {
 public:
  explicit WorkQueue(std::size_t capacity) : capacity_(capacity) {}

  /// False, and `item` untouched, when the queue is full or closed.
  bool tryPush(T& item) {
    {
      const std::lock_guard lock(mutex_);
      if (closed_ || items_.size() >= capacity_) return false;
      items_.push_back(std::move(item));
      ++pending_;
      ++pushed_;
    }
    ready_.notify_one();
    return true;
  }

  /// Takes the item although the queue may be full: for what is rare and must not be lost. False,
  /// and `item` untouched, when the queue is closed.
  bool pushAnyway(T& item) {
    {
      const std::lock_guard lock(mutex_);
      if (closed_) return false;
      items_.push_back(std::move(item));
      ++pending_;
      ++pushed_;
    }
    ready_.notify_one();
    return true;
  }

  /// Waits for room. False, and `item` untouched, when the queue is closed.
  bool push(T& item) {
    {
      std::unique_lock lock(mutex_);
      room_.wait(lock, [&] { return closed_ || items_.size() < capacity_; });
      if (closed_) return false;
      items_.push_back(std::move(item));
      ++pending_;
      ++pushed_;
    }
    ready_.notify_one();
    return true;
  }

  /// Waits for an item; nothing once the queue is closed and empty. Call done() after each item.
  std::optional<T> pop() {
    std::unique_lock lock(mutex_);
    ready_.wait(lock, [&] { return closed_ || !items_.empty(); });
    if (items_.empty()) return std::nullopt;
    std::optional<T> item(std::move(items_.front()));
    items_.pop_front();
    lock.unlock();
    room_.notify_one();
    return item;
  }

  /// The consumer has finished with the item it popped last.
  void done() {
    {
      const std::lock_guard lock(mutex_);
      --pending_;
    }
    idle_.notify_all();
  }

  /// Waits until everything pushed so far is done, or the queue is closed; not for what others push
  /// meanwhile.
  void waitIdle() {
    std::unique_lock lock(mutex_);
    const std::size_t wanted = pushed_;
    idle_.wait(lock, [&] { return closed_ || pushed_ - pending_ >= wanted; });
  }

  /// Items that wait; the one being worked on does not count.
  std::size_t size() const {
    const std::lock_guard lock(mutex_);
    return items_.size();
  }

  /// Refuses new items, drops waiting ones and wakes everybody.
  void close() {
    {
      const std::lock_guard lock(mutex_);
      closed_ = true;
      items_.clear();
    }
    ready_.notify_all();
    room_.notify_all();
    idle_.notify_all();
  }

 private:
  const std::size_t capacity_;
  mutable std::mutex mutex_;
  std::condition_variable ready_, room_, idle_;
  std::deque<T> items_;
  std::size_t pending_ = 0, pushed_ = 0;  ///< not done yet, and ever
  bool closed_ = false;
};

}  // namespace glide
