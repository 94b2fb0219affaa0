#include "gpu/autotuner.h"

#include "support/temporary_folder.h"

#include "gpu/gl_caps.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <vector>

namespace glide::test {
namespace {

/// A device that exists on paper: what frames take, what trying costs, and what was tried.
class FakeDevice {
 public:
  using Frame = std::function<std::optional<double>(const GpuTuning&)>;

  FakeDevice(double trial_ms, Frame frame_ms)
      : trial_ms_(trial_ms), frame_ms_(std::move(frame_ms)) {}

  TuningProbe probe() {
    return {[this](const GpuTuning& tuning) {
              tried_.push_back(tuning);
              now_ms_ += trial_ms_;
              return frame_ms_(tuning);
            },
            [this] { return now_ms_; }};
  }
  const std::vector<GpuTuning>& tried() const { return tried_; }
  double nowMs() const { return now_ms_; }

 private:
  double trial_ms_;
  Frame frame_ms_;
  std::vector<GpuTuning> tried_;
  double now_ms_ = 1e6;  // a clock may start anywhere
};

/// Likes small groups, tiles, and one group for all levels.
std::optional<double> pickyFrameMs(const GpuTuning& tuning) {
  double ms = 10.0 + tuning.group_size / 64.0;
  if (tuning.pyramid == PyramidKernel::tile) ms -= 2.0;
  if (tuning.single_group_pixels > 50'000) ms -= 3.0;
  return ms;
}

constexpr double kQuick = 1.0;

TEST(Autotuner, PicksTheFastestOfWhatItMeasures) {
  FakeDevice device(kQuick, pickyFrameMs);
  const GpuTuning chosen = fastestTuning(device.probe());
  EXPECT_EQ(chosen.pyramid, PyramidKernel::tile);
  EXPECT_GT(chosen.single_group_pixels, 50'000);
  EXPECT_EQ(chosen.plan, GpuPlan::fused);
  for (const GpuTuning& tuning : device.tried()) {
    EXPECT_GE(*pickyFrameMs(tuning) * 1.06, *pickyFrameMs(chosen));
  }
}

TEST(Autotuner, KeepsTheDefaultsWhereNothingIsClearlyFaster) {
  FakeDevice device(kQuick, [](const GpuTuning& tuning) {
    return tuning == GpuTuning{} ? 10.0 : 9.7;  // 3 %: noise
  });
  EXPECT_EQ(fastestTuning(device.probe()), GpuTuning{});
}

TEST(Autotuner, StaysInItsBudget) {
  for (const double trial_ms : {7.0, 40.0, 70.0, 99.0, 140.0, 290.0}) {
    FakeDevice device(trial_ms, pickyFrameMs);
    const double start_ms = device.nowMs();
    fastestTuning(device.probe());
    EXPECT_LE(device.nowMs() - start_ms, kTuningBudgetMs) << trial_ms;
    EXPECT_GE(device.tried().size(), 1U);
  }
}

TEST(Autotuner, IsContentWithTheBestSoFarWhenTheBudgetEnds) {
  FakeDevice device(140.0, [](const GpuTuning& tuning) { return 100.0 - tuning.group_size / 2.0; });
  EXPECT_EQ(fastestTuning(device.probe()).group_size, 128);
  EXPECT_EQ(device.tried().size(), 2U);
}

TEST(Autotuner, GivesUpAfterOneCandidateThatIsSlowToBuild) {
  FakeDevice device(2'000.0, pickyFrameMs);
  EXPECT_EQ(fastestTuning(device.probe()), GpuTuning{});
  EXPECT_EQ(device.tried().size(), 1U);
}

TEST(Autotuner, TakesNothingThatTheDeviceCannotRun) {
  FakeDevice device(kQuick, [](const GpuTuning& tuning) -> std::optional<double> {
    if (tuning.group_size == 128) return std::nullopt;
    return tuning.group_size == 32 ? 5.0 : 10.0;
  });
  EXPECT_EQ(fastestTuning(device.probe()).group_size, 32);
  FakeDevice broken(kQuick, [](const GpuTuning&) { return std::nullopt; });
  EXPECT_EQ(fastestTuning(broken.probe()), GpuTuning{});
}

TEST(Autotuner, IsNotFooledByADeviceThatClocksUp) {
  int frames = 0;
  FakeDevice device(kQuick, [&](const GpuTuning&) { return 10.0 / ++frames; });
  EXPECT_EQ(fastestTuning(device.probe()), GpuTuning{});
}

class ChooseTuning : public testing::Test {
 protected:
  static GlCaps device() {
    GlCaps caps;
    caps.renderer = "made up";
    return caps;
  }
  static Config config() {
    Config config;
    config.camera.width = 640;
    config.camera.height = 480;
    return config;
  }
  GpuTuning choose(const Config& config, const DeviceCache& files) {
    return chooseTuning(config, quirks_, files, device_.probe());
  }

  const TemporaryFolder folder_;
  const DeviceCache files_{folder_.path().string(), device()};
  FakeDevice device_{kQuick, pickyFrameMs};
  DriverQuirks quirks_;
};

TEST_F(ChooseTuning, TriesOnceAndThenKnows) {
  const GpuTuning first = choose(config(), files_);
  EXPECT_NE(first, GpuTuning{});
  const std::size_t tried = device_.tried().size();
  EXPECT_EQ(choose(config(), files_), first);
  EXPECT_EQ(device_.tried().size(), tried);
}

TEST_F(ChooseTuning, KnowsAnotherImageSizeAndPatchApart) {
  choose(config(), files_);
  for (const auto change : {+[](Config* c) { c->camera.width = 752; },
                            +[](Config* c) { c->direct.patch_size = 7; },
                            +[](Config* c) { c->direct.levels = 5; },
                            +[](Config* c) { c->direct.max_points = 1000; }}) {
    Config other = config();
    change(&other);
    const std::size_t tried = device_.tried().size();
    choose(other, files_);
    EXPECT_GT(device_.tried().size(), tried);
  }
}

TEST_F(ChooseTuning, TriesNothingWhenItIsOff) {
  Config off = config();
  off.gl.autotune = GpuAutotune::off;
  EXPECT_EQ(choose(off, files_), GpuTuning{});
  EXPECT_TRUE(device_.tried().empty());
  EXPECT_TRUE(std::filesystem::is_empty(folder_.path()));
  const GpuTuning known = choose(config(), files_);
  EXPECT_EQ(choose(off, files_), known);
}

TEST_F(ChooseTuning, TriesNothingWhereEveryRunMustGiveTheSameBytes) {
  Config repeatable = config();
  repeatable.execution = Execution::inline_;
  EXPECT_EQ(choose(repeatable, files_), GpuTuning{});
  EXPECT_TRUE(device_.tried().empty());
  const GpuTuning known = choose(config(), files_);
  EXPECT_EQ(choose(repeatable, files_), known);
}

TEST_F(ChooseTuning, TriesNothingThatItCouldNotKeep) {
  EXPECT_EQ(choose(config(), DeviceCache()), GpuTuning{});
  EXPECT_TRUE(device_.tried().empty());
}

TEST_F(ChooseTuning, TriesNothingWhereBuildingTakesTooLong) {
  quirks_.has_slow_builds = true;
  EXPECT_EQ(choose(config(), files_), GpuTuning{});
  EXPECT_TRUE(device_.tried().empty());
}

TEST_F(ChooseTuning, TakesThePapersPlanWhenItIsAskedFor) {
  choose(config(), files_);
  Config paper = config();
  paper.gl.plan = GpuPlanChoice::paper;
  GpuTuning expected;
  expected.plan = GpuPlan::paper;
  EXPECT_EQ(choose(paper, files_), expected);
}

TEST_F(ChooseTuning, TriesAgainWhenTheFileIsDamaged) {
  const GpuTuning first = choose(config(), files_);
  for (const auto& entry : std::filesystem::directory_iterator(folder_.path())) {
    std::filesystem::resize_file(entry.path(), 20);
  }
  const std::size_t tried = device_.tried().size();
  EXPECT_EQ(choose(config(), files_), first);
  EXPECT_GT(device_.tried().size(), tried);
}

TEST(TuningBytes, GiveBackTheTuning) {
  const GpuTuning tuning{128, GpuPlan::fused, PyramidKernel::tile, 100'000};
  EXPECT_EQ(decodeTuning(encodeTuning(tuning)), tuning);
}

TEST(TuningBytes, AreRefusedWhenNoKernelIsMadeForThem) {
  EXPECT_EQ(decodeTuning({}), std::nullopt);
  GpuTuning tuning;
  tuning.group_size = 48;
  EXPECT_EQ(decodeTuning(encodeTuning(tuning)), std::nullopt);
  tuning = {};
  tuning.single_group_pixels = -1;
  EXPECT_EQ(decodeTuning(encodeTuning(tuning)), std::nullopt);
  std::vector<std::byte> bytes = encodeTuning({});
  bytes[8] = std::byte{3};  // one more than PyramidKernel::two_pass
  EXPECT_EQ(decodeTuning(bytes), std::nullopt);
}

}  // namespace
}  // namespace glide::test
