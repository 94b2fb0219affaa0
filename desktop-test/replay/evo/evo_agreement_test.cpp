#include "replay/cli/rendered_dataset.h"
#include "replay/cli/replay_program.h"
#include "replay/common/text.h"
#include "replay/evaluation/accuracy.h"
#include "replay/evaluation/random_trajectories.h"
#include "replay/readers/scratch_folder.h"
#include "support/data_path.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <random>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;

constexpr double kAgreement = 1e-6;  // m
constexpr std::int64_t kStart = 1'403'636'584'763'555'584;
constexpr std::int64_t kMs = 1'000'000;

/// Runs `evo_ape tum TRUTH ESTIMATE -as` and returns its RMSE to all digits.
class EvoAgreement : public testing::Test {
 protected:
  void SetUp() override {
    if (!fs::exists(fs::path(GLIDE_EVO_VENV) / "bin/evo_ape")) {
      GTEST_SKIP() << "evo is not installed in " << GLIDE_EVO_VENV
                   << " (the test evo_setup tells why)";
    }
  }

  std::optional<double> evoRmse(const fs::path& truth, const fs::path& estimate) const {
    return evoRmse("tum", truth, estimate);
  }

  std::optional<double> evoRmse(const std::string& format,
                                const fs::path& truth,
                                const fs::path& estimate) const {
    const std::string venv = GLIDE_EVO_VENV;
    const std::string zip = (folder_.path() / "evo.zip").string();
    fs::remove(zip);
    const ProgramResult evo = runShell(
        "HOME=" + folder_.path().string() + " " + venv + "/bin/evo_ape " + format + " " +
            truth.string() + " " + estimate.string() + " -as --no_warnings --save_results " + zip,
        folder_.path());
    EXPECT_EQ(evo.exit_code, 0) << evo.out << evo.err;
    const ProgramResult stats = runShell(venv +
                                             "/bin/python -c 'import json,zipfile,sys; "
                                             "print(repr(json.load(zipfile.ZipFile(sys.argv[1])."
                                             "open(\"stats.json\"))[\"rmse\"]))' " +
                                             zip,
                                         folder_.path());
    return parseNumber(stats.out.substr(0, stats.out.find('\n')));
  }

  void expectAgreement(const Trajectory& truth, const Trajectory& estimate) {
    const fs::path truth_file = folder_.write("truth.tum", tumText(truth));
    const fs::path estimate_file = folder_.write("estimate.tum", tumText(estimate));
    const auto ours = absoluteError(readGroundTruth(truth_file)->poses, estimate);
    const auto evos = evoRmse(truth_file, estimate_file);
    ASSERT_TRUE(ours.has_value());
    ASSERT_TRUE(evos.has_value());
    EXPECT_GT(*evos, 1e-3);  // noise of some millimetres
    EXPECT_NEAR(ours->rmse_m, *evos, kAgreement);
  }

  const ScratchFolder folder_;
};

/// Some of the poses, each moved in time by up to `jitter_ns`.
Trajectory thinned(const Trajectory& path, double share, std::int64_t jitter_ns) {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> uniform(0.0, 1.0);
  std::uniform_int_distribution<std::int64_t> jitter(-jitter_ns, jitter_ns);
  Trajectory result;
  for (const StampedPose& pose : path) {
    if (uniform(random) < share) result.push_back({pose.t_ns + jitter(random), pose.T_world_rig});
  }
  return result;
}

TEST_F(EvoAgreement, HoldsForEqualTimes) {
  const Trajectory truth = smoothPath(kStart, 50 * kMs, 300);
  expectAgreement(truth, estimateOf(truth, 0.005, 1));
}

TEST_F(EvoAgreement, HoldsForADenseTruthAndAnEstimateWithGapsAndJitter) {
  const Trajectory truth = smoothPath(kStart, 5 * kMs, 3000);
  expectAgreement(truth, thinned(estimateOf(truth, 0.005, 2), 0.1, 4 * kMs));
}

TEST_F(EvoAgreement, HoldsForASparseTruthAndADenseEstimate) {
  const Trajectory dense = smoothPath(kStart, 7 * kMs, 2000);
  expectAgreement(thinned(dense, 0.15, 9 * kMs), estimateOf(dense, 0.005, 3));
}

TEST_F(EvoAgreement, HoldsWhereTimesLieExactlyOnTheLimitAndBetweenTwoPoses) {
  // Truth every 20 ms, estimates half way between two of them: ties at exactly 10 ms.
  const Trajectory truth = smoothPath(1'000'000'000, 20 * kMs, 500);
  Trajectory estimate = estimateOf(truth, 0.005, 4);
  for (StampedPose& pose : estimate) pose.t_ns += 10 * kMs;
  estimate.erase(estimate.begin() + 100, estimate.begin() + 120);
  expectAgreement(truth, estimate);
}

TEST_F(EvoAgreement, HoldsForWhatReplayWrites) {
  const fs::path dataset = folder_.path() / "dataset", out = folder_.path() / "out";
  writeRenderedDataset(dataset);
  const ProgramResult replay = runReplay(
      {dataset.string(), "--deterministic", "--json", "-o", out.string()}, folder_.path());
  ASSERT_EQ(replay.exit_code, 0) << replay.err;
  const double ours = nlohmann::json::parse(replay.out)["accuracy"]["ate_rmse_m"];
  for (const fs::path& truth : {dataset / "groundtruth.txt", out / "groundtruth.tum"}) {
    const auto evos = evoRmse(truth, out / "trajectory.tum");
    ASSERT_TRUE(evos.has_value());
    EXPECT_NEAR(ours, *evos, kAgreement);
  }
}

TEST_F(EvoAgreement, HoldsForTheBodysTrajectoryAgainstARawEurocTruth) {
  const auto euroc = test::sharedData("euroc_MH01_5s-21s");
  if (!euroc) GTEST_SKIP() << "../shared/data/euroc_MH01_5s-21s is not there";
  const fs::path out = folder_.path() / "out";
  const ProgramResult replay = runReplay({euroc->string(),
                                          "--deterministic",
                                          "--max-frames",
                                          "60",
                                          "--trajectory-frame",
                                          "body",
                                          "--json",
                                          "-o",
                                          out.string()},
                                         folder_.path());
  ASSERT_EQ(replay.exit_code, 0) << replay.err;
  const double ours = nlohmann::json::parse(replay.out)["accuracy"]["ate_rmse_m"];
  const fs::path truth = *euroc / "mav0/state_groundtruth_estimate0/data.csv";
  const auto evos = evoRmse("euroc", truth, out / "trajectory.tum");
  ASSERT_TRUE(evos.has_value());
  EXPECT_NEAR(ours, *evos, kAgreement);
}

}  // namespace
}  // namespace glide::replay
