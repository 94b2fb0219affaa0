#include "session/back_end.h"

#include <limits>
#include <utility>

namespace glide {
namespace {

constexpr std::int64_t kNoQuery = std::numeric_limits<std::int64_t>::min();

}  // namespace

BackEnd::BackEnd(const Config& config, const CameraModel& camera)
    : map_(std::make_shared<const MapSnapshot>()),
      open_query_(kNoQuery),
      mapping_(
          config, camera, &map_, [this](LoopMessage message) { loop_.offer(std::move(message)); }),
      loop_(config, camera, &map_, [this](MappingMessage message) {
        mapping_.send(std::move(message));
        ++corrections_;  // after it is in the queue: who sees the count waits for it
      }) {}

// Each thread may be about to hand something to the other: both end before either is destroyed.
BackEnd::~BackEnd() {
  mapping_.close();
  loop_.close();
  mapping_.stop();
  loop_.stop();
}

bool BackEnd::ask(RelocalizationQuery query) {
  const std::shared_ptr<const RelocalizationAnswer> last = loop_.answer();
  if (open_query_ != kNoQuery && (!last || last->t_ns != open_query_)) return false;
  const std::int64_t t_ns = query.t_ns;
  if (!loop_.offer(std::move(query))) return false;
  open_query_ = t_ns;
  return true;
}

void BackEnd::waitIdle() {
  std::size_t corrections = 0;
  do {  // until nothing that the mapper handed to the loop thread comes back
    corrections = corrections_.load();
    mapping_.waitIdle();
    loop_.waitIdle();
  } while (corrections_.load() != corrections);
}

}  // namespace glide
