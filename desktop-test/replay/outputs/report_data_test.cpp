#include "replay/outputs/report_data.h"

#include "replay/outputs/report_html.h"
#include "replay/outputs/report_template.h"
#include "replay/outputs/report_watcher.h"
#include "replay/outputs/run_fixture.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <random>
#include <string>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;
using Json = nlohmann::ordered_json;

/// A page of the size that the real one has, for programs built without it.
constexpr std::size_t kPageBytes = 700'000;

Json dataOf(const RunFixture& fixture, const std::optional<Trajectory>& truth = std::nullopt) {
  const RunTrajectories trajectories = buildTrajectories(fixture.run);
  const FrameCounts counts = countFrames(fixture.run, trajectories);
  const PointColors colors;
  return reportData({fixture.run, trajectories, counts, std::nullopt, truth, {}, colors}, {});
}

RunFixture shortRun() {
  RunFixture fixture;
  fixture.addKeyframe(0, 0.0, false);
  fixture.addKeyframe(100'000'000, 1.0, true);
  fixture.addKeyframe(200'000'000, 2.0, false);
  fixture.addInitializing();
  fixture.addTracked(TrackerKind::indirect, 0);
  fixture.addTracked(TrackerKind::direct, 200'000'000);
  fixture.addLost();
  return fixture;
}

TEST(ReportData, HasAColumnPerMeasurementAndOneRowPerFrame) {
  const Json frames = dataOf(shortRun())["frames"];
  EXPECT_EQ(frames["count"], 4);
  EXPECT_EQ(frames["state"], "AAEBAg==");  // initializing, tracking, tracking, lost
  EXPECT_EQ(frames["tracker"], "AAIBAA==");
  EXPECT_EQ(frames["placed"], "AAEBAA==");
  EXPECT_EQ(frames["names"]["tracker"][2], "indirect");
  EXPECT_EQ(frames["update_ms"].get<std::string>().size(), 24U);  // four floats in base64
}

TEST(ReportData, LeavesOutRetiredKeyframesAndFindsTheFramesOfTheOthers) {
  const Json keyframes = dataOf(shortRun())["keyframes"];
  EXPECT_EQ(keyframes["count"], 2);
  EXPECT_EQ(keyframes["frame"], "AAAAAAIAAAA=");  // 0 and 2
}

TEST(ReportData, MarksKeyframesOfALoadedMap) {
  RunFixture fixture = shortRun();
  fixture.addKeyframe(7, 0.0, false);  // taken at a time that is no frame's
  EXPECT_EQ(dataOf(fixture)["keyframes"]["frame"], "AAAAAAIAAAD/////");
}

TEST(ReportData, DrawsLoopsBetweenKeyframesThatAreThereOnly) {
  RunFixture fixture = shortRun();
  fixture.map().loops = {{200'000'000, 0}, {200'000'000, 999}};
  EXPECT_EQ(dataOf(fixture)["loops"], "AAAAQAAAAAAAAAAAAAAAAAAAAAAAAAAA");  // 2 0 0, 0 0 0
}

TEST(ReportData, SaysWhyThereIsNoMap) {
  RunFixture fixture;
  fixture.addInitializing();
  fixture.run.frames.back().result.initialization.status = InitializationStatus::pure_rotation;
  const Json data = dataOf(fixture);
  EXPECT_THAT(data["hint"].get<std::string>(), HasSubstr("turned but did not move"));
  EXPECT_TRUE(data["truth"].is_null());
}

TEST(ReportData, TakesARunWithoutAFrame) {
  const Json data = dataOf(RunFixture());
  EXPECT_EQ(data["frames"]["count"], 0);
  EXPECT_EQ(data["keyframes"]["count"], 0);
  EXPECT_EQ(data["map"]["landmarks"], 0);
}

TEST(ReportData, ThinsALargeMapToItsBestLandmarks) {
  RunFixture fixture = shortRun();
  for (std::size_t i = 0; i < 3 * kMaxReportLandmarks; ++i) {
    fixture.map().landmarks.push_back({i, {1, 2, 3}, i % 3 == 0 ? 9 : 2});
  }
  const Json map = dataOf(fixture)["map"];
  EXPECT_EQ(map["landmarks"], 3 * kMaxReportLandmarks);
  EXPECT_EQ(map["shown"], kMaxReportLandmarks);
}

/// Noise, which no JPEG makes small.
std::vector<Thumbnail> noisyPictures(int frames) {
  std::mt19937 random(5);
  ThumbnailStrip strip(kPictureBudget);
  SourceFrame frame;
  frame.image.resize(752, 480);
  for (int i = 0; i < frames; ++i) {
    if (!strip.wantsNext(i % 10 == 0)) continue;
    for (int y = 0; y < 480; ++y) {
      for (int x = 0; x < 752; ++x)
        frame.image.at(x, y) = static_cast<std::uint8_t>(random() >> 24);
    }
    strip.add(thumbnailJpeg(frame));
  }
  return strip.pictures();
}

TEST(ReportData, KeepsTheReportOfSixHundredFramesUnderTwoMegabytes) {
  RunFixture fixture;
  for (std::uint64_t id = 0; id < 100; ++id) fixture.addKeyframe(id, 0.1, false);
  fixture.addInitializing();
  Trajectory truth;
  for (int i = 0; i < 600; ++i) {
    fixture.addTracked(i % 3 == 0 ? TrackerKind::indirect : TrackerKind::direct, 50);
    truth.push_back({fixture.run.frames.back().result.t_ns,
                     {Eigen::Quaterniond::Identity(), Vec3d(i, i * i, 1)}});
    fixture.run.frames.back().result.T_ref_cam.t_xyz = {-1234.5 - i, 1.0 * i * i, 12.25};
  }
  for (std::size_t i = 0; i < 100'000; ++i) fixture.map().landmarks.push_back({i, {1, 2, 3}, 4});
  const RunTrajectories trajectories = buildTrajectories(fixture.run);
  const FrameCounts counts = countFrames(fixture.run, trajectories);
  const PointColors colors;
  const std::optional<Trajectory> known_truth = truth;
  const Json data =
      reportData({fixture.run, trajectories, counts, std::nullopt, known_truth, {}, colors},
                 noisyPictures(60));
  ASSERT_FALSE(data["truth"].is_null());
  std::string page(reportTemplate());
  if (page.empty()) page = std::string(kPageBytes, ' ') + std::string(kReportDataMark);
  EXPECT_LT(page.size(), kPageBytes + 100);
  EXPECT_LT(reportHtml(page, data).size(), 2'000'000U);
}

}  // namespace
}  // namespace glide::replay
