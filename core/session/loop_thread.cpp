#include "session/loop_thread.h"

#include "optimize/global_adjustment.h"

#include <exception>
#include <utility>
#include <variant>

namespace glide {
namespace {

// Keyframes are looked at again with the next one when this many wait.
constexpr std::size_t kQueueCapacity = 8;

}  // namespace

LoopThread::LoopThread(const Config& config,
                       const CameraModel& camera,
                       const Published<MapSnapshot>* map,
                       std::function<void(MappingMessage)> correct)
    : config_(config),
      camera_(camera),
      map_(*map),
      correct_(std::move(correct)),
      queue_(kQueueCapacity),
      answer_(nullptr),
      relocalizer_(config, camera),
      closer_(config, camera) {
  if (config.execution == Execution::threaded) worker_.emplace("glide-loop", [this] { run(); });
}

void LoopThread::run() {
  while (std::optional<LoopMessage> message = queue_.pop()) {
    try {
      work(*message);
    } catch (const std::exception&) {  // out of memory: the map is as it was, the question stays
                                       // open no longer
      refuse(*message);
    }
    queue_.done();
  }
}

bool LoopThread::offer(LoopMessage message) {
  if (!worker_) {
    work(message);
    return true;
  }
  const bool is_keyframe = std::holds_alternative<KeyframeMapped>(message);
  const bool is_query = std::holds_alternative<RelocalizationQuery>(message);
  const bool may_be_lost = is_keyframe || is_query;
  const bool is_taken = may_be_lost ? queue_.tryPush(message) : queue_.pushAnyway(message);
  // After the push: the adjustment looks at the queue before it begins, and at the flag while it
  // runs.
  if (!is_keyframe) is_wanted_.store(true);
  return is_taken;
}

void LoopThread::work(const LoopMessage& message) {
  std::visit([this](const auto& content) { process(content); }, message);
  if (adjustment_is_due_) adjust();
}

void LoopThread::refuse(const LoopMessage& message) {
  const auto* query = std::get_if<RelocalizationQuery>(&message);
  if (query == nullptr) return;
  auto answer = std::make_shared<RelocalizationAnswer>();
  answer->t_ns = query->t_ns;
  answer_.store(std::move(answer));
}

std::shared_ptr<const MapSnapshot> LoopThread::syncIndex() {
  std::shared_ptr<const MapSnapshot> map = map_.load();
  sync_.update(*map, &index_);
  return map;
}

void LoopThread::process(const KeyframeMapped& message) {
  const std::shared_ptr<const MapSnapshot> map = syncIndex();
  if (config_.loop.closing == LoopClosing::off) return;
  std::optional<LoopCorrection> correction = closer_.close(message.id, *map, index_, &stopped_);
  if (correction) correct_(std::move(*correction));
}

void LoopThread::process(const RelocalizationQuery& message) {
  const std::shared_ptr<const MapSnapshot> map = syncIndex();
  auto answer = std::make_shared<RelocalizationAnswer>();
  answer->t_ns = message.t_ns;
  answer->found = relocalizer_.relocalize(message, *map, index_);
  answer_.store(std::move(answer));
}

void LoopThread::process(const LoopClosed&) { adjustment_is_due_ = true; }

void LoopThread::process(const MapReplaced&) {
  adjustment_is_due_ = false;
  closer_.reset();
  syncIndex();
}

void LoopThread::adjust() {
  is_wanted_.store(false);
  if (stopped_.load() || queue_.size() > 0) return;  // when what waits is worked off
  const ScaleLevels levels(config_.features.scale_factor, config_.features.levels);
  GlobalAdjustmentOptions options{levels};
  options.cancel = &is_wanted_;
  const std::shared_ptr<const MapSnapshot> map = map_.load();
  std::optional<GlobalAdjustment> adjustment =
      adjustGlobally(map->cameraOr(camera_), *map, options);
  adjustment_is_due_ = !adjustment && is_wanted_.load();
  if (adjustment) correct_(std::move(*adjustment));
}

void LoopThread::waitIdle() {
  if (worker_) queue_.waitIdle();
}

void LoopThread::close() {
  stopped_.store(true);
  is_wanted_.store(true);
  queue_.close();
}

void LoopThread::stop() {
  close();
  worker_.reset();
}

}  // namespace glide
