#pragma once

#include "ar/app_world.h"
#include "ar/display.h"

#include "glide/frame.h"
#include "glide/frame_map.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace glide {

/// What an app sees between two frames. Immutable once published: who reads it waits for nobody.
struct AppState {
  AppWorld world;  ///< as the app has turned and scaled that of `last`
  Display display;
  FrameResult last;  ///< as made before the first frame of a session or of another map
  std::shared_ptr<const FrameMap> map;  ///< of `last`; none before the first frame
  std::vector<TrackedPoint> tracked_points;

  bool isTracking() const { return last.state == TrackingState::tracking; }
  SE3d T_world_cam() const;
  /// What anchors, points and hits are of: the map of `last`, empty before the first frame.
  std::shared_ptr<const MapView> mapView() const;
  /// How a map or a pose of this generation (MapView::generation) is shown. A newer one than that
  /// of `last` is of a map that the app has not seen: it starts with a world of its own. Read the
  /// state before the map: then it cannot be older.
  AppWorld worldOf(std::uint64_t generation) const;
  /// Another map, or none, takes the place of the present one.
  void replaceMap();
  /// The answer to a frame. The one that starts a map while mapping is threaded has a pose, but no
  /// map to hang anything on: to an app it is the last one of initialising.
  void take(const FrameResult& result,
            std::shared_ptr<const FrameMap> map_of_result,
            const std::vector<TrackedPoint>& points);
};

}  // namespace glide
