#include "replay/render/timeline.h"

#include "render/packed_color.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace glide::replay {
namespace {

enum Kind : std::uint8_t { kDirect, kIndirect, kLost, kWaiting, kKinds };

constexpr Color kLostColor{0.1F, 0.1F, 0.1F, 1.0F};
constexpr Color kWaitingColor{0.62F, 0.62F, 0.62F, 1.0F};  // a map is not there yet, or a pause
constexpr Color kEmptyColor{0.86F, 0.86F, 0.85F, 1.0F};    // frames to come

Kind kindOf(const FrameResult& frame) {
  if (frame.state == TrackingState::lost) return kLost;
  if (frame.state != TrackingState::tracking) return kWaiting;
  return frame.tracker == TrackerKind::direct ? kDirect : kIndirect;
}

Color colorOf(std::size_t kind) {
  constexpr std::array<Color, kKinds> kColors{
      kDirectColor, kIndirectColor, kLostColor, kWaitingColor};
  return kColors[kind];
}

void fill(RgbPicture& picture, int column, int first_row, int end_row, const Color& color) {
  const PackedColor bytes = packColor(color);
  for (int row = first_row; row < end_row; ++row) {
    const std::ptrdiff_t pixel = std::ptrdiff_t{row} * picture.width + column;
    std::copy_n(bytes.begin(), 3, picture.rgb.begin() + 3 * pixel);
  }
}

/// The column's rows from below, divided by how many frames are of each kind.
void fillShares(RgbPicture& picture, int column, const std::array<int, kKinds>& counts) {
  int total = 0;
  for (const int count : counts) total += count;
  int below = 0;
  for (std::size_t kind = 0; kind < kKinds; ++kind) {
    const int from = picture.height * below / total;
    below += counts[kind];
    const int to = picture.height * below / total;
    fill(picture, column, picture.height - to, picture.height - from, colorOf(kind));
  }
}

}  // namespace

Rgb viewOf(const RgbPicture& picture) {
  return {picture.rgb.data(), picture.width, picture.height, std::ptrdiff_t{3} * picture.width};
}

void Timeline::add(const FrameResult& frame) { kinds_.push_back(kindOf(frame)); }

RgbPicture Timeline::paint(int width, int height) const {
  RgbPicture strip{width, height, {}};
  strip.rgb.resize(std::size_t{3} * static_cast<std::size_t>(width * height));
  const std::size_t seen = kinds_.size();
  const std::size_t total = std::max({seen, static_cast<std::size_t>(expected_), std::size_t{1}});
  const auto columns = static_cast<std::size_t>(width);
  for (std::size_t column = 0; column < columns; ++column) {
    const std::size_t first = column * total / columns;
    const std::size_t end = std::max(first + 1, (column + 1) * total / columns);
    std::array<int, kKinds> counts{};
    for (std::size_t i = first; i < std::min(end, seen); ++i) ++counts[kinds_[i]];
    const int x = static_cast<int>(column);
    if (first < seen) {
      fillShares(strip, x, counts);
    } else {
      fill(strip, x, 0, height, kEmptyColor);
    }
  }
  return strip;
}

}  // namespace glide::replay
