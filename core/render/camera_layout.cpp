#include "render/camera_layout.h"

#include <algorithm>
#include <cmath>

namespace glide {

PictureLayout PictureLayout::fit(FrameSize picture, const Viewport& viewport) {
  const double scale = std::min(static_cast<double>(viewport.width) / picture.width,
                                static_cast<double>(viewport.height) / picture.height);
  const int width = std::max(1, static_cast<int>(std::lround(scale * picture.width)));
  const int height = std::max(1, static_cast<int>(std::lround(scale * picture.height)));
  return {{viewport.x + (viewport.width - width) / 2,
           viewport.y + (viewport.height - height) / 2,
           width,
           height}};
}

PointPx PictureLayout::place(const std::array<double, 2>& uv, FrameSize image) const {
  return {static_cast<float>((uv[0] + 0.5) * area.width / image.width),
          static_cast<float>((uv[1] + 0.5) * area.height / image.height)};
}

}  // namespace glide
