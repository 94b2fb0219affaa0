#include "replay/readers/frame_source.h"

#include <algorithm>

namespace glide::replay {

void SkipList::add(const std::string& what, const std::string& name) {
  const auto known =
      std::find_if(skips_.begin(), skips_.end(), [&](const Skip& s) { return s.what == what; });
  if (known != skips_.end()) {
    ++known->count;
  } else {
    skips_.push_back({what, 1, name});
  }
}

std::string describe(const Skip& skip, int frames_listed) {
  return std::to_string(skip.count) + " of " + std::to_string(frames_listed) + " " + skip.what +
         " (first: " + skip.first + ")";
}

}  // namespace glide::replay
