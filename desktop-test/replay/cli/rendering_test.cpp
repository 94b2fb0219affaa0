#include "replay/cli/dataset_test.h"
#include "replay/cli/replay_process.h"
#include "replay/cli/replay_program.h"
#include "replay/common/text.h"

#include "glide/render_types.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/videoio.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <string>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
using ::testing::HasSubstr;

constexpr int kWidth = 1280, kHeight = 720;

/// What --render and --viewer do, as a user sees it.
class Rendering : public DatasetTest {
 protected:
  std::vector<std::string> arguments(const std::string& name,
                                     const std::vector<std::string>& more) const {
    std::vector<std::string> all{dataset().string(), "-o", (folder_.path() / name).string()};
    all.insert(all.end(), more.begin(), more.end());
    return all;
  }
  ProgramResult run(const std::vector<std::string>& more) const {
    std::vector<std::string> all = arguments("out", more);
    all.insert(all.end(), {"--progress", "none"});
    return runReplay(all, folder_.path());
  }
  std::string place(const std::string& name) const { return (folder_.path() / name).string(); }
};

/// How many pixels from column `first` on have about this colour.
int countColor(const cv::Mat& bgr, int first, const Color& color) {
  constexpr double kTolerance = 40.0;  // grey levels: lines are smoothed
  const cv::Vec3d wanted(255.0 * color[2], 255.0 * color[1], 255.0 * color[0]);
  int count = 0;
  for (int y = 0; y < bgr.rows; ++y) {
    for (int x = first; x < bgr.cols; ++x) {
      count += cv::norm(cv::Vec3d(bgr.at<cv::Vec3b>(y, x)) - wanted) < kTolerance ? 1 : 0;
    }
  }
  return count;
}

/// The map's part of the picture, without the timeline below.
cv::Mat sceneOf(const cv::Mat& picture) { return picture.rowRange(0, kHeight - 30); }

TEST_F(Rendering, DrawsAPictureOfEachFrameWithFrustaInBothColours) {
  const ProgramResult result = run({"--deterministic", "--render", place("frames")});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  EXPECT_THAT(result.err, HasSubstr(place("frames") + ": 24 frames"));
  int files = 0;
  for (const auto& entry : fs::directory_iterator(place("frames"))) {
    if (entry.path().extension() != ".png") continue;
    const cv::Mat picture = cv::imread(entry.path().string());
    EXPECT_EQ(picture.size(), cv::Size(kWidth, kHeight)) << entry.path();
    ++files;
  }
  EXPECT_EQ(files, kRenderedFrames);
  const cv::Mat first = cv::imread(place("frames/000000.png"));
  const cv::Mat last = cv::imread(place("frames/000023.png"));
  for (const Color& color : {kDirectColor, kIndirectColor}) {
    EXPECT_EQ(countColor(sceneOf(first), kWidth / 2, color), 0);  // there was no map yet
    EXPECT_GT(countColor(sceneOf(last), kWidth / 2, color), 50);
  }
}

TEST_F(Rendering, WritesAVideoThatPlaysInRealTime) {
  const std::string file = place("new/replay.mp4");
  const ProgramResult result = run({"--render", file});
  ASSERT_EQ(result.exit_code, 0) << result.err;
  cv::VideoCapture video(file, cv::CAP_FFMPEG);
  ASSERT_TRUE(video.isOpened());
  EXPECT_NEAR(video.get(cv::CAP_PROP_FPS), 30.0, 0.1);
  int frames = 0;
  for (cv::Mat picture; video.read(picture); ++frames) {
    EXPECT_EQ(picture.size(), cv::Size(kWidth, kHeight));
  }
  EXPECT_EQ(frames, kRenderedFrames);
  EXPECT_EQ(std::distance(fs::directory_iterator(place("new")), fs::directory_iterator()), 1);
}

TEST_F(Rendering, ChangesNothingOfTheResults) {
  const auto outputs = [&](const std::vector<std::string>& more) {
    std::vector<std::string> all{"--deterministic"};
    all.insert(all.end(), more.begin(), more.end());
    const ProgramResult result = run(all);
    EXPECT_EQ(result.exit_code, 0) << result.err;
    std::string joined;
    for (const std::string name :
         {"trajectory.tum", "trajectory_live.tum", "keyframes.tum", "map.ply", "map.glb"}) {
      const auto text = readFile(place("out/" + name));
      EXPECT_TRUE(text.ok());
      joined += text ? *text : "";
    }
    return joined + withoutTimes(*readFile(place("out/frames.csv")));
  };
  EXPECT_EQ(outputs({}), outputs({"--render", place("frames")}));
}

