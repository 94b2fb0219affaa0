#include "mapping/local_mapper.h"

#include "support/synthetic_map.h"
#include "support/synthetic_problem.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

namespace glide {
namespace {

using test::SyntheticCloud;
using test::SyntheticCloudOptions;
using test::SyntheticTracker;

// A wavy walk along +x that looks along +z.
SE3d walk(int step) {
  const double s = 0.25 * step;
  return test::lookAlong(Vec3d(s, 0.1 * std::sin(1.3 * s), 0.2 * std::sin(s)),
                         0.1 * std::sin(0.5 * s));
}

/// Feeds a walk through the cloud to a mapper.
class Walk {
 public:
  Walk(const SyntheticCloudOptions& cloud, const SyntheticTracker::Options& tracker)
      : cloud_(test::syntheticCamera(DistortionModel::radial_tangential), cloud),
        tracker_(&cloud_, tracker),
        published_(std::make_shared<const MapSnapshot>()),
        mapper_(Config{}, cloud_.camera(), &published_) {}

  void start() {
    mapper_.process(tracker_.start(cloud_.look(walk(0)), cloud_.look(walk(1)), 3.0), nullptr);
    step_ = 2;
  }
  void advance(int steps) {
    for (int i = 0; i < steps; ++i, ++step_) {
      mapper_.process(tracker_.track(*map(), cloud_.look(walk(step_)), newest()), nullptr);
    }
  }
  std::shared_ptr<const MapSnapshot> map() const { return published_.load(); }
  KeyframeId newest() const { return map()->keyframes().back().id; }

  SyntheticCloud cloud_;
  SyntheticTracker tracker_;
  Published<MapSnapshot> published_;
  LocalMapper mapper_;
  int step_ = 0;
};

double medianDepthOfFirst(const MapSnapshot& map) {
  std::vector<double> depths;
  const MapSnapshot::KeyframeEntry& first = map.keyframes().front();
  for (const LandmarkId id : first.landmarks) {
    if (const auto* landmark = map.landmark(id))
      depths.push_back((first.T_cam_world * landmark->p_world).z());
  }
  std::sort(depths.begin(), depths.end());
  return depths[depths.size() / 2];
}

TEST(LocalMapper, StartsAMapOfUnitMedianDepth) {
  Walk walk({}, {});
  walk.start();
  const auto map = walk.map();
  ASSERT_EQ(map->keyframes().size(), 2U);
  EXPECT_GT(map->landmarks().size(), 200U);
  EXPECT_NEAR(medianDepthOfFirst(*map), 1.0, 1e-6);
  EXPECT_LT(walk.tracker_.landmarkError(*map), 1e-3);
}

TEST(LocalMapper, GrowsAnExactMapFromExactViews) {
  Walk walk({}, {});
  walk.start();
  const std::size_t at_start = walk.map()->landmarks().size();
  walk.advance(8);
  EXPECT_GT(walk.map()->landmarks().size(), at_start * 3 / 2);
  EXPECT_LT(walk.tracker_.keyframeError(*walk.map()), 1e-4);
  EXPECT_LT(walk.tracker_.landmarkError(*walk.map()), 1e-3);
}

}  // namespace
}  // namespace glide
