#include "guest/guest_fixture.h"
#include "support/app_texture.h"
#include "support/gl_app.h"
#include "support/gl_snapshot.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace glide::test {
namespace {

/// Everything public, in an order in which each does GL work if it can.
class EveryCall {
 public:
  using Feed = std::function<Result<FrameResult>(Session*, int)>;

  EveryCall(const Config& config, Feed feed) : config_(config), feed_(std::move(feed)) {}

  /// With so many updates until a map is there.
  std::vector<PublicCall> calls(int frames) {
    calls_.clear();
    add("create", [this] {
      Result<Session> made = Session::create(config_);
      ASSERT_TRUE(made.ok()) << made.error().message;
      session_.emplace(std::move(*made));
    });
    addUpdates(frames);
    addMapCalls();
    add("locate", [this] { session_->locate(0); });
    add("map", [this] { session_->map(); });
    add("waitForMapping", [this] { session_->waitForMapping(); });
    add("backend", [this] { session_->backend(); });
    add("releaseGl", [this] { session_->releaseGl(); });
    addUpdates(3);
    add("abandonGl", [this] { session_->abandonGl(); });
    addUpdates(1);
    add("destruction", [this] { session_.reset(); });
    return calls_;
  }
  int directFrames() const { return direct_frames_; }

 private:
  void add(const std::string& name, std::function<void()> run) {
    calls_.push_back({name, std::move(run)});
  }
  void addUpdates(int frames) {
    for (int i = 0; i < frames; ++i) {
      const int frame = next_frame_++;
      add("update " + std::to_string(frame), [this, frame] { update(frame); });
    }
  }
  void addMapCalls() {
    add("saveMap", [this] { map_ = session_->saveMap().value(); });
    add("reset", [this] { session_->reset(); });
    add("pause", [this] { session_->pause(); });
    addUpdates(1);
    add("resume", [this] { session_->resume(); });
    addUpdates(1);
    add("loadMap", [this] { EXPECT_TRUE(session_->loadMap(map_).ok()); });
    addUpdates(3);
  }
  void update(int frame) {
    const Result<FrameResult> result = feed_(&*session_, frame);
    ASSERT_TRUE(result.ok()) << result.error().message;
    direct_frames_ += result->tracker == TrackerKind::direct ? 1 : 0;
  }

  Config config_;
  Feed feed_;
  std::vector<PublicCall> calls_;
  std::optional<Session> session_;
  std::vector<std::byte> map_;
  int next_frame_ = 0, direct_frames_ = 0;
};

/// What the app gives as a frame's image.
enum class Input { luma, texture, external_texture };

std::string inputName(const ::testing::TestParamInfo<Input>& test) {
  constexpr const char* kNames[] = {"Luma", "Texture", "ExternalTexture"};
  return kNames[static_cast<std::size_t>(test.param)];
}

class GuestStateTest : public GuestTest, public ::testing::WithParamInterface<Input> {
 protected:
  /// False where the driver has no such textures. Before the app's state is random.
  bool makeTextures(int frames) {
    if (GetParam() == Input::luma) return true;
    const auto kind = GetParam() == Input::texture ? AppTextureKind::r8 : AppTextureKind::external;
    for (int frame = 0; frame < frames; ++frame) {
      const ImageU8& image = walkImage(frame);
      Result<AppTexture> texture = AppTexture::create(kind, image.width(), image.height());
      if (!texture) return false;
      texture->write(image.view());
      textures_.push_back(std::move(*texture));
    }
    return true;
  }
  EveryCall everyCall() const {
    return EveryCall(config(), [this](Session* session, int frame) {
      if (textures_.empty()) return feed(session, frame);
      const AppTexture& texture = textures_[static_cast<std::size_t>(frame)];
      return feed(session, frame, texture.texture(kUpperRowFirst));
    });
  }

  /// Until there is a map and a direct frame, and some more.
  static constexpr int kFrames = 16;
  static constexpr int kAllFrames = kFrames + 10;

 private:
  std::vector<AppTexture> textures_;
};

TEST_P(GuestStateTest, NoCallChangesAnyStateOfTheApp) {
  if (!makeTextures(kAllFrames)) GTEST_SKIP() << "no such textures on " << caps().renderer;
  constexpr std::uint32_t kSeed = 5;
  EveryCall session = everyCall();
  expectNoTrace(session.calls(kFrames), kSeed);
  EXPECT_GT(session.directFrames(), 0) << "the app's state kept the kernels from working";
}

TEST_P(GuestStateTest, ErrorsThatTheAppHasNotFetchedStayAndStayAlone) {
  if (!makeTextures(kAllFrames)) GTEST_SKIP() << "no such textures on " << caps().renderer;
  EveryCall session = everyCall();
  expectErrorsUntouched(session.calls(kFrames));
}

INSTANTIATE_TEST_SUITE_P(Inputs,
                         GuestStateTest,
                         ::testing::Values(Input::luma, Input::texture, Input::external_texture),
                         inputName);

class GuestPolicyTest : public GuestTest {};

TEST_F(GuestPolicyTest, TheOtherPoliciesTrackTheSamePoses) {
  std::vector<std::vector<double>> positions;
  for (const GlStatePolicy policy :
       {GlStatePolicy::preserve, GlStatePolicy::reset, GlStatePolicy::none}) {
    Config with_policy = config();
    with_policy.gl.state = policy;
    Session session = makeSession(with_policy);
    const int next = trackDirectly(&session);
    const auto& t = feed(&session, next)->T_world_cam.t_xyz;
    positions.emplace_back(t.begin(), t.end());
  }
  EXPECT_EQ(positions[1], positions[0]);
  EXPECT_EQ(positions[2], positions[0]);
}

TEST_F(GuestPolicyTest, ResetLeavesANewContextsState) {
  const GlSnapshot initial = contextState();
  Config reset = config();
  reset.gl.state = GlStatePolicy::reset;
  Session session = makeSession(reset);
  trackDirectly(&session);
  EXPECT_EQ(differences(initial, contextState()), "");
}

TEST_F(GuestPolicyTest, TheTrialOfTheAutotunerLeavesTheStateAndNoNames) {
  Config tuned = config();
  tuned.gl.autotune = GpuAutotune::on;
  GlApp gl_app(9);
  gl_app.randomise();
  const std::vector<int> names = countNames();
  const GlSnapshot before = contextState();
  std::optional<Session> session = makeSession(tuned);
  EXPECT_EQ(differences(before, contextState()), "");
  session.reset();
  EXPECT_EQ(countNames(), names);
  gl_app.finish();
}

}  // namespace
}  // namespace glide::test
