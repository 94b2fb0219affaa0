#pragma once

#include "mapping/bearing_cache.h"

#include "map/map.h"

#include "geometry/camera_model.h"

#include "glide/config.h"

#include <memory>

namespace glide {

/// What every step of mapping works on. Owned by LocalMapper, one thread.
struct MapperState {
  MapperState(const Config& config_in, const CameraModel& camera_in)
      : config(config_in),
        given_camera(camera_in),
        camera(camera_in),
        map(ScaleLevels(config.features.scale_factor, config.features.levels)),
        bearings(camera) {}

  /// From now on the map is made with this camera.
  void useCamera(const CameraModel& other) {
    const bool is_given = other.distortion() == given_camera.distortion() &&
                          other.coefficients() == given_camera.coefficients();
    camera = other;
    corrected_camera = is_given ? nullptr : std::make_shared<const CameraModel>(other);
    bearings = BearingCache(other);
  }

  const Config config;
  CameraModel given_camera;
  CameraModel camera;                                   ///< in force
  std::shared_ptr<const CameraModel> corrected_camera;  ///< the same; null while it is as given
  Map map;
  BearingCache bearings;
};

/// Mean focal length: pixels per radian near the image centre, for every camera model.
inline double focalPx(const CameraModel& camera) { return 0.5 * (camera.fx() + camera.fy()); }

/// Expected precision of a feature of this level, 1/px.
inline double inverseSigma(const ScaleLevels& levels, int level) {
  return 1.0 / levels.scale(level);
}

}  // namespace glide
