#pragma once

#include "loop/index_sync.h"
#include "loop/loop_closer.h"
#include "loop/relocalizer.h"

#include "base/published.h"
#include "base/work_queue.h"
#include "base/worker.h"

#include <atomic>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>

namespace glide {

/// What became of a relocalisation query.
struct RelocalizationAnswer {
  std::int64_t t_ns = 0;  ///< of the query
  std::optional<Relocalization> found;
};

/// Recognises places: relocalises lost frames, closes loops and adjusts the whole map after them.
/// On its own thread, or inside the calls when the execution is inline.
class LoopThread {
 public:
  /// `map` outlives this. `correct` is called on the loop thread with corrections of the map; it
  /// may wait until the mapper takes them.
  LoopThread(const Config& config,
             const CameraModel& camera,
             const Published<MapSnapshot>* map,
             std::function<void(MappingMessage)> correct);
  ~LoopThread() { stop(); }

  /// False, and nothing happens, when the loop thread is too far behind. Any thread.
  bool offer(LoopMessage message);

  /// The answer to the last query that was worked off; null before the first.
  std::shared_ptr<const RelocalizationAnswer> answer() const { return answer_.load(); }

  /// Blocks until everything offered so far is worked off, or the thread is stopped. Any thread.
  void waitIdle();

  void close();  ///< as MappingThread::close
  void stop();   ///< as MappingThread::stop

 private:
  void run();
  void work(const LoopMessage& message);
  /// Answers a query with nothing.
  void refuse(const LoopMessage& message);
  void process(const KeyframeMapped& message);
  void process(const RelocalizationQuery& message);
  void process(const LoopClosed& message);
  void process(const MapReplaced& message);
  std::shared_ptr<const MapSnapshot> syncIndex();
  void adjust();

  const Config config_;
  const CameraModel camera_;
  const Published<MapSnapshot>& map_;
  const std::function<void(MappingMessage)> correct_;

  // Any thread.
  WorkQueue<LoopMessage> queue_;
  Published<RelocalizationAnswer> answer_;
  std::atomic<bool> stopped_{false};
  std::atomic<bool> is_wanted_{false};  ///< something waits that is more urgent than an adjustment

  // The loop thread, or the caller's when inline.
  PlaceIndex index_;
  IndexSync sync_;
  Relocalizer relocalizer_;
  LoopCloser closer_;
  bool adjustment_is_due_ = false;

  // The owner's thread.
  std::optional<Worker> worker_;
};

}  // namespace glide
