// CameraRenderer inside of an app's contexts (docs/gl-contract.md).
#include "support/app_context.h"
#include "support/app_texture.h"
#include "support/gl_app.h"

#include "render/camera_scene.h"

#include "gpu/gl_test.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <functional>
#include <optional>
#include <string>

namespace glide::test {
namespace {

using ::testing::IsEmpty;

constexpr int kWidth = 64, kHeight = 48;
constexpr Viewport kViewport{0, 0, kWidth, kHeight};
constexpr std::uint8_t kGrey = 113;
constexpr Color kBlack{0.0F, 0.0F, 0.0F, 1.0F};

/// A call of the public API, and what it is called in messages.
struct PublicCall {
  std::string name;
  std::function<void()> run;
};

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

/// Each test begins in a new context of an app.
class CameraContract : public GlTest {
 protected:
  void SetUp() override {
    GlTest::SetUp();
    if (IsSkipped() || HasFatalFailure()) return;
    main_.emplace();
    app_.emplace(makeContext(ContextSharing::none));
    Result<RenderTarget> target = RenderTarget::create(kWidth, kHeight);
    ASSERT_TRUE(target.ok()) << target.error().message;
    target_.emplace(std::move(*target));
    target_->begin(kBlack);
  }
  void TearDown() override {
    if (app_) {
      EXPECT_THAT(app_->complaints(), IsEmpty());
    }
    target_.reset();
    app_.reset();
    main_.reset();
    GlTest::TearDown();
  }
  AppContext& app() { return *app_; }
  /// What is drawn into; in a new context, after begin().
  RenderTarget& target() { return *target_; }
  AppContext makeContext(ContextSharing sharing) {
    if (!hasCurrentContext()) main_->restore();  // for its display
    Result<AppContext> context = AppContext::create(sharing);
    EXPECT_TRUE(context.ok()) << context.error().message;
    return std::move(*context);
  }
  void destroyApp() { app_.reset(); }

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

 private:
  std::optional<ScopedCurrentContext> main_;
  std::optional<AppContext> app_;
  std::optional<RenderTarget> target_;
};

TEST_F(CameraContract, NoCallChangesAnyStateOfTheApp) {
  const std::vector<AppTexture> textures = makeTextures();
  GlApp gl_app(41);
  EveryCall renderer(GlStatePolicy::preserve, textures);
  for (const PublicCall& call : renderer.calls()) {
    gl_app.randomise();
    target().begin(kBlack);
    const GlSnapshot objects = gl_app.objects();
    const GlSnapshot before = contextState();
    call.run();
    EXPECT_EQ(differences(before, contextState()), "") << call.name;
    EXPECT_EQ(differences(objects, gl_app.objects()), "") << call.name;
    ASSERT_FALSE(HasFailure()) << call.name;
  }
  gl_app.finish();
}

TEST_F(CameraContract, ErrorsThatTheAppHasNotFetchedStayAndStayAlone) {
  const std::vector<AppTexture> textures = makeTextures();
  EveryCall renderer(GlStatePolicy::preserve, textures);
  constexpr GLenum kNoCapability = 0xBAD;
  for (const PublicCall& call : renderer.calls()) {
    glEnable(kNoCapability);
    app().forgetComplaints();
    call.run();
    EXPECT_THAT(app().complaints(), IsEmpty()) << call.name;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_INVALID_ENUM)) << call.name;
    EXPECT_EQ(glGetError(), static_cast<GLenum>(GL_NO_ERROR)) << call.name;
  }
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
