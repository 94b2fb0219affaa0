#include "gpu/tuning_trial.h"

#include "support/temporary_folder.h"

#include "gpu/align_fixture.h"
#include "gpu/gl_test.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace glide::test {
namespace {

class TuningTrialTest : public GlTest {
 protected:
  TuningTrial trial(const Config& config) const {
    return {caps(),
            config,
            testCamera(DistortionModel::radial_tangential, imageWidth(), imageHeight())};
  }
  Config config() const {
    Config config;
    config.direct.max_points = pointCount();
    return config;
  }
};

TEST_F(TuningTrialTest, RunsEveryCandidateOfThisDevice) {
  TuningTrial trial = this->trial(config());
  for (const PyramidKernel pyramid : {PyramidKernel::strip, PyramidKernel::tile}) {
    const GpuTuning tuning{64, GpuPlan::fused, pyramid, 0};
    const std::optional<double> frame_ms = trial.frameMs(tuning, ProgramCache());
    ASSERT_TRUE(frame_ms.has_value());
    EXPECT_GT(*frame_ms, 0.0);
  }
}

TEST_F(TuningTrialTest, RefusesWhatTheDeviceCannotRun) {
  TuningTrial trial = this->trial(config());
  const GpuTuning impossible{48, GpuPlan::fused, PyramidKernel::strip, 0};
  EXPECT_EQ(trial.frameMs(impossible, ProgramCache()), std::nullopt);
}

TEST_F(TuningTrialTest, LeavesItsProgramsToTheSession) {
  if (caps().program_binary_formats.empty()) {
    GTEST_SKIP() << caps().renderer << " has no program binary format";
  }
  const TemporaryFolder folder;
  const ProgramCache programs({folder.path().string(), caps()}, caps());
  TuningTrial trial = this->trial(config());
  trial.frameMs(GpuTuning{}, programs);
  EXPECT_FALSE(std::filesystem::is_empty(folder.path()));
}

TEST_F(TuningTrialTest, HasAClockThatGoesOn) {
  TuningTrial trial = this->trial(config());
  const TuningProbe probe = trial.probe(ProgramCache());
  const double before_ms = probe.now_ms();
  ASSERT_TRUE(probe.frame_ms(GpuTuning{}).has_value());
  EXPECT_GT(probe.now_ms(), before_ms);
}

}  // namespace
}  // namespace glide::test
