#include "replay/render/split_layout.h"

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

constexpr double kLeftShare = 0.42;     // of the width: the map is the larger part
constexpr double kPictureShare = 0.64;  // of the height at most, so that a mini-map fits below
constexpr int kMargin = 8;              // px
constexpr int kTimelineHeight = 14;     // px

int rounded(double value) { return static_cast<int>(std::lround(value)); }

}  // namespace

SplitLayout splitLayout(const PictureSize& size, const PictureSize& camera) {
  SplitLayout layout;
  layout.timeline = {kMargin, kMargin, std::max(0, size.width - 2 * kMargin), kTimelineHeight};
  const int bottom = kTimelineHeight + 2 * kMargin;
  const int height = size.height - bottom - kMargin;
  const int left_width = rounded(kLeftShare * size.width) - kMargin;
  const double shape = static_cast<double>(camera.height) / camera.width;
  const int picture_height = std::min(rounded(shape * left_width), rounded(kPictureShare * height));
  layout.picture = {kMargin, bottom + height - picture_height, left_width, picture_height};
  layout.mini_map = {kMargin, bottom, left_width, height - picture_height - kMargin};
  const int scene_x = left_width + 2 * kMargin;
  layout.scene = {scene_x, bottom, size.width - scene_x - kMargin, height};
  return layout;
}

}  // namespace glide::replay
