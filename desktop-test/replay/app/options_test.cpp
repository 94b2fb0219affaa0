#include "replay/app/options.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;

std::variant<Options, int> parse(std::vector<const char*> words) {
  words.insert(words.begin(), "glide-replay");
  return parseOptions(static_cast<int>(words.size()), words.data());
}

Options parsed(const std::vector<const char*>& words) {
  const auto result = parse(words);
  EXPECT_TRUE(std::holds_alternative<Options>(result));
  return std::holds_alternative<Options>(result) ? std::get<Options>(result) : Options{};
}

int exitCode(const std::vector<const char*>& words) {
  const auto result = parse(words);
  return std::holds_alternative<int>(result) ? std::get<int>(result) : -1;
}

TEST(Options, HaveTheDefaultsOfTheManual) {
  const Options options = parsed({"data"});
  EXPECT_EQ(options.source, "data");
  EXPECT_EQ(options.pace, Pace::lossless);
  EXPECT_EQ(options.trajectory_frame, TrajectoryFrame::camera);
  EXPECT_EQ(options.progress, Progress::automatic);
  EXPECT_EQ(options.selection.stride, 1);
  EXPECT_TRUE(options.settings.empty());
  EXPECT_EQ(options.input, InputKind::luma);
  EXPECT_FALSE(options.json);
}

TEST(Options, ReadHowTheSessionGetsTheImages) {
  EXPECT_EQ(parsed({"data", "--input", "texture"}).input, InputKind::texture);
  EXPECT_EQ(parsed({"data", "--input", "external"}).input, InputKind::external);
  EXPECT_EQ(exitCode({"data", "--input", "film"}), kUsage);
}

TEST(Options, TurnShortcutsIntoSettingsThatSetOverrides) {
  const Options options = parsed({"data",
                                  "--set",
                                  "direct.levels=3",
                                  "--patch",
                                  "7",
                                  "--backend",
                                  "cpu",
                                  "--deterministic",
                                  "--set",
                                  "direct.max_rms=9"});
  EXPECT_THAT(options.settings,
              ElementsAre("backend=cpu",
                          "direct.patch_size=7",
                          "execution=inline",
                          "direct.levels=3",
                          "direct.max_rms=9"));
}

TEST(Options, ReadSelectionAndOutputs) {
  const Options options = parsed({"data",
                                  "--start",
                                  "1.5",
                                  "--duration",
                                  "10",
                                  "--stride",
                                  "2",
                                  "--max-frames",
                                  "7",
                                  "--pace",
                                  "realtime",
                                  "--trajectory-frame",
                                  "body",
                                  "--progress",
                                  "none",
                                  "--json",
                                  "--require-tracked",
                                  "0.9",
                                  "-o",
                                  "there",
                                  "--gt",
                                  "gt.txt",
                                  "--fps",
                                  "15"});
  EXPECT_EQ(options.selection.start_s, 1.5);
  EXPECT_EQ(options.selection.duration_s, 10.0);
  EXPECT_EQ(options.selection.stride, 2);
  EXPECT_EQ(options.selection.max_frames, 7);
  EXPECT_EQ(options.pace, Pace::realtime);
  EXPECT_EQ(options.trajectory_frame, TrajectoryFrame::body);
  EXPECT_EQ(options.progress, Progress::none);
  EXPECT_TRUE(options.json);
  EXPECT_EQ(options.require_tracked, 0.9);
  EXPECT_EQ(options.output, "there");
  EXPECT_EQ(options.groundtruth, "gt.txt");
  EXPECT_EQ(options.fps, 15.0);
}

TEST(Options, NameMapsAndLocalizeOnlyInOne) {
  const Options options =
      parsed({"data", "--map-in", "a.glmap", "--map-out", "b.glmap", "--localize-only"});
  EXPECT_EQ(options.map_in, "a.glmap");
  EXPECT_EQ(options.map_out, "b.glmap");
  EXPECT_THAT(options.settings, ElementsAre("mode=localization_only"));
  testing::internal::CaptureStderr();
  EXPECT_EQ(exitCode({"data", "--localize-only"}), kUsage);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("--map-in"));
}

TEST(Options, TellAnAskedForReportFromTheDefault) {
  EXPECT_EQ(parsed({"sequence"}).report, std::nullopt);
  EXPECT_EQ(parsed({"sequence", "--report"}).report, true);
  EXPECT_EQ(parsed({"sequence", "--no-report"}).report, false);
}

TEST(Options, EndWithOneOnAMistakeAndZeroOnHelp) {
  testing::internal::CaptureStderr();
  EXPECT_EQ(exitCode({}), kUsage);
  EXPECT_EQ(exitCode({"data", "--stride", "0"}), kUsage);
  EXPECT_EQ(exitCode({"data", "--backend", "gpu"}), kUsage);
  EXPECT_EQ(exitCode({"data", "--pace", "fast"}), kUsage);
  EXPECT_EQ(exitCode({"data", "--require-tracked", "2"}), kUsage);
  EXPECT_EQ(exitCode({"data", "--no-such-option"}), kUsage);
  EXPECT_EQ(exitCode({"data", "more"}), kUsage);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("SOURCE"));
  testing::internal::CaptureStdout();
  EXPECT_EQ(exitCode({"--help"}), kOk);
  const std::string help = testing::internal::GetCapturedStdout();
  EXPECT_THAT(help, HasSubstr("Exit status"));
  EXPECT_THAT(help, HasSubstr("--render FILE|DIR"));
}

TEST(Options, NameVideosAndFoldersButNoOtherFilesToRenderTo) {
  EXPECT_EQ(parsed({"data", "--render", "out/x.mp4"}).render, "out/x.mp4");
  EXPECT_FALSE(parsed({"data"}).render);
  EXPECT_FALSE(parsed({"data"}).viewer);
  EXPECT_TRUE(parsed({"data", "--viewer", "--render", "frames"}).viewer);
  testing::internal::CaptureStderr();
  EXPECT_EQ(exitCode({"data", "--render", "x.gif"}), kUsage);
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("unknown extension .gif"));
}

}  // namespace
}  // namespace glide::replay
