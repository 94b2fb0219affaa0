// A map that the mapper made goes through a file.
#include "support/mapped_scene.h"

#include "mapping/local_mapper.h"

#include "map/map_consistency.h"
#include "map/map_io.h"
#include "map/map_restore.h"
#include "map/snapshot_builder.h"

#include <gtest/gtest.h>

namespace glide {
namespace {

using test::smallCloud;
using test::SyntheticCloud;
using test::SyntheticTracker;
using test::walk;

class SavedMap : public testing::Test {
 protected:
  SavedMap()
      : cloud_(test::syntheticCamera(DistortionModel::radial_tangential), smallCloud()),
        tracker_(&cloud_, SyntheticTracker::Options{}),
        published_(std::make_shared<const MapSnapshot>()),
        mapper_(Config{}, cloud_.camera(), &published_) {
    mapper_.process(tracker_.start(&cloud_, walk(0), walk(1), 2.0), nullptr);
    for (int i = 2; i < 12; ++i) {
      const KeyframeId newest = published_.load()->keyframes().back().id;
      mapper_.process(tracker_.track(*published_.load(), cloud_.look(walk(0.6 * i)), newest),
                      nullptr);
    }
  }

  StoredMap stored() const {
    const CameraModel& camera = cloud_.camera();
    const auto& k = camera.coefficients();
    return {published_.load(),
            {camera.width(),
             camera.height(),
             camera.fx(),
             camera.fy(),
             camera.cx(),
             camera.cy(),
             camera.distortion(),
             {k.begin(), k.end()}},
            ScaleLevels(1.2, 8)};
  }

  SyntheticCloud cloud_;
  SyntheticTracker tracker_;
  Published<MapSnapshot> published_;
  LocalMapper mapper_;
};

TEST_F(SavedMap, ComesBackByteForByte) {
  const std::vector<std::byte> file = encodeMap(stored());
  const Result<StoredMap> decoded = decodeMap(file);
  ASSERT_TRUE(decoded.ok()) << decoded.error().message;
  EXPECT_GT(decoded->map->landmarks().size(), 100U);
  EXPECT_EQ(encodeMap(*decoded), file);
}

TEST_F(SavedMap, IsAConsistentMapWithTheSameNeighbors) {
  const Result<StoredMap> decoded = decodeMap(encodeMap(stored()));
  ASSERT_TRUE(decoded.ok());
  Map map(decoded->levels);
  restoreMap(*decoded->map, &map);
  EXPECT_EQ(checkConsistency(map), "");
  for (const MapSnapshot::KeyframeEntry& keyframe : published_.load()->keyframes()) {
    const auto neighbors =
        map.covisibility().neighbors(keyframe.id, Config{}.mapping.min_covisibility);
    ASSERT_EQ(neighbors.size(), keyframe.neighbors.size());
    for (std::size_t i = 0; i < neighbors.size(); ++i) {
      EXPECT_EQ(neighbors[i].id, keyframe.neighbors[i].id);
      EXPECT_EQ(neighbors[i].weight, keyframe.neighbors[i].weight);
    }
  }
}

}  // namespace
}  // namespace glide
