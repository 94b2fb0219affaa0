// MapRenderer inside of an app's contexts (docs/gl-contract.md).
#include "support/gl_app.h"
#include "support/gl_snapshot.h"

#include "render/contract_fixture.h"
#include "render/map_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <optional>
#include <utility>

namespace glide::test {
namespace {

using ::testing::IsEmpty;

/// Whether two pictures are the same but for rounding: softpipe blends differently by one step from
/// context to context.
MATCHER_P(LooksLike, picture, "") {
  constexpr int kStep = 1;
  const bool has_same_size = arg.size() == picture.size();
  return has_same_size && std::equal(arg.begin(), arg.end(), picture.begin(), [](int a, int b) {
           return std::abs(a - b) <= kStep;
         });
}

class MapContract : public ContractTest {
 protected:
  MapContract() {
    calls_.push_back({"create", [this] { create(); }});
    addDrawing("at first");
    calls_.push_back({"new frames and another map", [this] { grow(); }});
    addDrawing("after a change");
    calls_.push_back({"releaseGl", [this] { renderer_->releaseGl(); }});
    addDrawing("after releaseGl");
    calls_.push_back({"abandonGl", [this] { renderer_->abandonGl(); }});
    addDrawing("after abandonGl");
    calls_.push_back({"destruction", [this] { renderer_.reset(); }});
  }

  MapRenderer makeRenderer(GlStatePolicy policy) const {
    Result<MapRenderer> made = MapRenderer::create(policy);
    EXPECT_TRUE(made.ok()) << made.error().message;
    giveRoom(&*made);
    return std::move(*made);
  }
  /// What the renderer draws into a black target.
  std::vector<std::uint8_t> pixels(MapRenderer* renderer) {
    target().begin(kBlack);
    draw(renderer);
    return target().readRgb();
  }
  static void draw(MapRenderer* renderer) {
    const Status whole = renderer->draw(cornerView(kViewport), kViewport);
    EXPECT_TRUE(whole.ok()) << whole.error().message;
    const Status inset = renderer->drawMiniMap({2, 2, 20, 20});
    EXPECT_TRUE(inset.ok()) << inset.error().message;
  }
  /// Everything public, in an order in which each does GL work if it can.
  const std::vector<PublicCall>& everyCall(GlStatePolicy policy) {
    policy_ = policy;
    return calls_;
  }

 private:
  void create() { renderer_.emplace(makeRenderer(policy_)); }
  void grow() {
    for (const FrameResult& frame : room_.frames) renderer_->addFrame(frame);
    renderer_->setMap(makeRoomMap({900, 30, 1}).map);
  }
  void addDrawing(const std::string& when) {
    calls_.push_back({"draw " + when, [this] {
                        EXPECT_TRUE(renderer_->draw(cornerView(kViewport), kViewport).ok());
                      }});
    calls_.push_back(
        {"drawMiniMap " + when, [this] { EXPECT_TRUE(renderer_->drawMiniMap(kViewport).ok()); }});
  }
  void giveRoom(MapRenderer* renderer) const {
    MapStyle everything;
    everything.frame_frusta = true;
    renderer->setStyle(everything);
    renderer->setMap(room_.map);
    renderer->setTruth(room_.truth);
    for (const FrameResult& frame : room_.frames) renderer->addFrame(frame);
  }

