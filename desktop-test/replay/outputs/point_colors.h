#pragma once

#include "replay/readers/frame_source.h"

#include "glide/frame.h"

#include <cstdint>
#include <span>
#include <unordered_map>

namespace glide::replay {

/// A colour as screens take it (sRGB).
struct Rgb8 {
  std::uint8_t red = 0, green = 0, blue = 0;

  bool operator==(const Rgb8&) const = default;
};

/// What a landmark has that no frame gave a colour.
inline constexpr Rgb8 kUnseenColor{128, 128, 128};

/// The colours of landmarks: the mean of the pixels that showed them.
class PointColors {
 public:
  /// Points that were tracked in a frame. With the first ones of another map (MapView::generation)
  /// than before, whose landmarks are others, what is known of the old ones is forgotten.
  void add(std::uint64_t map_generation,
           const SourceFrame& frame,
           std::span<const TrackedPoint> points);

  /// A landmark's colour, gray when the frames have no colour.
  Rgb8 of(std::uint64_t landmark) const;

 private:
  struct Sum {
    std::uint32_t red = 0, green = 0, blue = 0;
    std::uint32_t count = 0;
  };

  std::uint64_t map_generation_ = 0;
  std::unordered_map<std::uint64_t, Sum> sums_;  ///< by landmark
};

}  // namespace glide::replay
