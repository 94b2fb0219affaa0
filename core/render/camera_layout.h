#pragma once

#include "gpu/texture_placement.h"

#include "glide/render_types.h"

#include <array>

namespace glide {

using PointPx = std::array<float, 2>;

/// Where a picture lies in a viewport.
struct PictureLayout {
  /// The largest centred rectangle of the picture's aspect ratio, in whole px, at least one. Sides
  /// of the viewport are positive.
  static PictureLayout fit(FrameSize picture, const Viewport& viewport);

  /// From pixels of an image of that size, (0, 0) the centre of the first, to px of the rectangle,
  /// (0, 0) its upper left corner.
  PointPx place(const std::array<double, 2>& uv, FrameSize image) const;

  Viewport area;
};

}  // namespace glide
