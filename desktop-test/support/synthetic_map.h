#pragma once

#include "map/map_snapshot.h"
#include "map/messages.h"

#include "geometry/camera_model.h"

#include <cstdint>
#include <map>
#include <memory>
#include <random>
#include <vector>

namespace glide::test {

/// A cloud of corners, each with its own random descriptor, size and orientation.
struct SyntheticCloudOptions {
  int points = 2500;
  Vec3d low = Vec3d(-6.0, -3.0, 3.0);  ///< corner of the box that holds the points, world units
  Vec3d high = Vec3d(12.0, 3.0, 8.0);  ///< opposite corner
  double hole = 0.0;      ///< no points nearer than this to the world's y axis, world units
  double repeat_x = 0.0;  ///< > 0: the same corners and looks again and again, this far apart
  double noise_px = 0.0;  ///< standard deviation per axis at level 0; grows with the level
  int flipped_bits = 0;   ///< of each descriptor, chosen anew in every view
  int looks = 0;          ///< distinct descriptors shared by all corners; 0 = one for each corner
  double missed_share = 0.1;  ///< corners that a view does not detect although they are visible
  std::uint64_t seed = 1;
};

/// What one camera sees of the cloud.
struct SyntheticView {
  SE3d T_cam_world;
  std::shared_ptr<const FeatureSet> features;
  std::vector<int> points;  ///< index of the corner, per feature
};

class SyntheticCloud {
 public:
  SyntheticCloud(const CameraModel& camera, const SyntheticCloudOptions& options);

  const CameraModel& camera() const { return camera_; }
  const std::vector<Vec3d>& points() const { return points_; }

  /// The same calls in the same order give the same views. Levels follow the scale rule of Landmark
  /// for a pyramid of 8 levels with factor 1.2.
  SyntheticView look(const SE3d& T_cam_world);

 private:
  CameraModel camera_;
  SyntheticCloudOptions options_;
  std::mt19937_64 random_;
  std::vector<Vec3d> points_, tangents_;
  std::vector<double> max_distances_;
  std::vector<Descriptor> descriptors_;

  void addCorner();
  void repeat();
};

/// Camera at `center`, turned by `yaw` radians about the y axis (0 looks along +z).
SE3d lookAlong(const Vec3d& center_world, double yaw);

/// A perfect tracker for LocalMapper: turns views into its messages, and knows which landmark is
/// which corner.
class SyntheticTracker {
 public:
  struct Options {
    double tracked_share =
        1.0;  ///< of the corners that have a landmark; the others are not matched
    double mismatch_share = 0.0;  ///< of the matches, given to another feature's landmark
    double pose_noise = 0.0;      ///< standard deviation of T_cam_ref: scene units and radians
    std::uint64_t seed = 1;
  };

  SyntheticTracker(const SyntheticCloud* cloud, const Options& options)
      : cloud_(cloud), options_(options), random_(options.seed) {}

  /// The true pair in a map frame that is the first camera, scaled by `scale`.
  InitialMap start(const SyntheticView& a, const SyntheticView& b, double scale);
  /// The same of what the cloud shows from two poses, looked at in this order.
  InitialMap start(SyntheticCloud* cloud,
                   const SE3d& T_a_world,
                   const SE3d& T_b_world,
                   double scale);

  /// The next keyframe, tracked against `map` relative to `reference`.
  NewKeyframe track(const MapSnapshot& map, const SyntheticView& view, KeyframeId reference);

  /// Corner that a landmark stands for (by the first keyframe that sees it); -1 when unknown.
  int cornerOf(const MapSnapshot::LandmarkEntry& landmark) const;

  /// Least-squares similarity from the truth to the map frame, over all landmarks.
  Sim3d similarityToMap(const MapSnapshot& map) const;

  /// RMS distance of the keyframes' centres from the truth after alignment by landmarks, true
  /// units.
  double keyframeError(const MapSnapshot& map) const;

  /// Median distance of the landmarks from their corners after alignment, true units.
  double landmarkError(const MapSnapshot& map) const;

 private:
  const SyntheticCloud* cloud_;
  Options options_;
  std::mt19937_64 random_;
  std::map<KeyframeId, SyntheticView> views_;
  std::uint64_t next_keyframe_ = 0;

  std::map<int, LandmarkId> landmarkOfCorner(const MapSnapshot& map) const;
  std::vector<LandmarkId> match(const MapSnapshot& map, const SyntheticView& view);
};

}  // namespace glide::test