  RoomMap room_ = makeRoomMap({400, 8, 60});
  GlStatePolicy policy_ = GlStatePolicy::preserve;
  std::vector<PublicCall> calls_;
  std::optional<MapRenderer> renderer_;
};

TEST_F(MapContract, NoCallChangesAnyStateOfTheApp) {
  expectNoTrace(everyCall(GlStatePolicy::preserve), kStateSeed);
}

TEST_F(MapContract, ErrorsThatTheAppHasNotFetchedStayAndStayAlone) {
  expectErrorsUntouched(everyCall(GlStatePolicy::preserve));
}

TEST_F(MapContract, InAnyStateOfTheAppTheMapLooksTheSame) {
  MapRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  const std::vector<std::uint8_t> expected = pixels(&renderer);
  EXPECT_THAT(expected, ::testing::Contains(::testing::Gt(0)));
  GlApp gl_app(42);
  for (int round = 0; round < 12; ++round) {
    gl_app.randomise();
    EXPECT_THAT(pixels(&renderer), LooksLike(expected)) << "round " << round;
  }
  gl_app.finish();
}

TEST_F(MapContract, TheOtherPoliciesDrawTheSame) {
  MapRenderer preserving = makeRenderer(GlStatePolicy::preserve);
  const std::vector<std::uint8_t> expected = pixels(&preserving);
  for (const GlStatePolicy policy : {GlStatePolicy::reset, GlStatePolicy::none}) {
    MapRenderer renderer = makeRenderer(policy);
    EXPECT_THAT(pixels(&renderer), LooksLike(expected));
    EXPECT_THAT(pixels(&renderer), LooksLike(expected));
  }
}

TEST_F(MapContract, ResetLeavesANewContextsState) {
  const GlSnapshot initial = contextState();
  for (const PublicCall& call : everyCall(GlStatePolicy::reset)) {
    call.run();
    EXPECT_EQ(differences(initial, contextState()), "") << call.name;
  }
}

TEST_F(MapContract, LeavesNoNames) {
  const auto buffers = [] {
    int count = 0;
    for (GLuint name = 1; name < 64; ++name) {
      count += glIsBuffer(name) == GL_TRUE || glIsVertexArray(name) == GL_TRUE ? 1 : 0;
      count += glIsProgram(name) == GL_TRUE || glIsSampler(name) == GL_TRUE ? 1 : 0;
    }
    return count;
  };
  const int before = buffers();
  {
    MapRenderer renderer = makeRenderer(GlStatePolicy::preserve);
    EXPECT_EQ(buffers(), before) << "objects are made by the first draw";
    draw(&renderer);
    const int during = buffers();
    EXPECT_GT(during, before);
    draw(&renderer);
    EXPECT_EQ(buffers(), during);
    renderer.releaseGl();
    EXPECT_EQ(buffers(), before);
    draw(&renderer);
  }
  EXPECT_EQ(buffers(), before);
}

TEST_F(MapContract, IsMadeAnewInAContextThatDoesNotShare) {
  MapRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  const std::vector<std::uint8_t> expected = pixels(&renderer);
  destroyApp();
  const AppContext other = makeContext(ContextSharing::none);
  EXPECT_THAT(pixels(&renderer), LooksLike(expected));
  renderer.releaseGl();
  EXPECT_THAT(other.complaints(), IsEmpty());
}

TEST_F(MapContract, DestroyedInAnotherContextItHarmsNobody) {
  std::optional<MapRenderer> renderer = makeRenderer(GlStatePolicy::preserve);
  draw(&*renderer);
  const AppContext other = makeContext(ContextSharing::none);
  const GlApp bystander(23);
  const GlSnapshot objects = bystander.objects();
  renderer.reset();
  EXPECT_EQ(differences(objects, bystander.objects()), "");
  EXPECT_THAT(other.complaints(), IsEmpty());
}

TEST_F(MapContract, WorksInEveryContextOfAShareGroup) {
  MapRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  const std::vector<std::uint8_t> expected = pixels(&renderer);
  {
    const AppContext second = makeContext(ContextSharing::current);
    EXPECT_THAT(pixels(&renderer), LooksLike(expected));
    EXPECT_THAT(second.complaints(), IsEmpty());
  }
  app().makeCurrent();
  EXPECT_THAT(pixels(&renderer), LooksLike(expected));
}

TEST_F(MapContract, WithoutAContextItSaysSoAndLosesNothing) {
  MapRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  const std::vector<std::uint8_t> expected = pixels(&renderer);
  makeNoContextCurrent();
  const Status drawn = renderer.draw(cornerView(kViewport), kViewport);
  ASSERT_FALSE(drawn.ok());
  EXPECT_EQ(drawn.error().code, ErrorCode::missing_context);
  EXPECT_FALSE(MapRenderer::create(GlStatePolicy::preserve).ok());
  app().makeCurrent();
  EXPECT_THAT(pixels(&renderer), LooksLike(expected));
}

}  // namespace
}  // namespace glide::test
