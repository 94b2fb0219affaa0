#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>

namespace glide {

/// A number that cannot be mixed up with another kind of number. Ordered by creation.
template <class Tag>
struct Id {
  std::uint64_t value = 0;
  friend constexpr bool operator==(Id a, Id b) { return a.value == b.value; }
  friend constexpr bool operator!=(Id a, Id b) { return a.value != b.value; }
  friend constexpr bool operator<(Id a, Id b) { return a.value < b.value; }
};

using KeyframeId = Id<struct KeyframeTag>;
using LandmarkId = Id<struct LandmarkTag>;

/// "This feature observes no landmark."
inline constexpr LandmarkId kNoLandmark{~std::uint64_t{0}};

}  // namespace glide

template <class Tag>
struct std::hash<glide::Id<Tag>> {
  std::size_t operator()(glide::Id<Tag> id) const noexcept {
    return std::hash<std::uint64_t>{}(id.value);
  }
};
