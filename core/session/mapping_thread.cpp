#include "session/mapping_thread.h"

#include <utility>
#include <variant>

namespace glide {
namespace {

/// What the loop thread should do about a message that the mapper has worked off.
std::optional<LoopMessage> followUpOf(const MappingMessage& message) {
  if (const auto* keyframe = std::get_if<NewKeyframe>(&message))
    return KeyframeMapped{keyframe->id};
  if (std::holds_alternative<LoopCorrection>(message)) return LoopClosed{};
  if (std::holds_alternative<GlobalAdjustment>(message)) return std::nullopt;
  return MapReplaced{};
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
    process(*message, &interrupt_);
    queue_.done();
  }
}

void MappingThread::process(const MappingMessage& message, const std::atomic<bool>* interrupt) {
  mapper_.process(message, interrupt);
  if (std::optional<LoopMessage> next = followUpOf(message)) follow_up_(std::move(*next));
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

void MappingThread::waitIdle() {
  if (worker_) queue_.waitIdle();
}

void MappingThread::close() {
  queue_.close();
  interrupt_.store(true);
}

void MappingThread::stop() {
  close();
  worker_.reset();
}

}  // namespace glide
