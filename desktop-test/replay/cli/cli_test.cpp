#include "replay/cli/dataset_test.h"
#include "replay/cli/replay_program.h"
#include "replay/common/text.h"
#include "support/data_path.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <sstream>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

class ReplayProgram : public DatasetTest {
 protected:
  ProgramResult run(std::vector<std::string> arguments) {
    arguments.insert(arguments.end(), {"-o", out().string(), "--progress", "none"});
    return runReplay(arguments, folder_.path());
  }
  void blank(const fs::path& folder, int first_frame) {
    for (int i = first_frame; i < kRenderedFrames; ++i) {
      const std::string file = (folder / "rgb" / (std::to_string(i) + ".png")).string();
      cv::imwrite(file, cv::Mat(240, 320, CV_8UC1, cv::Scalar(90)));
    }
  }
};

TEST_F(ReplayProgram, TracksARenderedSequenceAndWritesAllFiles) {
  const ProgramResult result =
      run({dataset().string(), "--deterministic", "--require-tracked", "1"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("ATE rmse, m"));
  const auto stats = nlohmann::json::parse(output("stats.json"));
  EXPECT_EQ(stats["frames"]["in"], kRenderedFrames);
  EXPECT_GT(stats["frames"]["direct"], 0);
  EXPECT_LT(stats["accuracy"]["ate_rmse_m"], 0.01);
  for (const char* name : {"trajectory.tum",
                           "trajectory_live.tum",
                           "keyframes.tum",
                           "frames.csv",
                           "groundtruth.tum",
                           "map.ply",
                           "map.glb",
                           "log.txt"}) {
    EXPECT_FALSE(output(name).empty()) << name;
  }
  EXPECT_THAT(output("log.txt"), HasSubstr("tracking by the indirect tracker"));
}

TEST_F(ReplayProgram, GivesTheSameBytesTwiceWhenDeterministic) {
  ASSERT_EQ(run({dataset().string(), "--deterministic"}).exit_code, 0);
  const std::string trajectory = output("trajectory.tum"), keyframes = output("keyframes.tum");
  const std::string frames = withoutTimes(output("frames.csv"));
  ASSERT_EQ(run({dataset().string(), "--deterministic"}).exit_code, 0);
  EXPECT_EQ(output("trajectory.tum"), trajectory);
  EXPECT_EQ(output("keyframes.tum"), keyframes);
  EXPECT_EQ(withoutTimes(output("frames.csv")), frames);
}

TEST_F(ReplayProgram, PrintsOnlyJsonOnStdoutWhenAsked) {
  const ProgramResult result = run({dataset().string(), "--json", "--max-frames", "3"});
  const auto stats = nlohmann::json::parse(result.out, nullptr, false);
  ASSERT_FALSE(stats.is_discarded()) << result.out;
  EXPECT_EQ(stats["frames"]["in"], 3);
  EXPECT_THAT(result.err, HasSubstr("3 in:"));
}

TEST_F(ReplayProgram, PrintsAConfigThatItReadsBack) {
  const ProgramResult printed = runReplay({"--print-config", "--patch", "7"}, folder_.path());
  EXPECT_EQ(printed.exit_code, 0);
  EXPECT_THAT(printed.out, HasSubstr("patch_size: 7"));
  const fs::path file = folder_.write("config.yaml", printed.out);
  const ProgramResult again =
      runReplay({"--print-config", "--config", file.string()}, folder_.path());
  EXPECT_EQ(again.out, printed.out);
}

TEST_F(ReplayProgram, EndsWithOneOnWrongUsage) {
  EXPECT_EQ(run({}).exit_code, 1);
  EXPECT_EQ(run({dataset().string(), "--patch", "8"}).exit_code, 1);
  EXPECT_EQ(run({dataset().string(), "--set", "direct.max_rms=-1"}).exit_code, 1);
  EXPECT_EQ(run({dataset().string(), "--set", "nothing=1"}).exit_code, 1);
  const ProgramResult body = run({dataset().string(), "--trajectory-frame", "body"});
  EXPECT_EQ(body.exit_code, 1);
  EXPECT_THAT(body.err, HasSubstr("no T_BS"));
  const fs::path bare = copy();
  fs::remove(bare / "calibration.yaml");
  const ProgramResult result = run({bare.string()});
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("no calibration"));
  EXPECT_FALSE(fs::exists(out()));
}

