#include "replay/render/timeline.h"

#include "render/packed_color.h"

#include <gtest/gtest.h>

#include <array>
#include <cstddef>

namespace glide::replay {
namespace {

using Bytes = std::array<std::uint8_t, 3>;

Bytes bytesOf(const Color& color) {
  const PackedColor packed = packColor(color);
  return {packed[0], packed[1], packed[2]};
}

FrameResult tracked(TrackerKind tracker) {
  FrameResult frame;
  frame.state = TrackingState::tracking;
  frame.tracker = tracker;
  return frame;
}

FrameResult untracked(TrackingState state) {
  FrameResult frame;
  frame.state = state;
  return frame;
}

Bytes pixel(const RgbPicture& picture, int x, int y) {
  const std::size_t at = 3 * static_cast<std::size_t>(y * picture.width + x);
  return {picture.rgb[at], picture.rgb[at + 1], picture.rgb[at + 2]};
}

TEST(Timeline, ColoursFramesByWhoPlacedThemFromTheLeft) {
  Timeline timeline(8);
  timeline.add(untracked(TrackingState::initializing));
  timeline.add(tracked(TrackerKind::indirect));
  timeline.add(tracked(TrackerKind::direct));
  timeline.add(untracked(TrackingState::lost));
  const RgbPicture strip = timeline.paint(16, 3);
  EXPECT_EQ(strip.rgb.size(), 16U * 3 * 3);
  EXPECT_EQ(pixel(strip, 3, 0), bytesOf(kIndirectColor));
  EXPECT_EQ(pixel(strip, 4, 0), bytesOf(kDirectColor));
  EXPECT_EQ(pixel(strip, 5, 2), bytesOf(kDirectColor));
  const Bytes waiting = pixel(strip, 0, 1), lost = pixel(strip, 6, 1), to_come = pixel(strip, 8, 1);
  EXPECT_EQ(pixel(strip, 15, 1), to_come);
  EXPECT_NE(waiting, to_come);
  EXPECT_NE(waiting, lost);
}

TEST(Timeline, DividesAColumnByTheSharesOfItsFrames) {
  Timeline timeline(16);
  for (int i = 0; i < 16; ++i) {
    timeline.add(tracked(i % 4 == 0 ? TrackerKind::indirect : TrackerKind::direct));
  }
  const RgbPicture strip = timeline.paint(2, 8);
  int direct = 0;
  for (int y = 0; y < 8; ++y) direct += pixel(strip, 1, y) == bytesOf(kDirectColor) ? 1 : 0;
  EXPECT_EQ(direct, 6);
  EXPECT_EQ(pixel(strip, 0, 7), bytesOf(kDirectColor));
  EXPECT_EQ(pixel(strip, 0, 0), bytesOf(kIndirectColor));
}

TEST(Timeline, HoldsAllFramesWhenTheirNumberIsUnknownOrWrong) {
  for (const int expected : {0, 1}) {
    Timeline timeline(expected);
    for (int i = 0; i < 10; ++i) {
      timeline.add(tracked(i < 5 ? TrackerKind::direct : TrackerKind::indirect));
    }
    const RgbPicture strip = timeline.paint(20, 1);
    EXPECT_EQ(pixel(strip, 9, 0), bytesOf(kDirectColor));
    EXPECT_EQ(pixel(strip, 10, 0), bytesOf(kIndirectColor));
  }
}

TEST(Timeline, IsEmptyBeforeTheFirstFrame) {
  const RgbPicture strip = Timeline(0).paint(4, 2);
  EXPECT_EQ(pixel(strip, 0, 0), pixel(strip, 3, 1));
}

}  // namespace
}  // namespace glide::replay
