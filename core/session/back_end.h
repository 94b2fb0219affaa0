#pragma once

#include "session/loop_thread.h"
#include "session/mapping_thread.h"

#include <memory>

namespace glide {

/// Everything that happens to the map: mapping and place recognition, each on its thread, talking
/// through messages. Made, used and destroyed by the thread that calls update(), but for
/// snapshot().
class BackEnd {
 public:
  BackEnd(const Config& config, const CameraModel& camera);
  ~BackEnd();
  BackEnd(const BackEnd&) = delete;
  BackEnd& operator=(const BackEnd&) = delete;

  /// Hands a message to the mapper; false, and nothing happens, when it is too far behind.
  bool offer(MappingMessage message) { return mapping_.offer(std::move(message)); }
  /// Hands over what must not be lost; waits until there is room.
  void send(MappingMessage message) { mapping_.send(std::move(message)); }

  /// Asks where a lost frame is. One question at a time: false while one is open.
  bool ask(RelocalizationQuery query);
  /// The answer to the last question; null before the first.
  std::shared_ptr<const RelocalizationAnswer> answer() const { return loop_.answer(); }

  std::shared_ptr<const MapSnapshot> snapshot() const { return map_.load(); }

  /// Blocks until everything handed over is mapped; what follows from it may still be under way.
  void waitMapped() { mapping_.waitIdle(); }
  /// Blocks until everything handed over, and what followed from it, is worked off.
  void waitIdle();

 private:
  Published<MapSnapshot> map_;
  std::int64_t open_query_;  ///< t_ns of the last question that was asked
  MappingThread mapping_;
  LoopThread loop_;
};

}  // namespace glide
