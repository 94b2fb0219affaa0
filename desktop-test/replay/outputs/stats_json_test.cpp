#include "replay/outputs/stats_json.h"

#include "replay/outputs/frames_csv.h"
#include "replay/outputs/run_fixture.h"
#include "replay/outputs/summary.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

RunFixture shortRun() {
  RunFixture fixture;
  fixture.addKeyframe(1, 0.0, false);
  fixture.addInitializing();
  fixture.addTracked(TrackerKind::indirect, 1);
  fixture.addTracked(TrackerKind::direct, 1);
  return fixture;
}

Json statsOf(const RunFixture& fixture, const std::optional<Accuracy>& accuracy) {
  return statsJson(fixture.run, countFrames(fixture.run, buildTrajectories(fixture.run)), accuracy);
}

/// Every key of schema 1 (design/CLI.md) as a JSON pointer.
const std::vector<std::string> kSchemaKeys = {"/schema",
                                              "/version",
                                              "/source/kind",
                                              "/source/path",
                                              "/source/frames",
                                              "/source/width",
                                              "/source/height",
                                              "/config/direct/patch_size",
                                              "/config/camera/coefficients",
                                              "/config/backend",
                                              "/frames/in",
                                              "/frames/tracked",
                                              "/frames/direct",
                                              "/frames/indirect",
                                              "/frames/lost",
                                              "/frames/initializing",
                                              "/frames/dropped",
                                              "/tracked_ratio",
                                              "/direct_share",
                                              "/first_pose_index",
                                              "/time_ms/update",
                                              "/time_ms/direct",
                                              "/time_ms/indirect",
                                              "/time_ms/stages/pyramid",
                                              "/time_ms/stages/precompute",
                                              "/time_ms/stages/align",
                                              "/time_ms/stages/features",
                                              "/time_ms/stages/match",
                                              "/time_ms/stages/pose",
                                              "/gpu/backend",
                                              "/gpu/vendor",
                                              "/gpu/renderer",
                                              "/gpu/version",
                                              "/gpu/pre_ms",
                                              "/gpu/trk_ms",
                                              "/gpu/timer",
                                              "/map/keyframes",
                                              "/map/landmarks",
                                              "/map/loops_closed",
                                              "/map/relocalisations",
                                              "/map/resets",
                                              "/accuracy",
                                              "/pace",
                                              "/deterministic",
                                              "/interrupted",
                                              "/memory/peak_rss_mb",
                                              "/memory/map_mb",
                                              "/startup_ms",
                                              "/wall_s"};

TEST(StatsJson, AlwaysHasAllKeysOfTheSchema) {
  for (const RunFixture& fixture : {RunFixture(), shortRun()}) {
    const Json stats = statsOf(fixture, std::nullopt);
    for (const std::string& key : kSchemaKeys) {
      EXPECT_TRUE(stats.contains(Json::json_pointer(key))) << key;
    }
    EXPECT_EQ(stats["schema"], 1);
  }
}

TEST(StatsJson, IsNullWhereNothingApplies) {
  const Json stats = statsOf(RunFixture(), std::nullopt);
  for (const char* key : {"tracked_ratio", "direct_share", "first_pose_index", "accuracy"}) {
    EXPECT_TRUE(stats[key].is_null()) << key;
  }
  EXPECT_TRUE(stats["time_ms"]["direct"].is_null());
  EXPECT_TRUE(stats["gpu"]["renderer"].is_null());
  EXPECT_TRUE(stats["memory"]["map_mb"].is_null());
}

TEST(StatsJson, TellsHowLargeTheMapIs) {
  RunFixture fixture = shortRun();
  fixture.run.map_file_bytes = 3 * 512 * 1024;
  EXPECT_EQ(statsOf(fixture, std::nullopt)["memory"]["map_mb"], 1.5);
}

TEST(StatsJson, TellsWhatTheMapFoundOutAboutTheLens) {
  RunFixture fixture = shortRun();
  EXPECT_TRUE(statsOf(fixture, std::nullopt)["map"]["corrected_k1"].is_null());
  fixture.map().corrected_camera = fixture.run.config.camera;
  fixture.map().corrected_camera->coefficients = {0.0175, 0.0, 0.0, 0.0, 0.0};
  EXPECT_EQ(statsOf(fixture, std::nullopt)["map"]["corrected_k1"], 0.0175);
  const FrameCounts counts = countFrames(fixture.run, buildTrajectories(fixture.run));
  EXPECT_THAT(summaryText({fixture.run, counts, std::nullopt, "out", false}),
              HasSubstr("k1 corrected from 0.0000 to 0.0175"));
}

TEST(StatsJson, HasEveryConfigFieldUnderItsName) {
  const Json config = configJson(Config{});
  EXPECT_EQ(config["direct"]["patch_size"], 11);
  EXPECT_EQ(config["direct"]["photometric"], "gain_bias");
  EXPECT_EQ(config["execution"], "threaded");
  EXPECT_EQ(config["mapping"]["queue_capacity"], 3);
  EXPECT_TRUE(config["camera"]["coefficients"].is_array());
}

