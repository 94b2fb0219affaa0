#include "base/ids.h"

#include <gtest/gtest.h>

#include <set>
#include <type_traits>
#include <unordered_set>

namespace glide {
namespace {

static_assert(!std::is_convertible_v<KeyframeId, LandmarkId>);
static_assert(!std::is_convertible_v<std::uint64_t, KeyframeId>);

TEST(Ids, AreOrderedByCreation) {
  EXPECT_LT(KeyframeId{1}, KeyframeId{2});
  EXPECT_EQ(LandmarkId{7}, LandmarkId{7});
  EXPECT_NE(LandmarkId{7}, LandmarkId{8});
}

TEST(Ids, NoLandmarkComesAfterEveryLandmark) { EXPECT_LT(LandmarkId{1'000'000'000}, kNoLandmark); }

TEST(Ids, ServeAsKeys) {
  const std::unordered_set<KeyframeId> hashed{{3}, {1}, {3}};
  EXPECT_EQ(hashed.size(), 2U);
  const std::set<KeyframeId> sorted{{3}, {1}, {2}};
  EXPECT_EQ(sorted.begin()->value, 1U);
}

}  // namespace
}  // namespace glide
