#pragma once

#include "mapping/local_mapper.h"

#include "base/published.h"
#include "base/work_queue.h"
#include "base/worker.h"

#include <atomic>
#include <functional>
#include <optional>

namespace glide {

/// Runs the LocalMapper on its own thread, or inside the calls when the execution is inline: the
/// same code, without threads and therefore repeatable.
class MappingThread {
 public:
  /// `published` gets every revision of the map and outlives this. `follow_up` is called on the
  /// mapping thread with what a message means for the loop thread; it must not block.
  MappingThread(const Config& config,
                const CameraModel& camera,
                Published<MapSnapshot>* published,
                std::function<void(LoopMessage)> follow_up);
  ~MappingThread() { stop(); }

  /// Hands a message over; false, and nothing happens, when the mapper is too far behind. Any
  /// thread.
  bool offer(MappingMessage message);

  /// Hands over what must not be lost: waits until there is room. Any thread but the mapping one.
  void send(MappingMessage message);

  /// Hands over what is rare and must not be lost, without waiting for room. Any thread.
  void sendAnyway(MappingMessage message);

  /// Blocks until everything handed over so far is mapped, or the thread is stopped. Any thread.
  void waitIdle();

  /// No more messages are taken, waiting ones are dropped, running work ends early.
  void close();
  /// close(), then waits for the thread to end. By the owner.
  void stop();

 private:
  void run();
  void process(const MappingMessage& message, const std::atomic<bool>* interrupt);

  // Any thread.
  WorkQueue<MappingMessage> queue_;
  std::atomic<bool> interrupt_{false};
  std::atomic<bool> stopped_{false};
  const std::function<void(LoopMessage)> follow_up_;

  // The mapping thread, or the caller's when inline.
  LocalMapper mapper_;

  // The owner's thread.
  std::optional<Worker> worker_;
};

}  // namespace glide
