#include "replay/cli/dataset_test.h"
#include "replay/cli/replay_program.h"
#include "replay/outputs/report_template.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <filesystem>
#include <string>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

/// report.html as --report and --no-report have it.
class Report : public DatasetTest {
 protected:
  ProgramResult run(std::vector<std::string> more) const {
    more.insert(more.begin(), {dataset().string(), "-o", out().string(), "--progress", "none"});
    return runReplay(more, folder_.path());
  }
};

nlohmann::json dataOf(const std::string& html) {
  const std::string begin = "<script id=\"run\" type=\"application/json\">";
  const std::size_t from = html.find(begin) + begin.size();
  return nlohmann::json::parse(html.substr(from, html.find("</script>", from) - from));
}

TEST_F(Report, HoldsWhatTheOtherFilesTell) {
  if (reportTemplate().empty()) GTEST_SKIP() << "built without npm: there is no page";
  const ProgramResult result = run({"--deterministic"});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const nlohmann::json data = dataOf(output("report.html"));
  EXPECT_EQ(data["name"], "glide_cli_dataset");
  EXPECT_EQ(data["trajectory"], output("trajectory.tum"));
  EXPECT_EQ(data["frames"]["count"], kRenderedFrames);
  EXPECT_FALSE(data["truth"].is_null());
  EXPECT_GT(data["pictures"]["jpeg"].size(), 10U);
  const auto stats = nlohmann::json::parse(output("stats.json"));
  EXPECT_EQ(data["stats"]["accuracy"], stats["accuracy"]);
  EXPECT_EQ(data["stats"]["time_ms"], stats["time_ms"]);
}

TEST_F(Report, IsLeftOutWhenNotWanted) {
  EXPECT_EQ(run({"--no-report", "--max-frames", "3"}).exit_code, 0);
  EXPECT_TRUE(fs::exists(out() / "stats.json"));
  EXPECT_FALSE(fs::exists(out() / "report.html"));
}

TEST_F(Report, IsMissedOnlyByThoseWhoAskForIt) {
  if (!reportTemplate().empty()) GTEST_SKIP() << "this program has the page";
  const ProgramResult asked = run({"--report", "--max-frames", "3"});
  EXPECT_EQ(asked.exit_code, 1);
  EXPECT_THAT(asked.err, HasSubstr("--report: this program was built without the page"));
  EXPECT_EQ(run({"--max-frames", "3"}).exit_code, 0);
  EXPECT_THAT(output("log.txt"), HasSubstr("no report.html"));
}

}  // namespace
}  // namespace glide::replay
