#pragma once

#include "session/loop_thread.h"
#include "session/mapping_thread.h"

#include <atomic>
#include <cstddef>
#include <memory>

namespace glide {

/// Everything that happens to the map: mapping and place recognition, each on its thread, talking
/// through messages. Made, used and destroyed by the thread that calls update(), but for snapshot()
/// and waitIdle(), which any thread may call.
class BackEnd {
 public:
  BackEnd(const Config& config, const CameraModel& camera);
  ~BackEnd();
  BackEnd(const BackEnd&) = delete;
  BackEnd& operator=(const BackEnd&) = delete;

  /// Hands a message to the mapper; false, and nothing happens, when it is too far behind.
  bool offer(MappingMessage message) { return mapping_.offer(std::move(message)); }
  /// Hands over what is rare and must not be lost, without waiting for room: the one way past the
  /// queue's limit, taken at the pace of an app's resets and loads.
  void send(MappingMessage message) { mapping_.sendAnyway(std::move(message)); }

  /// Asks where a lost frame is. One question at a time: false while one is open.
  bool ask(RelocalizationQuery query);
  /// The answer to the last question; null before the first.
  std::shared_ptr<const RelocalizationAnswer> answer() const { return loop_.answer(); }

  std::shared_ptr<const MapSnapshot> snapshot() const { return map_.load(); }

  /// Blocks until everything handed over so far, and what followed from it, is worked off; not for
  /// what is handed over meanwhile.
  void waitIdle();

 private:
  Published<MapSnapshot> map_;
  std::atomic<std::size_t> corrections_{0};  ///< that the loop thread has sent to the mapper
  std::int64_t open_query_;                  ///< t_ns of the last question that was asked
  MappingThread mapping_;
  LoopThread loop_;
};

}  // namespace glide