TEST_F(ReplayProgram, EndsWithTwoOnInputThatCannotBeRead) {
  EXPECT_EQ(run({"/no/such/sequence"}).exit_code, 2);
  EXPECT_EQ(run({dataset().string(), "-c", "/no/such/calibration"}).exit_code, 2);
  EXPECT_EQ(run({dataset().string(), "--gt", "/no/such/truth"}).exit_code, 2);
  EXPECT_EQ(run({dataset().string(), "--config", "/no/such/config"}).exit_code, 2);
  EXPECT_EQ(run({dataset().string(), "--start", "1000"}).exit_code, 2);
  const ProgramResult wrong_size = run({dataset().string(), "-c", "freiburg1"});
  EXPECT_EQ(wrong_size.exit_code, 2);
  EXPECT_THAT(wrong_size.err, HasSubstr("is for 640x480 images, but those of"));
  const fs::path broken = copy();
  writeFile(broken / "calibration.yaml", "camera:\n  fx: wide\n");
  const ProgramResult calibration = run({broken.string()});
  EXPECT_EQ(calibration.exit_code, 2);
  EXPECT_THAT(calibration.err, HasSubstr("calibration.yaml:2: fx: 'wide' is not a number"));
  writeFile(broken / "rgb.txt", "2.0 rgb/1.png\n1.0 rgb/0.png\n");
  const ProgramResult order = run({broken.string()});
  EXPECT_EQ(order.exit_code, 2);
  EXPECT_THAT(order.err, HasSubstr("rgb.txt:2: timestamp 1.000000000 s lies before"));
}

TEST_F(ReplayProgram, EndsWithTwoWhenNoImageCanBeUsed) {
  folder_.writeImage("deep/a.png", CV_16UC1, 320, 240);
  folder_.write("deep/b.png", "");
  const ProgramResult result =
      run({(folder_.path() / "deep").string(), "-c", (dataset() / "calibration.yaml").string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("1 of 2 images do not have 8 bits per channel"));
  EXPECT_THAT(result.err, HasSubstr("1 of 2 images are empty files (first: b.png)"));
}

TEST_F(ReplayProgram, EndsWithThreeWhenThereIsNoGl) {
  // libEGL finds no vendor, as on a machine without any driver.
  const std::string command = "__EGL_VENDOR_LIBRARY_FILENAMES=/dev/null " +
                              std::string(GLIDE_REPLAY_PROGRAM) + " " + dataset().string() +
                              " --backend gles -o " + out().string();
  const ProgramResult result = runShell(command, folder_.path());
  EXPECT_EQ(result.exit_code, 3) << result.err;
  EXPECT_THAT(result.err, HasSubstr("--backend gles"));
}

TEST_F(ReplayProgram, EndsWithFourWhenItNeverInitialises) {
  const fs::path dark = copy();
  blank(dark, 0);
  const ProgramResult result = run({dark.string()});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.err, HasSubstr("never initialised: too few features"));
  EXPECT_TRUE(nlohmann::json::parse(output("stats.json"))["tracked_ratio"].is_null());
}

TEST_F(ReplayProgram, EndsWithFiveWhenTooLittleIsTracked) {
  const fs::path half = copy();
  blank(half, kRenderedFrames / 2);
  const ProgramResult result = run({half.string(), "--deterministic", "--require-tracked", "0.9"});
  EXPECT_EQ(result.exit_code, 5) << result.err;
  EXPECT_THAT(result.err, HasSubstr("is below the required 0.9000"));
  EXPECT_EQ(run({half.string(), "--deterministic"}).exit_code, 0);
}

TEST_F(ReplayProgram, KeepsWhatWasTrackedWhenItEndsInTheDark) {
  const fs::path half = copy();
  blank(half, kRenderedFrames / 2);
  const fs::path saved = folder_.path() / "half.glidemap";
  const ProgramResult result = run({half.string(), "--deterministic", "--map-out", saved.string()});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr("the map was given up when it was lost: none is saved"));
  EXPECT_FALSE(fs::exists(saved));
  const auto stats = nlohmann::json::parse(output("stats.json"));
  EXPECT_GT(stats["frames"]["tracked"], 3);
  EXPECT_EQ(stats["map"]["resets"], 1);
  const auto truth = readDataLines(out() / "trajectory.tum");
  EXPECT_EQ(truth->size(), stats["frames"]["tracked"]);
  EXPECT_GE(readDataLines(out() / "keyframes.tum")->size(), 2U);
  EXPECT_THAT(output("map.ply"), Not(HasSubstr("element vertex 0\n")));
}

