#include "support/synthetic_map.h"

#include "support/synthetic_problem.h"

#include "map/landmark.h"

#include "geometry/align_sim3.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace glide::test {
namespace {

constexpr double kScaleFactor = 1.2;
constexpr int kLevels = 8;
// Step along a corner's tangent that shows its direction in the image, world units.
constexpr double kTangentStep = 1e-4;

double uniform(double low, double high, std::mt19937_64* random) {
  return std::uniform_real_distribution<double>(low, high)(*random);
}

double gauss(double sigma, std::mt19937_64* random) {
  return sigma > 0.0 ? std::normal_distribution<double>(0.0, sigma)(*random) : 0.0;
}

Descriptor flipped(Descriptor descriptor, int bits, std::mt19937_64* random) {
  for (int i = 0; i < bits; ++i) {
    const std::uint64_t bit = (*random)() % 256;
    descriptor[bit / 64] ^= std::uint64_t{1} << (bit % 64);
  }
  return descriptor;
}

/// Level that detects a corner from `distance`; -1 when none does.
int detectedLevel(double max_distance, double distance) {
  const double level = std::round(std::log(max_distance / distance) / std::log(kScaleFactor));
  return level >= 0.0 && level < kLevels ? static_cast<int>(level) : -1;
}

}  // namespace

SyntheticCloud::SyntheticCloud(const CameraModel& camera, const SyntheticCloudOptions& options)
    : camera_(camera), options_(options), random_(options.seed) {
  while (static_cast<int>(points_.size()) < options.points) addCorner();
  if (options.repeat_x > 0.0) repeat();
}

void SyntheticCloud::addCorner() {
  Vec3d point;
  for (int k = 0; k < 3; ++k) point[k] = uniform(options_.low[k], options_.high[k], &random_);
  if (std::hypot(point.x(), point.z()) < options_.hole) return;
  const auto looks = static_cast<std::size_t>(options_.looks);
  const std::size_t index = points_.size();
  points_.push_back(point);
  tangents_.push_back(randomVector(1.0, &random_).normalized());
  const double size_level = uniform(0.0, kLevels - 1.0, &random_);
  max_distances_.push_back(5.0 * std::pow(kScaleFactor, size_level));
  Descriptor descriptor{};
  for (std::uint64_t& word : descriptor) word = random_();
  descriptors_.push_back(looks > 0 && index >= looks ? descriptors_[index % looks] : descriptor);
}

// Keeps the corners of the first period and copies them into the others.
void SyntheticCloud::repeat() {
  const std::size_t count = points_.size();
  const auto periodOf = [&](const Vec3d& p) {
    return std::floor((p.x() - options_.low.x()) / options_.repeat_x);
  };
  std::vector<std::size_t> first;
  for (std::size_t i = 0; i < count; ++i) {
    if (periodOf(points_[i]) == 0.0) first.push_back(i);
  }
  const std::vector<Vec3d> points = std::exchange(points_, {});
  const std::vector<Vec3d> tangents = std::exchange(tangents_, {});
  const std::vector<double> max_distances = std::exchange(max_distances_, {});
  const std::vector<Descriptor> descriptors = std::exchange(descriptors_, {});
  for (double x = 0.0; options_.low.x() + x < options_.high.x(); x += options_.repeat_x) {
    for (const std::size_t i : first) {
      points_.push_back(points[i] + Vec3d(x, 0.0, 0.0));
      tangents_.push_back(tangents[i]);
      max_distances_.push_back(max_distances[i]);
      descriptors_.push_back(descriptors[i]);
    }
  }
}

SyntheticView SyntheticCloud::look(const SE3d& T_cam_world) {
  SyntheticView view;
  view.T_cam_world = T_cam_world;
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;
  for (std::size_t i = 0; i < points_.size(); ++i) {
    const Vec3d p_cam = T_cam_world * points_[i];
    const int level = detectedLevel(max_distances_[i], p_cam.norm());
    const auto uv = camera_.project(p_cam);
    const auto tip = camera_.project(T_cam_world * (points_[i] + kTangentStep * tangents_[i]));
    const bool is_missed = uniform(0.0, 1.0, &random_) < options_.missed_share;
    if (level < 0 || !uv || !tip || is_missed) continue;
    const double sigma = options_.noise_px * std::pow(kScaleFactor, level);
    const double noise_v = gauss(sigma, &random_);  // not as arguments: their order is open
    const double noise_u = gauss(sigma, &random_);
    const Vec2d seen = *uv + Vec2d(noise_u, noise_v);
    if (!camera_.isInImage(seen, 1.0)) continue;
    Feature feature;
    feature.uv = seen.cast<float>();
    feature.angle = static_cast<float>(std::atan2((*tip - *uv).y(), (*tip - *uv).x()));
    feature.level = static_cast<std::uint8_t>(level);
    features.push_back(feature);
    descriptors.push_back(flipped(descriptors_[i], options_.flipped_bits, &random_));
    view.points.push_back(static_cast<int>(i));
  }
  view.features = std::make_shared<FeatureSet>(
      std::move(features), std::move(descriptors), camera_.width(), camera_.height());
  return view;
}

SE3d lookAlong(const Vec3d& center_world, double yaw) {
  SE3d T_cam_world;
  T_cam_world.q = so3Exp(Vec3d(0.0, -yaw, 0.0));
  T_cam_world.t = -(T_cam_world.q * center_world);
  return T_cam_world;
}

