#include "replay/app/job.h"

namespace glide::replay {

std::optional<Failure> makeWatchers(Job&) { return std::nullopt; }

}  // namespace glide::replay
