#pragma once

#include "support/synthetic_map.h"
#include "support/synthetic_problem.h"

#include "map/map.h"
#include "map/snapshot_builder.h"

#include <cmath>
#include <map>
#include <memory>
#include <random>
#include <utility>
#include <vector>

namespace glide::test {

/// A map without a tracker or mapper: keyframes and landmarks stand where the cloud's truth has
/// them, and each keyframe sees every mapped corner that its view shows.
class TrueMap {
 public:
  explicit TrueMap(const SyntheticCloudOptions& options)
      : cloud(syntheticCamera(DistortionModel::radial_tangential), options) {}

  /// A corner becomes a landmark with its second sight.
  KeyframeId addKeyframe(const SE3d& T_cam_world) {
    const SyntheticView view = cloud.look(T_cam_world);
    Keyframe keyframe;
    keyframe.id = KeyframeId{truth_.size()};
    keyframe.T_cam_world = T_cam_world;
    keyframe.features = view.features;
    const KeyframeId id = keyframe.id;
    truth_.push_back(T_cam_world);
    map.addKeyframe(std::move(keyframe));
    for (std::size_t i = 0; i < view.points.size(); ++i)
      see(id, static_cast<int>(i), view.points[i]);
    map.refreshChanged();
    return id;
  }

  std::shared_ptr<const MapSnapshot> snapshot() const { return snapshotOf(map, {}); }

  const SE3d& truePose(KeyframeId id) const { return truth_[id.value]; }
  const Vec3d& truePosition(LandmarkId id) const {
    return cloud.points()[static_cast<std::size_t>(corner_of_.at(id))];
  }

  /// Moves every keyframe but the first, and every landmark, by Gaussian noise (units, radians).
  void disturb(double sigma, std::uint64_t seed) {
    std::mt19937_64 random(seed);
    for (std::size_t i = 1; i < truth_.size(); ++i) {
      const KeyframeId id{i};
      if (map.keyframe(id) == nullptr) continue;
      map.setPose(id, perturbed(map.keyframe(id)->T_cam_world, sigma, sigma, &random));
    }
    for (const LandmarkId id : map.landmarkIds()) {
      map.setPosition(id, map.landmark(id)->p_world + randomVector(sigma, &random));
    }
  }

  /// Bends the world smoothly, as drift does: sideways by `amount` * sin(x / length).
  void bend(double amount, double length) {
    const auto shift = [&](const Vec3d& p) {
      return Vec3d(0.0, 0.3 * amount * std::sin(p.z() / length), amount * std::sin(p.x() / length));
    };
    const Vec3d origin = shift(truth_.front().inverse().t);
    for (std::size_t i = 0; i < truth_.size(); ++i) {
      const SE3d& T_cam_world = truth_[i];
      const Vec3d center = T_cam_world.inverse().t;
      map.setPose(KeyframeId{i},
                  {T_cam_world.q, -(T_cam_world.q * (center + shift(center) - origin))});
    }
    for (const LandmarkId id : map.landmarkIds()) {
      const Vec3d& p = truePosition(id);
      map.setPosition(id, p + shift(p) - origin);
    }
  }

  SyntheticCloud cloud;
  Map map{ScaleLevels(1.2, 8)};

 private:
  std::vector<SE3d> truth_;                 // by keyframe
  std::map<int, Observation> first_sight_;  // by corner
  std::map<int, LandmarkId> landmark_;      // by corner
  std::map<LandmarkId, int> corner_of_;

  void see(KeyframeId id, int feature, int corner) {
    const auto [first, is_first] = first_sight_.emplace(corner, Observation{id, feature});
    if (is_first) return;
    const auto [landmark, is_new] = landmark_.emplace(corner, LandmarkId{});
    if (is_new) {
      const Vec3d& p_world = cloud.points()[static_cast<std::size_t>(corner)];
      landmark->second = map.addLandmark(p_world, first->second.keyframe);
      corner_of_[landmark->second] = corner;
      map.addObservation(landmark->second, first->second);
    }
    map.addObservation(landmark->second, {id, feature});
  }
};

}  // namespace glide::test
