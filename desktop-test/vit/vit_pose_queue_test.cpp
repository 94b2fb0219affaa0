#include "vit/vit_pose_queue.h"

#include <gtest/gtest.h>

namespace glide::test {
namespace {

std::unique_ptr<vit_pose> poseAt(std::int64_t t_ns) {
  auto pose = std::make_unique<vit_pose>();
  pose->data.timestamp = t_ns;
  return pose;
}

TEST(VitPoseQueue, GivesTheOldestFirst) {
  VitPoseQueue queue;
  EXPECT_EQ(queue.pop(), nullptr);
  queue.push(poseAt(1), queue.era());
  queue.push(poseAt(2), queue.era());
  EXPECT_EQ(queue.pop()->data.timestamp, 1);
  EXPECT_EQ(queue.pop()->data.timestamp, 2);
  EXPECT_EQ(queue.pop(), nullptr);
}

TEST(VitPoseQueue, KeepsTheNewestWhenNobodyPops) {
  VitPoseQueue queue;
  for (std::int64_t t_ns = 0; t_ns < 1000; ++t_ns) queue.push(poseAt(t_ns), queue.era());
  EXPECT_EQ(queue.pop()->data.timestamp, 1000 - 256);
}

TEST(VitPoseQueue, DropsThePoseOfAFrameThatWasInTrackingWhenItWasCleared) {
  VitPoseQueue queue;
  queue.push(poseAt(1), queue.era());
  const std::uint64_t era = queue.era();  // the tracking of a second frame begins
  queue.clear();
  queue.push(poseAt(2), era);
  EXPECT_EQ(queue.pop(), nullptr);
  queue.push(poseAt(3), queue.era());
  EXPECT_EQ(queue.pop()->data.timestamp, 3);
}

}  // namespace
}  // namespace glide::test
