#pragma once

#include "track/start_tracks.h"

#include "map/landmark.h"
#include "map/messages.h"

#include "geometry/camera_model.h"
#include "geometry/two_view.h"

#include "glide/config.h"
#include "glide/frame.h"

#include <memory>
#include <optional>
#include <vector>

namespace glide {

/// Monocular start: keeps a first view and tries to solve the relative pose to each following one
/// (ALGORITHMS section 4, "Initialisation").
class Initializer {
 public:
  Initializer(const Config& config, const CameraModel& camera);

  /// The features of one more frame. Returns the two views and their points once they are sure; ids
  /// of the views are left to the caller. progress() says how far it is otherwise.
  std::optional<InitialMap> update(std::int64_t t_ns, std::shared_ptr<const FeatureSet> features);

  const InitializationProgress& progress() const { return progress_; }
  void reset();

 private:
  void start(std::int64_t t_ns, std::shared_ptr<const FeatureSet> features);
  std::vector<FeatureMove> alignMatches(const FeatureSet& features,
                                        const std::vector<Match>& matches) const;
  void report(const TwoViewResult& result);
  InitialMap makeMap(const TwoViewResult& result,
                     const std::vector<Match>& matches,
                     const InitialMap::View& second) const;

  Config config_;
  CameraModel camera_;
  ScaleLevels levels_;
  InitialMap::View first_;
  StartTracks tracks_;
  int age_frames_ = 0;
  InitializationProgress progress_;
};

}  // namespace glide
