#include "replay/cli/dataset_test.h"
#include "replay/cli/replay_process.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <filesystem>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;
using ::testing::Not;

constexpr const char* kCtrlC = "\x03";

/// A replay that a person watches on a terminal.
class TerminalHabits : public DatasetTest {
 protected:
  std::vector<std::string> arguments(const std::string& source,
                                     const std::vector<std::string>& more) const {
    std::vector<std::string> all{source, "-o", out().string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  nlohmann::json stats() const { return nlohmann::json::parse(output("stats.json")); }
};

std::ptrdiff_t linesOf(const std::string& text) {
  return std::count(text.begin(), text.end(), '\n');
}

/// What stood in the line of the bar, one entry per redraw.
std::vector<std::string> redraws(const std::string& screen) {
  std::vector<std::string> bars;
  for (std::size_t begin = screen.find("\r["); begin != std::string::npos;) {
    const std::size_t end = screen.find("\x1b[K", begin);
    if (end == std::string::npos) break;
    bars.push_back(screen.substr(begin + 1, end - begin - 1));
    begin = screen.find("\r[", end);
  }
  return bars;
}

TEST_F(TerminalHabits, DrawsABarInColorThatFitsTheTerminal) {
  ReplayProcess replay(arguments(dataset().string(), {}), {});
  EXPECT_EQ(replay.wait(), 0) << replay.screen();
  EXPECT_THAT(replay.screen(), HasSubstr("\x1b[38;5;208mdirect\x1b[0m"));
  EXPECT_THAT(replay.screen(), HasSubstr("\x1b[1mglide_cli_dataset\x1b[0m"));  // the table
  const std::vector<std::string> bars = redraws(replay.screen());
  ASSERT_FALSE(bars.empty()) << replay.screen();
  EXPECT_THAT(bars.back(), HasSubstr("] 24/24"));
  EXPECT_THAT(bars.back(), HasSubstr(" landmarks"));
}

TEST_F(TerminalHabits, DrawsABarWithoutColorForWhoWantsNone) {
  ReplayProcess replay(arguments(dataset().string(), {}), {{"NO_COLOR", "1"}});
  EXPECT_EQ(replay.wait(), 0) << replay.screen();
  const std::vector<std::string> bars = redraws(replay.screen());
  ASSERT_FALSE(bars.empty()) << replay.screen();
  for (const std::string& bar : bars) {
    EXPECT_LT(bar.size(), 80U) << bar;
    EXPECT_THAT(bar, Not(HasSubstr("\x1b")));
  }
}

TEST_F(TerminalHabits, WritesLinesOnADumbTerminalAndWhenAsked) {
  for (const bool is_dumb : {true, false}) {
    ReplayProcess replay(arguments(dataset().string(), {"--progress", is_dumb ? "auto" : "plain"}),
                         {{"TERM", is_dumb ? "dumb" : "xterm"}, {"NO_COLOR", "1"}});
    EXPECT_EQ(replay.wait(), 0) << replay.screen();
    EXPECT_THAT(replay.screen(), Not(HasSubstr("\x1b")));
    EXPECT_THAT(replay.screen(), HasSubstr("\n24/24 "));
  }
}

TEST_F(TerminalHabits, SaysNothingOnTheWayWhenAsked) {
  ReplayProcess replay(arguments(dataset().string(), {"--progress", "none"}), {});
  EXPECT_EQ(replay.wait(), 0) << replay.screen();
  EXPECT_THAT(replay.screen(), Not(HasSubstr("24/24")));
}

TEST_F(TerminalHabits, WritesWhatWasTrackedWhenCtrlCIsTyped) {
  constexpr int kFrames = 1000;  // ten times what the first line of progress takes
  const std::string map = (folder_.path() / "map.glmap").string();
  ReplayProcess replay(
      arguments(walkFor(steadyTimes(kFrames)), {"--progress", "plain", "--map-out", map}), {});
  ASSERT_TRUE(replay.writes("100/1000")) << replay.screen();
  replay.type(kCtrlC);
  EXPECT_EQ(replay.wait(), 130) << replay.screen();
  EXPECT_THAT(replay.screen(), HasSubstr("of 1000 frames: writing what was tracked so far"));
  const nlohmann::json result = stats();
  EXPECT_EQ(result["interrupted"], true);
  const int frames = result["frames"]["in"];
  EXPECT_GE(frames, 100);
  EXPECT_LT(frames, kFrames);
  EXPECT_EQ(linesOf(output("frames.csv")), frames + 1);
  EXPECT_EQ(linesOf(output("trajectory.tum")), 1 + result["frames"]["tracked"].get<int>());
  EXPECT_EQ(linesOf(output("trajectory_live.tum")), 1 + result["frames"]["tracked"].get<int>());
  EXPECT_EQ(linesOf(output("keyframes.tum")), 1 + result["map"]["keyframes"].get<int>());
  EXPECT_THAT(output("log.txt"), HasSubstr("interrupted after"));
  EXPECT_TRUE(fs::exists(out() / "map.ply"));
  EXPECT_TRUE(fs::exists(map));
}

TEST_F(TerminalHabits, StopsWhileItWaitsForAFrameThatIsNotDue) {
  constexpr double kLater = 100'000.0;  // s
  ReplayProcess replay(arguments(walkFor({1.0, 1.1, kLater, kLater + 1.0}),
                                 {"--progress", "plain", "--pace", "realtime"}),
                       {});
  ASSERT_TRUE(replay.writes("2/4")) << replay.screen();
  replay.type(kCtrlC);
  EXPECT_EQ(replay.wait(), 130) << replay.screen();
  EXPECT_EQ(stats()["frames"]["in"], 2);
}

}  // namespace
}  // namespace glide::replay