TEST(StatsJson, TellsAccuracyWithNullsForWhatCouldNotBeAligned) {
  Accuracy accuracy;
  accuracy.truth_file = "gt.txt";
  accuracy.matched = 2;
  const Json few = statsOf(shortRun(), accuracy)["accuracy"];
  EXPECT_EQ(few["matched"], 2);
  for (const char* key : {"ate_rmse_m",
                          "ate_max_m",
                          "ate_live_rmse_m",
                          "ate_keyframes_rmse_m",
                          "scale",
                          "rpe_trans_m",
                          "rpe_rot_deg"}) {
    ASSERT_TRUE(few.contains(key)) << key;
    EXPECT_TRUE(few[key].is_null()) << key;
  }
  accuracy.final_error = AbsoluteError{0.005, 0.01, 1.5};
  accuracy.relative_error = RelativeError{0.002, 0.1, 9};
  const Json full = statsOf(shortRun(), accuracy)["accuracy"];
  EXPECT_EQ(full["ate_rmse_m"], 0.005);
  EXPECT_EQ(full["scale"], 1.5);
  EXPECT_EQ(full["rpe_rot_deg"], 0.1);
}

TEST(StatsJson, SaysWhereAndHowItRan) {
  RunFixture fixture = shortRun();
  fixture.run.backend = {Backend::gles, "Mesa", "llvmpipe", "OpenGL ES 3.2", StageTimer::sync};
  fixture.run.config.execution = Execution::inline_;
  fixture.run.pace = Pace::realtime;
  const Json stats = statsOf(fixture, std::nullopt);
  EXPECT_EQ(stats["gpu"]["backend"], "gles");
  EXPECT_EQ(stats["gpu"]["renderer"], "llvmpipe");
  EXPECT_EQ(stats["gpu"]["timer"], "sync");
  EXPECT_EQ(stats["deterministic"], true);
  EXPECT_EQ(stats["interrupted"], false);
  EXPECT_EQ(stats["pace"], "realtime");
}

TEST(FramesCsv, HasTheColumnsOfTheContractAndALinePerFrame) {
  const std::string text = framesCsv(shortRun().run);
  EXPECT_THAT(text,
              testing::StartsWith("index,t_ns,state,tracker,switch_reason,update_ms,mapping_ms,"
                                  "pyramid_ms,precompute_ms,align_ms,features_ms,match_ms,pose_ms,"
                                  "visible,inliers,rms,keyframe,map_revision\n"));
  EXPECT_EQ(std::count(text.begin(), text.end(), '\n'), 4);
  EXPECT_THAT(text, HasSubstr("\n2,200000000,tracking,direct,none,3.000,"));
  const std::string last = text.substr(text.rfind('\n', text.size() - 2));
  EXPECT_EQ(std::count(last.begin(), last.end(), ','), 17);
}

TEST(Summary, TellsWhatCountsWithoutPromisingMore) {
  const RunFixture fixture = shortRun();
  const FrameCounts counts = countFrames(fixture.run, buildTrajectories(fixture.run));
  std::optional<Accuracy> accuracy = Accuracy{};
  accuracy->final_error = AbsoluteError{0.00451, 0.0124, 1.0};
  const std::string text = summaryText({fixture.run, counts, accuracy, "out/desk", false});
  for (const char* part : {"desk  640x480",
                           "3 in: 2 tracked",
                           "100.0 %",
                           "at frame 1",
                           "direct share   50.0 %",
                           "final 0.0045",
                           "live -",
                           "1 keyframes",
                           "out/desk"}) {
    EXPECT_THAT(text, HasSubstr(part));
  }
}

TEST(Summary, PaintsTheTrackersAndTheLoss) {
  RunFixture fixture = shortRun();
  fixture.addLost();
  const FrameCounts counts = countFrames(fixture.run, buildTrajectories(fixture.run));
  const std::string text = summaryText({fixture.run, counts, std::nullopt, "out", true});
  EXPECT_THAT(text, HasSubstr("\x1b[38;5;208m1 direct\x1b[0m"));
  EXPECT_THAT(text, HasSubstr("\x1b[38;5;33m1 indirect\x1b[0m"));
  EXPECT_THAT(text, HasSubstr("\x1b[1;31m1 lost\x1b[0m"));
}

TEST(Summary, SaysWhyThereIsNoMap) {
  RunFixture fixture;
  fixture.addInitializing();
  fixture.run.frames[0].result.initialization.status = InitializationStatus::too_little_motion;
  fixture.run.skips = {{"images are empty files", 2, "a.png"}};
  const FrameCounts counts = countFrames(fixture.run, buildTrajectories(fixture.run));
  const std::string text = summaryText({fixture.run, counts, std::nullopt, "out", false});
  EXPECT_THAT(text, HasSubstr("never initialised: too little motion"));
  EXPECT_THAT(text, HasSubstr("2 of 6 images are empty files (first: a.png)"));
}

}  // namespace
}  // namespace glide::replay
