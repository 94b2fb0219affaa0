// CameraRenderer inside of an app's contexts (docs/gl-contract.md).
#include "support/app_texture.h"
#include "support/gl_app.h"
#include "support/gl_snapshot.h"

#include "render/camera_scene.h"
#include "render/contract_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>

namespace glide::test {
namespace {

using ::testing::IsEmpty;

constexpr std::uint8_t kGrey = 113;

constexpr int kWidth = 64, kHeight = 48;  // of ContractTest's target
constexpr Viewport kViewport{0, 0, kWidth, kHeight};

/// Everything public, with pictures of every kind that there is here.
class EveryCall {
 public:
  EveryCall(GlStatePolicy policy, const std::vector<AppTexture>& textures) : policy_(policy) {
    pictures_.emplace_back(Luma{bytes_.data(), kWidth, kHeight, kWidth});
    pictures_.emplace_back(Rgb{bytes_.data(), kWidth, kHeight, 3 * kWidth});
    for (const AppTexture& texture : textures)
      pictures_.emplace_back(texture.texture(kUpperRowFirst));
  }

  std::vector<PublicCall> calls() {
    calls_.clear();
    add("create", [this] { create(); });
    addDrawing();
    add("releaseGl", [this] { renderer_->releaseGl(); });
    addDrawing();
    add("abandonGl", [this] { renderer_->abandonGl(); });
    add("drawPicture after abandonGl", [this] { draw(pictures_.front()); });
    add("destruction", [this] { renderer_.reset(); });
    return calls_;
  }

 private:
  void add(const std::string& name, std::function<void()> run) {
    calls_.push_back({name, std::move(run)});
  }
  void addDrawing() {
    for (const Picture& picture : pictures_)
      add("drawPicture " + std::to_string(picture.index()), [this, &picture] { draw(picture); });
    add("drawPoints", [this] {
      const std::vector<TrackedPoint> points = gridOfPoints(pinhole(kWidth, kHeight), frame_++);
      EXPECT_TRUE(renderer_->drawPoints(points, TrackerKind::direct, kViewport).ok());
    });
    add("drawAr", [this] {
      const std::vector<Pose> cubes{{}};
      ArContent content;
      content.cubes = cubes;
      EXPECT_TRUE(renderer_->drawAr(content, lookAt({0.1, -0.2, -0.5}, {}), kViewport).ok());
    });
  }
  void create() {
    Result<CameraRenderer> made = CameraRenderer::create(policy_, pinhole(kWidth, kHeight));
    ASSERT_TRUE(made.ok()) << made.error().message;
    renderer_.emplace(std::move(*made));
  }
  void draw(const Picture& picture) {
    const Status status = renderer_->drawPicture(picture, kViewport);
    EXPECT_TRUE(status.ok()) << status.error().message;
  }

