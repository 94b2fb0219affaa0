#pragma once

#include "render/camera_ink.h"
#include "render/camera_trails.h"

#include "glide/types.h"

#include <span>
#include <vector>

namespace glide {

/// How well a point agrees: green, over yellow to red at the end of the tracker's scale and beyond.
Color pointColor(float residual, TrackerKind tracker);

/// Tracked points over a picture: trails first, then the points, outliers as rings.
struct PointInk {
  FrameSize camera;  ///< whose pixels the points are in
  PictureLayout layout;
  TrackerKind tracker = TrackerKind::none;

  void append(std::span<const TrackedPoint> points,
              const PointTrails& trails,
              std::vector<InkShape>* shapes) const;

 private:
  void appendTrail(const TrackedPoint& point,
                   const PointTrails& trails,
                   std::vector<InkShape>* shapes) const;
  void appendPoint(const TrackedPoint& point, std::vector<InkShape>* shapes) const;
  float radius() const;
};

}  // namespace glide
