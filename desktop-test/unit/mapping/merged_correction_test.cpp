// LocalMapper takes over corrections that were worked out on a map of some keyframes ago.
#include "support/mapped_scene.h"

#include "mapping/local_mapper.h"

#include "optimize/global_adjustment.h"

#include "geometry/align_sim3.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

namespace glide {
namespace {

constexpr int kDriftingKeyframes = 14;
constexpr int kRelaxing = 4;  // keyframes until local adjustment has taken up the strain of drift
constexpr int kNewKeyframes = 5;  // after the snapshot

Config narrowWindow() {
  Config config;
  config.mapping.local_keyframes = 4;  // so that local adjustment cannot undo the drift by itself
  return config;
}

test::SyntheticCloudOptions noisyCloud() {
  test::SyntheticCloudOptions options;
  options.points = 2000;
  options.high.x() = 26.0;
  options.noise_px = 0.3;
  options.flipped_bits = 8;
  return options;
}

/// Camera `step` of a walk on which a landmark is seen by some six keyframes.
SE3d stride(double step) { return test::walk(4.0 * step); }

/// A walk past a cloud, with a tracker that is right relative to its reference whatever the map has
/// drifted to.
class DriftingWalk {
 public:
  DriftingWalk()
      : cloud_(test::syntheticCamera(DistortionModel::radial_tangential), noisyCloud()),
        tracker_(&cloud_, {}),
        published_(std::make_shared<const MapSnapshot>()),
        mapper_(narrowWindow(), cloud_.camera(), &published_) {
    truth_[KeyframeId{0}] = stride(0);
    truth_[KeyframeId{1}] = stride(1);
    mapper_.process(tracker_.start(&cloud_, stride(0), stride(1), 2.0), nullptr);
    advance(kDriftingKeyframes - 2);
  }

  void advance(int count) {
    for (int i = 0; i < count; ++i) {
      const SE3d T_cam_world = stride(static_cast<double>(truth_.size()));
      const MapSnapshot::KeyframeEntry& reference = map()->keyframes().back();
      NewKeyframe message = tracker_.track(*map(), cloud_.look(T_cam_world), reference.id);
      message.T_cam_ref = T_cam_world * truth_.at(reference.id).inverse();
      message.T_cam_ref.t *= unitAround(*map(), reference);
      message.reference_scale = reference.scale;
      truth_[message.id] = T_cam_world;
      mapper_.process(message, nullptr);
    }
  }

  /// Makes the map drift: in each keyframe's frame by the same small similarity against the one
  /// before. The keyframes that follow let local adjustment take up the strain.
  void drift(const Vec7d& per_keyframe) {
    LoopCorrection correction;
    correction.snapshot = {map()->generation(), map()->corrections()};
    Sim3d S_drifted_world;
    for (const auto& keyframe : map()->keyframes()) {
      const SE3d& T = keyframe.T_cam_world;
      const Sim3d S_cam_world{T.q, T.t, 1.0};
      S_drifted_world =
          S_drifted_world * S_cam_world.inverse() * Sim3d::exp(per_keyframe) * S_cam_world;
      correction.keyframes.push_back({keyframe.id, S_drifted_world});
    }
    mapper_.process(correction, nullptr);
  }

  /// What a perfect loop would say about a map: every keyframe back to the truth, in the first
  /// one's unit.
  LoopCorrection perfectCorrection(const MapSnapshot& map) const {
    LoopCorrection correction;
    correction.snapshot = {map.generation(), map.corrections()};
    const double unit = unitAround(map, map.keyframes().front());
    for (const auto& keyframe : map.keyframes()) {
      const SE3d& T_old = keyframe.T_cam_world;
      const SE3d T_true = truth_.at(keyframe.id) * truth_.begin()->second.inverse();
      const Sim3d S_cam_old{T_old.q, T_old.t, 1.0};
      const Sim3d S_cam_new{T_true.q, unit * T_true.t, 1.0};
      const Sim3d S_grown{
          Eigen::Quaterniond::Identity(), Vec3d::Zero(), unit / unitAround(map, keyframe)};
      correction.keyframes.push_back({keyframe.id, S_cam_new.inverse() * S_grown * S_cam_old});
    }
    return correction;
  }

  void process(const MappingMessage& message) { mapper_.process(message, nullptr); }
  std::shared_ptr<const MapSnapshot> map() const { return published_.load(); }
  const CameraModel& camera() const { return cloud_.camera(); }

  struct Errors {
    double old_part = 0.0, new_part = 0.0;  ///< largest distance of a keyframe from the truth
  };
  /// After alignment of all keyframes' centres, in true units.
  Errors errors(KeyframeId last_old) const {
    std::vector<Vec3d> in_map, true_ones;
    const auto map = this->map();
    for (const auto& keyframe : map->keyframes()) {
      in_map.push_back(keyframe.T_cam_world.inverse().t);
      true_ones.push_back(truth_.at(keyframe.id).inverse().t);
    }
    const Sim3d S_truth_map = alignSim3(true_ones, in_map, AlignScale::estimated).value_or(Sim3d{});
    Errors errors;
    for (std::size_t i = 0; i < in_map.size(); ++i) {
      const bool is_new = last_old < map->keyframes()[i].id;
      double& worst = is_new ? errors.new_part : errors.old_part;
      worst = std::max(worst, (S_truth_map * in_map[i] - true_ones[i]).norm());
    }
    return errors;
  }

