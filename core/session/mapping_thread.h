#pragma once

#include "mapping/local_mapper.h"

#include "base/published.h"
#include "base/work_queue.h"
#include "base/worker.h"

#include <atomic>
#include <memory>
#include <optional>

namespace glide {

/// Runs the LocalMapper on its own thread, or inside offer() when the execution is inline: the same
/// code, without threads and therefore repeatable. Made, used and destroyed by the thread that
/// calls update().
class MappingThread {
 public:
  MappingThread(const Config& config, const CameraModel& camera);
  ~MappingThread();

  /// Hands a message over; false, and nothing happens, when the mapper is too far behind.
  /// Milliseconds spent here go to `inline_ms` (zero when threaded).
  bool offer(MappingMessage message, double* inline_ms);

  /// Nothing waits and nothing is being worked on.
  bool isIdle() const { return queue_.isIdle(); }

  std::shared_ptr<const MapSnapshot> snapshot() const { return published_.load(); }

  /// Blocks until everything offered is mapped.
  void waitIdle();

 private:
  void run();

  // Any thread.
  Published<MapSnapshot> published_;
  WorkQueue<MappingMessage> queue_;
  std::atomic<bool> interrupt_{false};

  // The mapping thread, or the owner's when inline.
  LocalMapper mapper_;

  // The owner's thread. Last, so that it is joined before anything else dies.
  std::optional<Worker> worker_;
};

}  // namespace glide