InitialMap SyntheticTracker::start(const SyntheticView& a, const SyntheticView& b, double scale) {
  SE3d T_b_a = b.T_cam_world * a.T_cam_world.inverse();
  T_b_a.t *= scale;
  InitialMap message;
  message.a = {KeyframeId{next_keyframe_}, 0, a.features, SE3d{}};
  message.b = {KeyframeId{next_keyframe_ + 1}, 0, b.features, T_b_a};
  views_[message.a.id] = a;
  views_[message.b.id] = b;
  next_keyframe_ += 2;
  for (std::size_t i = 0; i < a.points.size(); ++i) {
    const auto twin = std::find(b.points.begin(), b.points.end(), a.points[i]);
    if (twin == b.points.end()) continue;
    const Vec3d p_a = a.T_cam_world * cloud_->points()[static_cast<std::size_t>(a.points[i])];
    message.points.push_back(
        {scale * p_a, static_cast<int>(i), static_cast<int>(twin - b.points.begin())});
  }
  return message;
}

InitialMap SyntheticTracker::start(SyntheticCloud* cloud,
                                   const SE3d& T_a_world,
                                   const SE3d& T_b_world,
                                   double scale) {
  const SyntheticView a = cloud->look(T_a_world);
  const SyntheticView b = cloud->look(T_b_world);
  return start(a, b, scale);
}

NewKeyframe SyntheticTracker::track(const MapSnapshot& map,
                                    const SyntheticView& view,
                                    KeyframeId reference) {
  const Sim3d S_truth_map = similarityToMap(map).inverse();
  SE3d T_cam_map;  // similarity taken apart: rotation as it is, translation in map units
  T_cam_map.q = view.T_cam_world.q * S_truth_map.q;
  T_cam_map.t = (view.T_cam_world * S_truth_map.t) / S_truth_map.s;
  NewKeyframe message;
  message.id = KeyframeId{next_keyframe_++};
  message.t_ns = static_cast<std::int64_t>(message.id.value) * 100'000'000;
  message.features = view.features;
  message.reference = reference;
  message.T_cam_ref = T_cam_map * map.T_cam_world(reference)->inverse();
  message.T_cam_ref =
      perturbed(message.T_cam_ref, options_.pose_noise, options_.pose_noise, &random_);
  message.landmarks = match(map, view);
  for (const LandmarkId id : message.landmarks) {
    if (id != kNoLandmark) message.sightings.push_back({id, 1, 1});
  }
  views_[message.id] = view;
  return message;
}

std::vector<LandmarkId> SyntheticTracker::match(const MapSnapshot& map, const SyntheticView& view) {
  const std::map<int, LandmarkId> known = landmarkOfCorner(map);
  std::vector<LandmarkId> landmarks(view.points.size(), kNoLandmark);
  for (std::size_t i = 0; i < view.points.size(); ++i) {
    const auto found = known.find(view.points[i]);
    if (found == known.end() || uniform(0.0, 1.0, &random_) > options_.tracked_share) continue;
    landmarks[i] = found->second;
  }
  for (std::size_t i = 1; i < landmarks.size(); ++i) {
    const bool swaps = uniform(0.0, 1.0, &random_) < options_.mismatch_share;
    if (swaps) std::swap(landmarks[i], landmarks[i - 1]);
  }
  return landmarks;
}

std::map<int, LandmarkId> SyntheticTracker::landmarkOfCorner(const MapSnapshot& map) const {
  std::map<int, LandmarkId> result;
  for (const MapSnapshot::LandmarkEntry& landmark : map.landmarks()) {
    result.emplace(cornerOf(landmark), landmark.id);
  }
  return result;
}

int SyntheticTracker::cornerOf(const MapSnapshot::LandmarkEntry& landmark) const {
  if (landmark.observations.empty()) return -1;
  const auto view = views_.find(landmark.observations.front().keyframe);
  if (view == views_.end()) return -1;
  return view->second.points[static_cast<std::size_t>(landmark.observations.front().feature)];
}

Sim3d SyntheticTracker::similarityToMap(const MapSnapshot& map) const {
  std::vector<Vec3d> p_map, p_truth;
  for (const MapSnapshot::LandmarkEntry& landmark : map.landmarks()) {
    const int corner = cornerOf(landmark);
    if (corner < 0) continue;
    p_map.push_back(landmark.p_world);
    p_truth.push_back(cloud_->points()[static_cast<std::size_t>(corner)]);
  }
  return alignSim3(p_map, p_truth, AlignScale::estimated).value_or(Sim3d{});
}

double SyntheticTracker::keyframeError(const MapSnapshot& map) const {
  std::vector<Vec3d> centers_map, centers_truth;
  for (const MapSnapshot::KeyframeEntry& keyframe : map.keyframes()) {
    centers_map.push_back(keyframe.T_cam_world.inverse().t);
    centers_truth.push_back(views_.at(keyframe.id).T_cam_world.inverse().t);
  }
  const Sim3d S_truth_map =
      alignSim3(centers_truth, centers_map, AlignScale::estimated).value_or(Sim3d{});
  double sum = 0.0;
  for (std::size_t i = 0; i < centers_map.size(); ++i) {
    sum += (S_truth_map * centers_map[i] - centers_truth[i]).squaredNorm();
  }
  return std::sqrt(sum / static_cast<double>(centers_map.size()));
}

double SyntheticTracker::landmarkError(const MapSnapshot& map) const {
  const Sim3d S_truth_map = similarityToMap(map).inverse();
  std::vector<double> errors;
  for (const MapSnapshot::LandmarkEntry& landmark : map.landmarks()) {
    const int corner = cornerOf(landmark);
    if (corner < 0) continue;
    const Vec3d& truth = cloud_->points()[static_cast<std::size_t>(corner)];
    errors.push_back((S_truth_map * landmark.p_world - truth).norm());
  }
  if (errors.empty()) return 0.0;
  std::nth_element(errors.begin(),
                   errors.begin() + static_cast<std::ptrdiff_t>(errors.size() / 2),
                   errors.end());
  return errors[errors.size() / 2];
}

}  // namespace glide::test
