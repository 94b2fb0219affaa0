#include "session/mapping_thread.h"

#include "base/stopwatch.h"

#include <utility>

namespace glide {

MappingThread::MappingThread(const Config& config, const CameraModel& camera)
    : published_(std::make_shared<const MapSnapshot>()),
      queue_(static_cast<std::size_t>(config.mapping.queue_capacity)),
      mapper_(config, camera, &published_) {
  if (config.execution == Execution::threaded) worker_.emplace("glide-mapping", [this] { run(); });
}

MappingThread::~MappingThread() {
  queue_.close();
  interrupt_.store(true);
}

void MappingThread::run() {
  while (std::optional<MappingMessage> message = queue_.pop()) {
    interrupt_.store(queue_.size() > 0);
    mapper_.process(*message, &interrupt_);
    queue_.done();
  }
}

bool MappingThread::offer(MappingMessage message, double* inline_ms) {
  *inline_ms = 0.0;
  if (!worker_) {
    Stopwatch watch;
    mapper_.process(message, nullptr);
    *inline_ms = watch.lapMs();
    return true;
  }
  // Optional work on the message before this one ends early. Set before the push: the mapper clears
  // it when it takes the new message.
  interrupt_.store(true);
  return queue_.tryPush(message);
}

void MappingThread::waitIdle() {
  if (worker_) queue_.waitIdle();
}

}  // namespace glide
