#pragma once

#include <algorithm>
#include <condition_variable>
#include <cstdint>
#include <memory>
#include <mutex>
#include <thread>
#include <unordered_map>
#include <utility>
#include <vector>

namespace glide {

/// Objects by the opaque handles that C callers hold. A handle is a number that is never given
/// twice, so that a stale one is recognised instead of followed. Any thread. Lives as long as what
/// find() returned.
template <class T, class Handle>
class HandleTable {
  struct Entry {
    std::shared_ptr<T> object;
    std::vector<std::thread::id> callers;  ///< of the calls that use it
  };

 public:
  /// The use of an object by one call, on one thread; remove() waits for its end.
  class Use {
   public:
    Use(HandleTable* table, std::shared_ptr<Entry> entry)
        : table_(table), entry_(std::move(entry)) {}
    ~Use() {
      if (entry_) table_->end(entry_.get());
    }
    Use(const Use&) = delete;
    Use& operator=(const Use&) = delete;

    explicit operator bool() const { return entry_ != nullptr; }
    T& operator*() const { return *entry_->object; }

   private:
    HandleTable* table_;
    std::shared_ptr<Entry> entry_;
  };

  /// Handles of tables with another `first` (below 16) are never taken for this one's.
  explicit HandleTable(std::uintptr_t first) : next_(kStep + first) {}

  Handle* add(std::shared_ptr<T> object) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const std::uintptr_t number = next_;
    next_ += kStep;
    entries_.emplace(number, std::make_shared<Entry>(Entry{std::move(object), {}}));
    return reinterpret_cast<Handle*>(number);  // NOLINT(performance-no-int-to-ptr): never followed
  }
  /// False when there is no such object.
  Use find(const Handle* handle) {
    const std::lock_guard<std::mutex> lock(mutex_);
    const auto found = entries_.find(reinterpret_cast<std::uintptr_t>(handle));
    if (found == entries_.end()) return Use(this, nullptr);
    found->second->callers.push_back(std::this_thread::get_id());
    return Use(this, found->second);
  }
  /// Takes it out, and waits for the calls that use it: it is the caller's alone then. Null when
  /// there is no such object, and to a callback of a call that uses it: such a one cannot be waited
  /// for, and frees the object when it ends.
  std::shared_ptr<T> remove(const Handle* handle) {
    std::unique_lock<std::mutex> lock(mutex_);
    const auto found = entries_.find(reinterpret_cast<std::uintptr_t>(handle));
    if (found == entries_.end()) return nullptr;
    const std::shared_ptr<Entry> entry = std::move(found->second);
    entries_.erase(found);
    const std::vector<std::thread::id>& callers = entry->callers;
    const auto self = std::find(callers.begin(), callers.end(), std::this_thread::get_id());
    if (self != callers.end()) return nullptr;
    ended_.wait(lock, [&] { return callers.empty(); });
    return std::move(entry->object);
  }
  /// Takes out all that no call uses; the others stay theirs, without a handle.
  std::vector<std::shared_ptr<T>> removeIdle() {
    const std::lock_guard<std::mutex> lock(mutex_);
    std::vector<std::shared_ptr<T>> idle;
    for (auto& [number, entry] : entries_) {
      if (entry->callers.empty()) idle.push_back(std::move(entry->object));
    }
    entries_.clear();
    return idle;
  }

 private:
  static constexpr std::uintptr_t kStep = 16;  // looks like an aligned pointer, is none

  void end(Entry* entry) {
    {
      const std::lock_guard<std::mutex> lock(mutex_);
      std::vector<std::thread::id>& callers = entry->callers;
      callers.erase(std::find(callers.begin(), callers.end(), std::this_thread::get_id()));
    }
    ended_.notify_all();
  }

  std::mutex mutex_;
  std::condition_variable ended_;
  std::unordered_map<std::uintptr_t, std::shared_ptr<Entry>> entries_;
  std::uintptr_t next_;
};

}  // namespace glide
