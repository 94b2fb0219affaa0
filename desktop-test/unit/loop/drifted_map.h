#pragma once

#include "support/synthetic_map.h"

#include "map/map.h"
#include "map/place_index.h"
#include "map/snapshot_builder.h"

#include "geometry/align_sim3.h"

#include <cmath>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace glide::test {

/// How a map goes wrong from keyframe to keyframe; (translation, rotation, log scale) in the
/// camera.
using Drift = Vec7d;

inline Drift someDrift() {
  Drift drift;
  drift << 0.002, 0.001, 0.0, 0.0003, 0.0015, 0.0, 0.004;
  return drift;
}

/// A map of a camera that walks through a cloud, made without mapping: exact but for a drift from
/// one keyframe to the next. Corners that were out of sight for a while become new landmarks.
class DriftedMap {
 public:
  DriftedMap(const SyntheticCloudOptions& options, const CameraModel& camera, Drift drift)
      : cloud_(camera, options), drift_(std::move(drift)) {}

  /// The next keyframe, seen from the true pose.
  KeyframeId add(const SE3d& T_cam_world) {
    const KeyframeId id{views_.size()};
    const SyntheticView view = cloud_.look(T_cam_world);
    W_est_cam_.push_back(nextPose(T_cam_world));
    views_.push_back(view);
    Keyframe keyframe;
    keyframe.id = id;
    keyframe.features = view.features;
    keyframe.T_cam_world = SE3d{W_est_cam_.back().q, W_est_cam_.back().t}.inverse();
    map_.addKeyframe(keyframe);
    index_.add(id, *view.features);
    for (std::size_t i = 0; i < view.points.size(); ++i) see(id, static_cast<int>(i));
    map_.refreshChanged();
    return id;
  }

  std::shared_ptr<const MapSnapshot> snapshot() const { return snapshotOf(map_, {1, 0, 0, 15}); }
  const PlaceIndex& index() const { return index_; }
  const SE3d& truth(KeyframeId id) const { return views_[id.value].T_cam_world; }
  Map* map() { return &map_; }

  /// What a loop between two keyframes should measure: each camera's unit is the map's there.
  Sim3d trueSimilarity(KeyframeId newer, KeyframeId older) const {
    const double unit_newer = W_est_cam_[newer.value].s, unit_older = W_est_cam_[older.value].s;
    const SE3d T_newer_older = truth(newer) * truth(older).inverse();
    return {T_newer_older.q, unit_newer * T_newer_older.t, unit_newer / unit_older};
  }

  /// Corner that a feature shows.
  int cornerOf(KeyframeId id, int feature) const {
    return views_[id.value].points[static_cast<std::size_t>(feature)];
  }

  /// Corner that a landmark stands for.
  int cornerOf(const MapSnapshot::LandmarkEntry& landmark) const {
    const Observation& seen = landmark.observations.front();
    return cornerOf(seen.keyframe, seen.feature);
  }

  /// RMS distance of the keyframes from the truth after alignment, once moved, true units.
  double error(const std::vector<KeyframeMove>& moves) const {
    std::vector<Vec3d> estimated, truth;
    for (const auto& [id, keyframe] : map_.keyframes()) {
      estimated.push_back(keyframe.T_cam_world.inverse().t);
      truth.push_back(views_[id.value].T_cam_world.inverse().t);
    }
    for (const KeyframeMove& move : moves) {
      estimated[move.id.value] = move.S_new_old * estimated[move.id.value];
    }
    const Sim3d S_truth_est = alignSim3(truth, estimated, AlignScale::estimated).value_or(Sim3d{});
    double sum = 0.0;
    for (std::size_t i = 0; i < truth.size(); ++i) {
      sum += (S_truth_est * estimated[i] - truth[i]).squaredNorm();
    }
    return std::sqrt(sum / static_cast<double>(truth.size()));
  }

 private:
  // Keyframes after which a corner that was not seen is another landmark.
  static constexpr std::uint64_t kMemory = 4;

  struct Track {
    KeyframeId last;
    int last_feature = 0;
    LandmarkId landmark = kNoLandmark;
  };

  SyntheticCloud cloud_;
  Drift drift_;
  Map map_{ScaleLevels(1.2, 8)};
  PlaceIndex index_;
  std::vector<SyntheticView> views_;
  std::vector<Sim3d> W_est_cam_;  ///< similarity from each camera's true frame to the map
  std::map<int, Track> tracks_;   ///< by corner

  Sim3d nextPose(const SE3d& T_cam_world) const {
    if (views_.empty()) return {T_cam_world.inverse().q, T_cam_world.inverse().t, 1.0};
    const SE3d T_last_cam = views_.back().T_cam_world * T_cam_world.inverse();
    return W_est_cam_.back() * Sim3d{T_last_cam.q, T_last_cam.t, 1.0} * Sim3d::exp(drift_);
  }

  void see(KeyframeId id, int feature) {
    const int corner = cornerOf(id, feature);
    const auto [track, is_new] = tracks_.try_emplace(corner, Track{id, feature, kNoLandmark});
    Track& known = track->second;
    if (is_new) return;
    if (id.value - known.last.value > kMemory) {
      known = {id, feature, kNoLandmark};
      return;
    }
    if (known.landmark == kNoLandmark) {
      const Vec3d& p_true = cloud_.points()[static_cast<std::size_t>(corner)];
      const Vec3d p_cam = views_[known.last.value].T_cam_world * p_true;
      known.landmark = map_.addLandmark(W_est_cam_[known.last.value] * p_cam, known.last);
      map_.addObservation(known.landmark, {known.last, known.last_feature});
    }
    map_.addObservation(known.landmark, {id, feature});
    known.last = id;
    known.last_feature = feature;
  }
};

/// A cloud around an empty middle, for cameras that look outwards.
inline SyntheticCloudOptions ringCloud() {
  SyntheticCloudOptions options;
  options.points = 4000;
  options.low = Vec3d(-16.0, -3.0, -16.0);
  options.high = Vec3d(16.0, 3.0, 16.0);
  options.hole = 11.0;
  options.noise_px = 0.3;
  options.flipped_bits = 12;
  return options;
}

/// Camera on a ring of 6 units around the y axis that looks outwards.
inline SE3d ringPose(double angle) {
  return lookAlong(6.0 * Vec3d(std::sin(angle), 0.0, std::cos(angle)), angle);
}

}  // namespace glide::test
