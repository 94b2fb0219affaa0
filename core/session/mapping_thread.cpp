#include "session/mapping_thread.h"

#include <exception>
#include <utility>
#include <variant>

namespace glide {
namespace {

/// What the loop thread should do about a message that the mapper has worked off. What the mapper
/// refused was solved before the map was bent: a whole adjustment is due still.
std::optional<LoopMessage> followUpOf(const MappingMessage& message, bool is_applied) {
  if (const auto* keyframe = std::get_if<NewKeyframe>(&message))
    return KeyframeMapped{keyframe->id};
  const bool is_loop = std::holds_alternative<LoopCorrection>(message);
  const bool is_adjustment = std::holds_alternative<GlobalAdjustment>(message);
  if (!is_loop && !is_adjustment) return MapReplaced{};
  if (is_loop == is_applied) return LoopClosed{};
  return std::nullopt;
}

}  // namespace

MappingThread::MappingThread(const Config& config,
                             const CameraModel& camera,
                             Published<MapSnapshot>* published,
                             std::function<void(LoopMessage)> follow_up)
    : queue_(static_cast<std::size_t>(config.mapping.queue_capacity)),
      follow_up_(std::move(follow_up)),
      mapper_(config, camera, published) {
  if (config.execution == Execution::threaded) worker_.emplace("glide-mapping", [this] { run(); });
}

void MappingThread::run() {
  while (std::optional<MappingMessage> message = queue_.pop()) {
    interrupt_.store(queue_.size() > 0);
    if (stopped_.load()) interrupt_.store(true);
    try {
      process(*message, &interrupt_);
    } catch (const std::exception&) {
      // Out of memory in the middle of a change: start from nothing rather than from half of it.
      mapper_.process(ClearMap{}, nullptr);
    }
    queue_.done();
  }
}

void MappingThread::process(const MappingMessage& message, const std::atomic<bool>* interrupt) {
  const bool is_applied = mapper_.process(message, interrupt);
  std::optional<LoopMessage> next = followUpOf(message, is_applied);
  if (next) follow_up_(std::move(*next));
}

bool MappingThread::offer(MappingMessage message) {
  if (!worker_) {
    process(message, nullptr);
    return true;
  }
  // Optional work on the message before this one ends early. Set before the push: the mapper clears
  // it when it takes the new message.
  interrupt_.store(true);
  return queue_.tryPush(message);
}

void MappingThread::send(MappingMessage message) {
  if (!worker_) {
    process(message, nullptr);
    return;
  }
  interrupt_.store(true);
  queue_.push(message);
}

void MappingThread::sendAnyway(MappingMessage message) {
  if (!worker_) {
    process(message, nullptr);
    return;
  }
  interrupt_.store(true);
  queue_.pushAnyway(message);
}

void MappingThread::waitIdle() {
  if (worker_) queue_.waitIdle();
}

void MappingThread::close() {
  stopped_.store(true);
  queue_.close();
  interrupt_.store(true);
}

void MappingThread::stop() {
  close();
  worker_.reset();
}

}  // namespace glide