TEST_F(ReplayProgram, LeavesTheTrackedPointsThatAreSetAlone) {
  const auto reported = [&](const std::string& more) {
    run({dataset().string(), "--max-frames", "2", "--no-report", more});
    return nlohmann::json::parse(output("stats.json"))["config"]["tracked_points"];
  };
  EXPECT_EQ(reported("--deterministic"), "indirect");
  EXPECT_EQ(reported("--set tracked_points=off"), "off");
}

TEST_F(ReplayProgram, WritesTheOtherFilesWhereOneCannotBeWritten) {
  for (const char* name : {"groundtruth.tum", "trajectory.tum"}) {
    fs::create_directories(out() / name);
  }
  const ProgramResult result =
      run({dataset().string(), "--deterministic", "--map-out", (out() / "no" / "x").string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("cannot create"));
  EXPECT_EQ(nlohmann::json::parse(output("stats.json"))["frames"]["in"], kRenderedFrames);
  EXPECT_THAT(output("keyframes.tum"), HasSubstr("\n"));
}

TEST_F(ReplayProgram, GoesOnPastATruncatedImageAndNamesIt) {
  const fs::path cut = copy();
  const fs::path file = cut / "rgb" / "15.png";
  fs::resize_file(file, fs::file_size(file) / 2);
  fs::remove(cut / "rgb" / "18.png");
  const ProgramResult result = run({cut.string(), "--deterministic"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.out, HasSubstr("1 of 24 images are truncated (first: rgb/15.png)"));
  EXPECT_THAT(output("log.txt"),
              HasSubstr("1 of 24 images listed in rgb.txt are missing (first: rgb/18.png)"));
  EXPECT_EQ(nlohmann::json::parse(output("stats.json"))["frames"]["in"], kRenderedFrames - 2);
}

TEST_F(ReplayProgram, CountsTheMissingImagesOfARealSequenceOnce) {
  const auto office = test::sharedData("tum_fr3_office_16");
  if (!office) GTEST_SKIP() << "../shared/data/tum_fr3_office_16 is not there";
  const ProgramResult result = run({"tum:" + office->string()});
  EXPECT_EQ(result.exit_code, 4);
  EXPECT_THAT(result.out,
              HasSubstr("2569 of 2585 images listed in rgb.txt are missing (first: rgb/13418479"));
  EXPECT_EQ(nlohmann::json::parse(output("stats.json"))["frames"]["in"], 16);
}

TEST_F(ReplayProgram, LocalizesInAMapThatItSaved) {
  const std::string map = (folder_.path() / "wall.glmap").string();
  ASSERT_EQ(run({dataset().string(), "--deterministic", "--map-out", map}).exit_code, 0);
  const std::string keyframes = output("keyframes.tum");
  EXPECT_EQ(nlohmann::json::parse(output("stats.json"))["memory"]["map_mb"],
            static_cast<double>(fs::file_size(map)) / 1024.0 / 1024.0);
  const ProgramResult result = run({dataset().string(),
                                    "--deterministic",
                                    "--map-in",
                                    map,
                                    "--localize-only",
                                    "--require-tracked",
                                    "0.8"});
  EXPECT_EQ(result.exit_code, 0) << result.err;
  EXPECT_EQ(output("keyframes.tum"), keyframes);  // the map is as it was
  const auto stats = nlohmann::json::parse(output("stats.json"));
  EXPECT_GT(stats["frames"]["tracked"], kRenderedFrames / 2);
  EXPECT_LT(stats["accuracy"]["ate_rmse_m"], 0.01);
  EXPECT_THAT(output("log.txt"), HasSubstr("loaded in"));
}

TEST_F(ReplayProgram, EndsWithTwoOnAMapThatItCannotUse) {
  const fs::path map = folder_.path() / "bad.glmap";
  EXPECT_EQ(run({dataset().string(), "--map-in", map.string()}).exit_code, 2);
  ASSERT_TRUE(writeFile(map, "GLiDEmap and then nothing of use").ok());
  const ProgramResult result = run({dataset().string(), "--map-in", map.string()});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr(map.string() + ": truncated"));
}

TEST_F(ReplayProgram, KeepsPaceWithTheTimestampsInRealtime) {
  const ProgramResult result = run({dataset().string(), "--pace", "realtime", "--max-frames", "5"});
  const auto stats = nlohmann::json::parse(output("stats.json"));
  EXPECT_EQ(stats["pace"], "realtime");
  EXPECT_EQ(stats["frames"]["in"].get<int>() + stats["frames"]["dropped"].get<int>(), 5);
  EXPECT_GE(stats["wall_s"], 4 * 0.0333);
  EXPECT_TRUE(result.exit_code == 0 || result.exit_code == 4) << result.err;
}

}  // namespace
}  // namespace glide::replay