TEST_F(Rendering, LeavesAVideoOfWhatWasSeenWhenItIsInterrupted) {
  constexpr int kLong = 600;  // frames: far more than are drawn before a key is pressed
  const std::string file = place("cut.mp4");
  ReplayProcess replay({walkFor(steadyTimes(kLong)), "-o", place("out"), "--render", file}, {});
  ASSERT_TRUE(replay.writes("tracking")) << replay.screen();
  replay.type("\x03");
  EXPECT_EQ(replay.wait(), 130) << replay.screen();
  const cv::VideoCapture video(file, cv::CAP_FFMPEG);
  EXPECT_GE(video.get(cv::CAP_PROP_FRAME_COUNT), 2);
  EXPECT_LT(video.get(cv::CAP_PROP_FRAME_COUNT), kLong);
}

TEST_F(Rendering, LosesNothingButThePicturesWhereTheyCannotBeWritten) {
  fs::create_directories(place("frames/000005.png.part"));
  const ProgramResult result = run({"--deterministic", "--render", place("frames")});
  EXPECT_EQ(result.exit_code, 2);
  EXPECT_THAT(result.err, HasSubstr("cannot be written: the replay goes on without it"));
  EXPECT_TRUE(fs::exists(place("frames/000004.png")));
  EXPECT_FALSE(fs::exists(place("frames/000006.png")));
  EXPECT_EQ(readDataLines(place("out/frames.csv"))->size(), kRenderedFrames + 1);
  for (const char* name : {"trajectory.tum", "map.glb", "stats.json", "log.txt"}) {
    EXPECT_GT(fs::file_size(place(std::string("out/") + name)), 0U) << name;
  }
}

TEST_F(Rendering, LeavesItsSourceAlone) {
  const fs::path images = folder_.path() / "images";
  fs::create_directories(images);
  fs::copy(dataset() / "rgb" / "0.png", images / "000000.png");
  const ProgramResult result = runReplay({images.string(),
                                          "-c",
                                          (dataset() / "calibration.yaml").string(),
                                          "-o",
                                          place("out"),
                                          "--render",
                                          images.string()},
                                         folder_.path());
  EXPECT_EQ(result.exit_code, 1);
  EXPECT_THAT(result.err, HasSubstr("--render: " + images.string()));
  EXPECT_TRUE(fs::exists(images / "000000.png"));
}

TEST_F(Rendering, EndsWithOneWhereItCannotWrite) {
  const ProgramResult gif = run({"--render", place("x.gif")});
  EXPECT_EQ(gif.exit_code, 1);
  EXPECT_THAT(gif.err, HasSubstr("unknown extension .gif"));
  ASSERT_TRUE(writeFile(place("file"), "no folder").ok());
  const ProgramResult blocked = run({"--render", place("file/x.mp4")});
  EXPECT_EQ(blocked.exit_code, 1);
  EXPECT_THAT(blocked.err, HasSubstr("--render: " + place("file")));
}

TEST_F(Rendering, EndsWithThreeAndNamesTheOptionWithoutAContextOrADisplay) {
  const auto withEnvironment = [&](const std::string& environment, const std::string& options) {
    return runShell("env " + environment + " " + GLIDE_REPLAY_PROGRAM + " " + dataset().string() +
                        " -o " + place("out") + " " + options,
                    folder_.path());
  };
  const ProgramResult render =
      withEnvironment("GLIDE_EGL_PLATFORM=none", "--render " + place("x.mp4"));
  EXPECT_EQ(render.exit_code, 3);
  EXPECT_THAT(render.err, HasSubstr("--render: no OpenGL ES 3.1 context"));
  EXPECT_FALSE(fs::exists(place("x.mp4")));
  const ProgramResult viewer = withEnvironment("-u DISPLAY -u WAYLAND_DISPLAY", "--viewer");
  EXPECT_EQ(viewer.exit_code, 3);
  EXPECT_THAT(viewer.err, HasSubstr("--viewer: "));
}

}  // namespace
}  // namespace glide::replay
