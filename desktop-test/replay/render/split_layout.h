#pragma once

#include "replay/outputs/render_view.h"

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

inline bool isEmpty(const Viewport& part) { return part.width <= 0 || part.height <= 0; }

/// The layout for a picture of this size that shows a camera of that size; no part overlaps another
/// one, but for the mini-map, an inset of the picture with RenderView::ar. Parts are empty when the
/// view has none, or the picture is too small for them.
SplitLayout layoutOf(RenderView view, const PictureSize& size, const PictureSize& camera);

/// The size of the pictures of a video: sides are even, what encoders want.
PictureSize videoSize(RenderView view, const PictureSize& camera);

}  // namespace glide::replay
