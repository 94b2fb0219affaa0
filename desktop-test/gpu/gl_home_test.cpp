#include "gpu/gl_home.h"

#include "support/app_context.h"

#include "gpu/gl_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <optional>

namespace glide::test {
namespace {

class GlHomeTest : public GlTest {};

TEST_F(GlHomeTest, IsHereInItsShareGroupOnly) {
  const ScopedCurrentContext main;
  GlHome home = GlHome::create().value();
  EXPECT_TRUE(home.isHere());
  EXPECT_TRUE(home.isCreator());
  const AppContext sharing = AppContext::create(ContextSharing::current).value();
  EXPECT_TRUE(home.isHere());
  EXPECT_FALSE(home.isCreator());
  const AppContext stranger = AppContext::create(ContextSharing::none).value();
  EXPECT_FALSE(home.isHere());
  makeNoContextCurrent();
  EXPECT_FALSE(home.isHere());
  sharing.makeCurrent();
  EXPECT_TRUE(home.isHere());
  main.restore();
}

TEST_F(GlHomeTest, IsNotTakenInByAStrangerWithTheSameName) {
  const ScopedCurrentContext main;
  std::optional<AppContext> first(AppContext::create(ContextSharing::none).value());
  GlHome home = GlHome::create().value();
  first.reset();
  main.restore();
  // EGL may give the new context the handle of the old one, and GL the sampler its name.
  const AppContext second = AppContext::create(ContextSharing::none).value();
  GlHome other = GlHome::create().value();
  EXPECT_TRUE(other.isHere());
  EXPECT_FALSE(home.isHere());
  home.abandon();
  other.abandon();
}

TEST_F(GlHomeTest, AbandonedIsNowhere) {
  GlHome home = GlHome::create().value();
  home.publish();
  home.abandon();
  EXPECT_FALSE(home.isHere());
}

TEST_F(GlHomeTest, OrdersWhatContextsOfItsGroupSubmit) {
  const ScopedCurrentContext main;
  GlHome home = GlHome::create().value();
  const std::vector<float> values{1.0F, 2.0F};
  const GlBuffer buffer = makeBuffer(values);
  home.publish();
  const AppContext sharing = AppContext::create(ContextSharing::current).value();
  home.enter();
  EXPECT_EQ(readBuffer<float>(buffer), values);
  EXPECT_THAT(sharing.complaints(), ::testing::IsEmpty());
  main.restore();
}

}  // namespace
}  // namespace glide::test