  /// Median reprojection error of the newest keyframes, pixels.
  double newestError(std::size_t keyframes) const {
    const auto map = this->map();
    std::vector<double> distances;
    const std::size_t first = map->keyframes().size() - keyframes;
    for (std::size_t i = first; i < map->keyframes().size(); ++i) {
      const MapSnapshot::KeyframeEntry& keyframe = map->keyframes()[i];
      for (std::size_t f = 0; f < keyframe.landmarks.size(); ++f) {
        const auto* landmark = map->landmark(keyframe.landmarks[f]);
        if (landmark == nullptr) continue;
        const auto uv = camera().project(keyframe.T_cam_world * landmark->p_world);
        const Vec2d seen = keyframe.features->feature(f).uv.cast<double>();
        distances.push_back(uv ? (*uv - seen).norm() : 1e3);
      }
    }
    std::nth_element(
        distances.begin(), distances.begin() + long(distances.size() / 2), distances.end());
    return distances[distances.size() / 2];
  }

 private:
  /// How long a true unit is in the map where the keyframe looks.
  double unitAround(const MapSnapshot& map, const MapSnapshot::KeyframeEntry& keyframe) const {
    std::vector<double> ratios;
    for (const LandmarkId id : keyframe.landmarks) {
      if (id == kNoLandmark) continue;
      const MapSnapshot::LandmarkEntry& landmark = *map.landmark(id);
      const Vec3d& p_true = cloud_.points()[std::size_t(tracker_.cornerOf(landmark))];
      const double true_distance = (truth_.at(keyframe.id) * p_true).norm();
      ratios.push_back((keyframe.T_cam_world * landmark.p_world).norm() / true_distance);
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
  }

  test::SyntheticCloud cloud_;
  test::SyntheticTracker tracker_;
  Published<MapSnapshot> published_;
  LocalMapper mapper_;
  std::map<KeyframeId, SE3d> truth_;
};

// Per keyframe: a thousandth of the scene depth, a tenth of a degree and one per cent.
const Vec7d kDrift = (Vec7d() << 0.001, 0.0005, -0.001, 0.001, 0.002, -0.001, 0.01).finished();

class MergedCorrection : public testing::Test {
 protected:
  MergedCorrection() {
    walk_.drift(kDrift);
    walk_.advance(kRelaxing);
    snapshot_ = walk_.map();
  }

  /// Old and new parts alike come back to the truth, and the newest keyframes still see what they
  /// saw.
  void expectStraightened(const MappingMessage& message) {
    walk_.advance(kNewKeyframes);
    const DriftingWalk::Errors before = walk_.errors(snapshot_->keyframes().back().id);
    const double seen_before = walk_.newestError(kNewKeyframes);
    const std::uint64_t corrections = walk_.map()->corrections();
    walk_.process(message);
    const DriftingWalk::Errors after = walk_.errors(snapshot_->keyframes().back().id);
    EXPECT_EQ(walk_.map()->corrections(), corrections + 1);
    EXPECT_GT(before.old_part, 0.15);
    EXPECT_LT(after.old_part, 0.1 * before.old_part);
    EXPECT_GT(before.new_part, 0.05);
    EXPECT_LT(after.new_part, 0.1 * before.new_part);
    EXPECT_LT(seen_before, 0.6);
    EXPECT_LT(walk_.newestError(kNewKeyframes), 0.8);

    walk_.advance(2);  // mapping goes on as if nothing had been
    EXPECT_LT(walk_.newestError(kNewKeyframes), 0.6);
    EXPECT_LT(walk_.errors(snapshot_->keyframes().back().id).new_part, 0.1 * before.new_part);
  }

  DriftingWalk walk_;
  std::shared_ptr<const MapSnapshot> snapshot_;
};

TEST_F(MergedCorrection, OfALoopStraightensWhatWasMappedMeanwhile) {
  expectStraightened(walk_.perfectCorrection(*snapshot_));
}

TEST_F(MergedCorrection, OfGlobalAdjustmentStraightensWhatWasMappedMeanwhile) {
  const auto adjustment = adjustGlobally(walk_.camera(), *snapshot_, {ScaleLevels(1.2, 8)});
  ASSERT_TRUE(adjustment.has_value());
  expectStraightened(*adjustment);
}

TEST_F(MergedCorrection, IsIgnoredWhenTheMapWasBentOrReplacedSince) {
  const LoopCorrection correction = walk_.perfectCorrection(*snapshot_);
  const auto adjustment = adjustGlobally(walk_.camera(), *snapshot_, {ScaleLevels(1.2, 8)});
  walk_.process(correction);
  const auto corrected = walk_.map();
  walk_.process(correction);
  walk_.process(*adjustment);
  EXPECT_EQ(walk_.map()->corrections(), corrected->corrections());

  LoopCorrection late = walk_.perfectCorrection(*corrected);
  walk_.process(ClearMap{});
  const std::uint64_t corrections = walk_.map()->corrections();
  walk_.process(late);
  EXPECT_EQ(walk_.map()->corrections(), corrections);
  late.snapshot.generation = walk_.map()->generation();
  walk_.process(late);  // an empty map has nothing to move
  EXPECT_TRUE(walk_.map()->empty());
}

}  // namespace
}  // namespace glide
