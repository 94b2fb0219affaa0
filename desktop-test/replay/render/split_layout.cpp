#include "replay/render/split_layout.h"

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

constexpr double kLeftShare = 0.42;     // of the width: the map is the larger part
constexpr double kPictureShare = 0.64;  // of the height at most, so that a mini-map fits below
constexpr int kMargin = 8;              // px
constexpr int kTimelineHeight = 14;     // px

constexpr PictureSize kHd{1280, 720};
constexpr int kArWidth = 960;         // px, of the AR view's video
constexpr double kInsetShare = 0.26;  // of the AR view's width

int rounded(double value) { return static_cast<int>(std::lround(value)); }

/// The camera's picture alone, with the map from above in its lower right corner.
SplitLayout arLayout(const PictureSize& size) {
  SplitLayout layout;
  layout.picture = {0, 0, size.width, size.height};
  const int inset = rounded(kInsetShare * size.width);
  layout.mini_map = {size.width - inset - kMargin, kMargin, inset, inset * 3 / 4};
  return layout;
}

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

}  // namespace

SplitLayout layoutOf(RenderView view, const PictureSize& size, const PictureSize& camera) {
  if (view == RenderView::split) return splitLayout(size, camera);
  if (view == RenderView::ar) return arLayout(size);
  SplitLayout layout;
  layout.scene = {0, 0, size.width, size.height};
  return layout;
}

PictureSize videoSize(RenderView view, const PictureSize& camera) {
  if (view != RenderView::ar) return kHd;
  return {kArWidth, rounded(0.5 * kArWidth * camera.height / camera.width) * 2};
}

}  // namespace glide::replay
