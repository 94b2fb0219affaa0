#include "guest/guest_fixture.h"
#include "support/gl_app.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <utility>

namespace glide::test {
namespace {

using ::testing::HasSubstr;

/// Objects of every kind, to be found unharmed: whoever deletes names of another context hits some.
class Bystander {
 public:
  Bystander() : app_(23) {}
  ~Bystander() { EXPECT_EQ(differences(objects_, app_.objects()), ""); }
  Bystander(const Bystander&) = delete;
  Bystander& operator=(const Bystander&) = delete;

 private:
  GlApp app_;
  GlSnapshot objects_ = app_.objects();
};

class GuestContextTest : public GuestTest {
 protected:
  /// The session goes on with the map it has: the frame is placed by the indirect tracker for want
  /// of a reference, those after it directly.
  void expectGoesOn(Session* session, int frame, std::size_t keyframes) const {
    const Result<FrameResult> first = feed(session, frame);
    ASSERT_TRUE(first.ok()) << first.error().message;
    EXPECT_EQ(first->state, TrackingState::tracking);
    EXPECT_EQ(first->tracker, TrackerKind::indirect);
    EXPECT_EQ(first->switch_reason, SwitchReason::no_reference);
    const Result<FrameResult> second = feed(session, frame + 1);
    ASSERT_TRUE(second.ok()) << second.error().message;
    EXPECT_EQ(second->tracker, TrackerKind::direct);
    EXPECT_EQ(session->backend().backend, Backend::gles);
    EXPECT_EQ(session->map()->resets, 0U);
    EXPECT_GE(session->map()->keyframes.size(), keyframes);
  }
};

TEST_F(GuestContextTest, ASessionLeavesNoNames) {
  const std::vector<int> before = countNames();
  {
    Session session = makeSession(config());
    trackDirectly(&session);
    EXPECT_NE(countNames(), before);
  }
  EXPECT_EQ(countNames(), before);
}

TEST_F(GuestContextTest, ReleasesAllNamesAndGoesOnWithTheSameMap) {
  const std::vector<int> before = countNames();
  Session session = makeSession(config());
  const int next = trackDirectly(&session);
  const std::size_t keyframes = session.map()->keyframes.size();
  const std::vector<int> during = countNames();
  session.releaseGl();
  EXPECT_EQ(countNames(), before);
  session.releaseGl();  // a second time does nothing
  expectGoesOn(&session, next, keyframes);
  EXPECT_EQ(countNames(), during);
}

TEST_F(GuestContextTest, GoesOnInAnotherContextAfterItsOwnWasDestroyed) {
  Session session = makeSession(config());
  const int next = trackDirectly(&session);
  const std::size_t keyframes = session.map()->keyframes.size();
  destroyApp();
  session.abandonGl();
  const AppContext other = makeContext(ContextSharing::none);
  const std::vector<int> before = countNames();
  expectGoesOn(&session, next, keyframes);
  session.releaseGl();
  EXPECT_EQ(countNames(), before);
  EXPECT_THAT(other.complaints(), ::testing::IsEmpty());
}

TEST_F(GuestContextTest, AbandonsWithoutTouchingTheContextThatIsCurrent) {
  Session session = makeSession(config());
  trackDirectly(&session);
  const AppContext other = makeContext(ContextSharing::none);
  const Bystander bystander;
  session.abandonGl();
  EXPECT_THAT(other.complaints(), ::testing::IsEmpty());
}

TEST_F(GuestContextTest, NoticesByItselfThatTheContextIsNotItsOwn) {
  Session session = makeSession(config());
  const int next = trackDirectly(&session);
  const AppContext other = makeContext(ContextSharing::none);
  const Bystander bystander;
  expectGoesOn(&session, next, 2);
  EXPECT_THAT(other.complaints(), ::testing::IsEmpty());
}

TEST_F(GuestContextTest, DestroyedInAnotherContextOrInNoneHarmsNobody) {
  std::optional<Session> first = makeSession(config());
  std::optional<Session> second = makeSession(config());
  trackDirectly(&*first);
  const AppContext other = makeContext(ContextSharing::none);
  {
    const Bystander bystander;
    first.reset();
  }
  makeNoContextCurrent();
  second.reset();
  other.makeCurrent();
  EXPECT_THAT(other.complaints(), ::testing::IsEmpty());
}

TEST_F(GuestContextTest, WithoutAContextAnUpdateFailsAndNothingIsLost) {
  Session session = makeSession(config());
  const int next = trackDirectly(&session);
  const std::size_t keyframes = session.map()->keyframes.size();
  for (const bool released : {false, true}) {
    if (released) session.releaseGl();
    makeNoContextCurrent();
    const Result<FrameResult> refused = feed(&session, next);
    ASSERT_FALSE(refused.ok());
    EXPECT_EQ(refused.error().code, ErrorCode::missing_context);
    EXPECT_THAT(refused.error().message, HasSubstr("no context is current"));
    app().makeCurrent();
  }
  expectGoesOn(&session, next, keyframes);
}

TEST_F(GuestContextTest, AFrameWithoutContextInBetweenKeepsTheReference) {
  Session session = makeSession(config());
  const int next = trackDirectly(&session);
  makeNoContextCurrent();
  EXPECT_FALSE(feed(&session, next).ok());
  app().makeCurrent();
  EXPECT_EQ(feed(&session, next)->tracker, TrackerKind::direct);
}

TEST_F(GuestContextTest, AnAutomaticSessionGoesOnOnTheCpu) {
  Config automatic = config();
  automatic.backend = Backend::automatic;
  Session session = makeSession(automatic);
  const int next = trackDirectly(&session);
  session.releaseGl();
  makeNoContextCurrent();
  EXPECT_EQ(feed(&session, next)->state, TrackingState::tracking);
  EXPECT_EQ(session.backend().backend, Backend::cpu);
  app().makeCurrent();
}

TEST_F(GuestContextTest, WorksInEveryContextOfAShareGroup) {
  const AppContext second = makeContext(ContextSharing::current);
  std::optional<Bystander> bystander(std::in_place);
  app().makeCurrent();
  const std::vector<int> before = countNames();
  std::optional<Session> alone = makeSession(config());
  std::optional<Session> wandering = makeSession(config());
  const int next = trackDirectly(&*alone);
  for (int frame = 0; frame < next + 6; ++frame) {
    (frame % 3 == 0 ? app() : second).makeCurrent();
    const FrameResult result = feed(&*wandering, frame).value();
    app().makeCurrent();
    if (frame < next) continue;
    const FrameResult expected = feed(&*alone, frame).value();
    EXPECT_EQ(result.tracker, expected.tracker);
    EXPECT_EQ(result.T_world_cam.t_xyz, expected.T_world_cam.t_xyz) << "frame " << frame;
  }
  second.makeCurrent();
  wandering.reset();
  bystander.reset();
  EXPECT_THAT(second.complaints(), ::testing::IsEmpty());
  app().makeCurrent();
  alone.reset();
  std::vector<int> after = countNames();
  // Queries are not shared: those of the session that ended elsewhere go with their context.
  EXPECT_LE(after.back() - before.back(), 8);
  after.back() = before.back();
  EXPECT_EQ(after, before);
}

TEST_F(GuestContextTest, SurvivesTheEndOfTheContextThatItWasMadeIn) {
  std::optional<AppContext> first = makeContext(ContextSharing::current);
  Session session = makeSession(config());
  const int next = trackDirectly(&session);
  app().makeCurrent();  // shares
  first.reset();
  EXPECT_EQ(feed(&session, next)->tracker, TrackerKind::direct);
}

TEST_F(GuestContextTest, DoesNotCareForTheSurfaceThatIsCurrent) {
  Session session = makeSession(config());
  const int next = trackDirectly(&session);
  if (!app().makeCurrentWithSurface()) GTEST_SKIP() << "no pbuffer on " << caps().renderer;
  EXPECT_EQ(feed(&session, next)->tracker, TrackerKind::direct);
  app().makeCurrent();
  EXPECT_EQ(feed(&session, next + 1)->tracker, TrackerKind::direct);
}

}  // namespace
}  // namespace glide::test
