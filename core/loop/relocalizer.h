#pragma once

#include "map/map_snapshot.h"
#include "map/messages.h"
#include "map/place_index.h"

#include "geometry/camera_model.h"

#include "glide/config.h"

#include <optional>

namespace glide {

/// Finds a lost frame in the map without a guess: candidates from the place index, descriptor
/// matches with the landmarks of each candidate and its neighbours, P3P with RANSAC, motion-only
/// optimisation, a wider search by projection, acceptance (ALGORITHMS section 4). Owned by the loop
/// thread.
class Relocalizer {
 public:
  Relocalizer(const Config& config, const CameraModel& camera);

  /// Nothing when no place explains the frame beyond doubt. `index` holds keyframes of `map`; those
  /// that `map` does not have are passed over.
  std::optional<Relocalization> relocalize(const RelocalizationQuery& query,
                                           const MapSnapshot& map,
                                           const PlaceIndex& index) const;

 private:
  Config config_;
  CameraModel camera_;
};

}  // namespace glide
