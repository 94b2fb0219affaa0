#pragma once

#include "glide/render_types.h"

namespace glide::replay {

/// Where the parts of the split view lie: the camera's picture above the mini-map on the left, the
/// 3-D view on the right, the timeline below both. In OpenGL's px, from the lower left corner.
struct SplitLayout {
  Viewport picture, mini_map, scene, timeline;
};

/// Sides of a picture of the split view, px.
struct PictureSize {
  int width = 0, height = 0;
};

/// The layout for a picture of this size that shows a camera of that size; no part overlaps another
/// one. Parts get empty (a side of zero or less) when the picture is too small for them.
SplitLayout splitLayout(const PictureSize& size, const PictureSize& camera);

}  // namespace glide::replay