  GlStatePolicy policy_;
  std::vector<std::uint8_t> bytes_ =
      std::vector<std::uint8_t>(static_cast<std::size_t>(3 * kWidth * kHeight), kGrey);
  std::vector<Picture> pictures_;
  std::vector<PublicCall> calls_;
  std::optional<CameraRenderer> renderer_;
  int frame_ = 0;
};

class CameraContract : public ContractTest {
 protected:
  /// One of each kind that there is.
  std::vector<AppTexture> makeTextures() const {
    std::vector<AppTexture> textures;
    for (const AppTextureKind kind : {AppTextureKind::rgba8, AppTextureKind::external}) {
      Result<AppTexture> texture = AppTexture::create(kind, kWidth, kHeight);
      if (!texture || (kind == AppTextureKind::external && !caps().has_external)) continue;
      texture->write(
          std::vector<std::uint8_t>(static_cast<std::size_t>(4 * kWidth * kHeight), kGrey));
      textures.push_back(std::move(*texture));
    }
    return textures;
  }
  static CameraRenderer makeRenderer(GlStatePolicy policy) {
    Result<CameraRenderer> made = CameraRenderer::create(policy, pinhole(kWidth, kHeight));
    EXPECT_TRUE(made.ok()) << made.error().message;
    return std::move(*made);
  }
  static Status drawGrey(CameraRenderer* renderer) {
    const std::vector<std::uint8_t> bytes(static_cast<std::size_t>(kWidth * kHeight), kGrey);
    return renderer->drawPicture(Luma{bytes.data(), kWidth, kHeight, kWidth}, kViewport);
  }
};

TEST_F(CameraContract, NoCallChangesAnyStateOfTheApp) {
  const std::vector<AppTexture> textures = makeTextures();
  EveryCall renderer(GlStatePolicy::preserve, textures);
  expectNoTrace(renderer.calls(), kStateSeed);
}

TEST_F(CameraContract, ErrorsThatTheAppHasNotFetchedStayAndStayAlone) {
  const std::vector<AppTexture> textures = makeTextures();
  EveryCall renderer(GlStatePolicy::preserve, textures);
  expectErrorsUntouched(renderer.calls());
}

TEST_F(CameraContract, InAnyStateOfTheAppThePictureIsRight) {
  CameraRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  GlApp gl_app(42);
  for (int round = 0; round < 12; ++round) {
    gl_app.randomise();
    target().begin(kBlack);
    EXPECT_TRUE(drawGrey(&renderer).ok());
    EXPECT_THAT(target().readRgb(), ::testing::Each(kGrey)) << "round " << round;
  }
  gl_app.finish();
}

TEST_F(CameraContract, WithEveryPolicyOneDrawFollowsTheOtherIntoTheSameFramebuffer) {
  std::vector<std::vector<std::uint8_t>> pictures;
  for (const GlStatePolicy policy :
       {GlStatePolicy::preserve, GlStatePolicy::reset, GlStatePolicy::none}) {
    CameraRenderer renderer = makeRenderer(policy);
    const std::vector<Pose> cubes{{}};
    ArContent content;
    content.cubes = cubes;
    pictures.push_back(
        drawn(kWidth, kHeight, [&](const Viewport& viewport) {
          EXPECT_TRUE(drawGrey(&renderer).ok());
          EXPECT_TRUE(renderer.drawAr(content, lookAt({0.1, -0.2, -0.5}, {}), viewport).ok());
        }).pixels);
  }
  EXPECT_EQ(pictures[1], pictures[0]);
  EXPECT_EQ(pictures[2], pictures[0]);
}

TEST_F(CameraContract, ResetLeavesANewContextsState) {
  const GlSnapshot initial = contextState();
  EveryCall renderer(GlStatePolicy::reset, {});
  for (const PublicCall& call : renderer.calls()) {
    call.run();
    EXPECT_EQ(differences(initial, contextState()), "") << call.name;
  }
}

TEST_F(CameraContract, IsMadeAnewInAContextThatDoesNotShare) {
  CameraRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  EXPECT_TRUE(drawGrey(&renderer).ok());
  destroyApp();
  const AppContext other = makeContext(ContextSharing::none);
  const RgbPicture shown =
      drawn(kWidth, kHeight, [&](const Viewport&) { EXPECT_TRUE(drawGrey(&renderer).ok()); });
  EXPECT_THAT(shown.pixels, ::testing::Each(kGrey));
  renderer.releaseGl();
  EXPECT_THAT(other.complaints(), IsEmpty());
}

TEST_F(CameraContract, WorksInAnotherContextOfTheGroup) {
  CameraRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  EXPECT_TRUE(drawGrey(&renderer).ok());
  glFlush();
  {
    const AppContext other = makeContext(ContextSharing::current);
    target().begin(kBlack);
    EXPECT_TRUE(drawGrey(&renderer).ok());
    EXPECT_THAT(target().readRgb(), ::testing::Each(kGrey));
    EXPECT_THAT(other.complaints(), IsEmpty());
  }
  app().makeCurrent();
  target().begin(kBlack);
  EXPECT_TRUE(drawGrey(&renderer).ok());
  EXPECT_THAT(target().readRgb(), ::testing::Each(kGrey));
}

TEST_F(CameraContract, WithoutAFramebufferItSaysSoInsteadOfRaisingAnError) {
  CameraRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  GLuint framebuffer = 0;
  glGenFramebuffers(1, &framebuffer);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
  for (const Status& status : {drawGrey(&renderer), renderer.drawAr({}, {}, kViewport)}) {
    ASSERT_FALSE(status.ok());
    EXPECT_EQ(status.error().code, ErrorCode::invalid_argument);
  }
  glDeleteFramebuffers(1, &framebuffer);
}

TEST_F(CameraContract, WithoutAContextItSaysSoAndLosesNothing) {
  CameraRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  EXPECT_TRUE(drawGrey(&renderer).ok());
  makeNoContextCurrent();
  const Status drawn_nowhere = drawGrey(&renderer);
  ASSERT_FALSE(drawn_nowhere.ok());
  EXPECT_EQ(drawn_nowhere.error().code, ErrorCode::missing_context);
  const Result<CameraRenderer> made =
      CameraRenderer::create(GlStatePolicy::preserve, pinhole(kWidth, kHeight));
  EXPECT_FALSE(made.ok());
  app().makeCurrent();
  EXPECT_TRUE(drawGrey(&renderer).ok());
}

TEST_F(CameraContract, TheSameTextureTakesEveryPictureOfASize) {
  CameraRenderer renderer = makeRenderer(GlStatePolicy::preserve);
  const auto textures = [] {
    int count = 0;
    for (GLuint name = 1; name < 64; ++name) count += glIsTexture(name) == GL_TRUE ? 1 : 0;
    return count;
  };
  const int before = textures();
  for (int frame = 0; frame < 5; ++frame) EXPECT_TRUE(drawGrey(&renderer).ok());
  EXPECT_EQ(textures(), before + 1);
  renderer.releaseGl();
  EXPECT_EQ(textures(), before);
}

}  // namespace
}  // namespace glide::test
