// Drives libglide_vit.so as a runtime does: dlopen, all symbols, images and samples in, poses out,
// dlclose.
#include "unit/session/sequence_fixture.h"
#include "vit/vit_abi.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <dlfcn.h>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

namespace glide::test {
namespace {

constexpr int kFrames = 60;
constexpr double kStep_m = 0.01;
constexpr std::int64_t kFrame_ns = 33'333'333;
using Clock = std::chrono::steady_clock;

/// The loaded library.
class Vit {
 public:
  Vit() : handle_(dlopen(std::getenv("GLIDE_VIT_LIBRARY"), RTLD_NOW | RTLD_LOCAL)) {}
  ~Vit() {
    if (handle_ != nullptr) dlclose(handle_);
  }
  Vit(const Vit&) = delete;
  Vit& operator=(const Vit&) = delete;

  bool isLoaded() const { return handle_ != nullptr; }
  bool has(const char* symbol) const { return dlsym(handle_, symbol) != nullptr; }
  template <class Function>
  Function* get(Function*, const char* symbol) const {
    return reinterpret_cast<Function*>(dlsym(handle_, symbol));
  }

 private:
  void* handle_;
};

// The function of this name in the library; the declaration gives its type.
#define VIT(name) vit_.get(static_cast<decltype(&::name)>(nullptr), #name)

class VitTest : public ::testing::Test {
 protected:
  void SetUp() override {
    ASSERT_TRUE(vit_.isLoaded()) << dlerror();
    settings_ = std::filesystem::path(testing::TempDir()) / "glide_vit_test.cfg";
    std::ofstream(settings_) << "# of vit_test\ninitialization.min_matches=60\nexecution=inline\n";
    const std::string path = settings_.string();
    const vit_config config{path.c_str(), 1, 0, false};
    ASSERT_EQ(VIT(vit_tracker_create)(&config, &tracker_), VIT_SUCCESS);
  }
  void TearDown() override {
    if (tracker_ != nullptr) VIT(vit_tracker_destroy)(tracker_);
    std::filesystem::remove(settings_);
  }

  vit_camera_calibration calibration() const {
    const CameraIntrinsics camera = sequence_.config().camera;
    vit_camera_calibration calibration{};
    calibration.width = camera.width;
    calibration.height = camera.height;
    calibration.fx = camera.fx;
    calibration.fy = camera.fy;
    calibration.cx = camera.cx;
    calibration.cy = camera.cy;
    for (int i = 0; i < 4; ++i) calibration.transform[5 * i] = 1.0;
    return calibration;
  }
  vit_result push(const ImageU8& image, std::int64_t t_ns) {
    std::vector<std::uint8_t> pixels;
    for (int y = 0; y < image.height(); ++y)
      pixels.insert(pixels.end(), image.row(y), image.row(y) + image.width());
    vit_img_sample sample{};
    sample.timestamp = t_ns;
    sample.data = pixels.data();  // gone when this returns, as a runtime's is
    sample.width = sample.stride = static_cast<std::uint32_t>(image.width());
    sample.height = static_cast<std::uint32_t>(image.height());
    sample.size = static_cast<std::uint32_t>(pixels.size());
    sample.format = VIT_IMAGE_FORMAT_L8;
    return VIT(vit_tracker_push_img_sample)(tracker_, &sample);
  }
  vit_pose* pop() {
    vit_pose* pose = nullptr;
    EXPECT_EQ(VIT(vit_tracker_pop_pose)(tracker_, &pose), VIT_SUCCESS);
    return pose;
  }
  /// Pushes the walk, each frame when the one before is through; the poses.
  std::vector<vit_pose*> walk() {
    std::vector<vit_pose*> poses;
    for (int i = 0; i < kFrames; ++i) {
      const Clock::time_point begin = Clock::now();
      const ImageU8 image = sequence_.imageAt(i * kStep_m);
      const Clock::duration rendering = Clock::now() - begin;
      EXPECT_EQ(push(image, (i + 1) * kFrame_ns), VIT_SUCCESS);
      // Frames before the start have no pose that tells when they are through. Tracking takes about
      // as long as rendering, whatever the machine and the sanitizer.
      if (vit_pose* pose = popWithin(poses.empty() ? 10 * rendering : 100 * rendering))
        poses.push_back(pose);
    }
    return poses;
  }
  vit_pose* popWithin(Clock::duration patience) {
    const Clock::time_point deadline = Clock::now() + patience;
    while (Clock::now() < deadline) {
      if (vit_pose* pose = pop()) return pose;
      std::this_thread::yield();
    }
    return nullptr;
  }

  Vit vit_;
  std::filesystem::path settings_;
  vit_tracker* tracker_ = nullptr;
  SequenceFixture sequence_;
};

TEST_F(VitTest, HasAllSymbolsAndTheVersion) {
  for (const char* symbol : {"vit_api_get_version",
                             "vit_tracker_create",
                             "vit_tracker_destroy",
                             "vit_tracker_has_image_format",
                             "vit_tracker_get_supported_extensions",
                             "vit_tracker_get_enabled_extensions",
                             "vit_tracker_enable_extension",
                             "vit_tracker_start",
                             "vit_tracker_stop",
                             "vit_tracker_reset",
                             "vit_tracker_is_running",
                             "vit_tracker_push_imu_sample",
                             "vit_tracker_push_img_sample",
                             "vit_tracker_add_camera_calibration",
                             "vit_tracker_add_imu_calibration",
                             "vit_tracker_pop_pose",
                             "vit_tracker_get_timing_titles",
                             "vit_pose_destroy",
                             "vit_pose_get_data",
                             "vit_pose_get_timing",
                             "vit_pose_get_features"})
    EXPECT_TRUE(vit_.has(symbol)) << symbol;
  std::uint32_t major = 0, minor = 9, patch = 0;
  ASSERT_EQ(VIT(vit_api_get_version)(&major, &minor, &patch), VIT_SUCCESS);
  EXPECT_EQ(major, 2U);
  EXPECT_EQ(minor, 0U);
  EXPECT_EQ(patch, 1U);
}

TEST_F(VitTest, TracksAWalkAndTellsPosesInOrderWithTimesAndFeatures) {
  ASSERT_EQ(VIT(vit_tracker_enable_extension)(tracker_, VIT_EXTENSION_POSE_TIMING, true),
            VIT_SUCCESS);
  ASSERT_EQ(VIT(vit_tracker_enable_extension)(tracker_, VIT_EXTENSION_POSE_FEATURES, true),
            VIT_SUCCESS);
  const vit_camera_calibration camera = calibration();
  ASSERT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_SUCCESS);
  ASSERT_EQ(VIT(vit_tracker_start)(tracker_), VIT_SUCCESS);
  const std::vector<vit_pose*> poses = walk();
  ASSERT_GT(poses.size(), static_cast<std::size_t>(kFrames / 6));
  std::int64_t last_ns = 0;
  for (vit_pose* pose : poses) {
    vit_pose_data data{};
    vit_pose_timing timing{};
    vit_pose_features features{};
    ASSERT_EQ(VIT(vit_pose_get_data)(pose, &data), VIT_SUCCESS);
    ASSERT_EQ(VIT(vit_pose_get_timing)(pose, &timing), VIT_SUCCESS);
    ASSERT_EQ(VIT(vit_pose_get_features)(pose, 0, &features), VIT_SUCCESS);
    EXPECT_GT(data.timestamp, last_ns);
    last_ns = data.timestamp;
    ASSERT_EQ(timing.count, 3U);
    EXPECT_LE(timing.timestamps[1], timing.timestamps[2]);
    EXPECT_GT(features.count, 20U);
    EXPECT_GT(features.features[0].depth, 0.0F);
    VIT(vit_pose_destroy)(pose);
  }
}

TEST_F(VitTest, RefusesWhatIsOutOfOrderOrOfAnotherSize) {
  const vit_camera_calibration camera = calibration();
  ASSERT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_SUCCESS);
  const ImageU8 image = sequence_.imageAt(0.0);
  EXPECT_EQ(push(image, 1), VIT_ERROR_NOT_ENABLED);  // not started
  ASSERT_EQ(VIT(vit_tracker_start)(tracker_), VIT_SUCCESS);
  EXPECT_EQ(push(image, 1000), VIT_SUCCESS);
  EXPECT_EQ(push(image, 1000), VIT_ERROR_INVALID_VALUE);
  EXPECT_EQ(push(ImageU8(64, 64), 2000), VIT_ERROR_INVALID_VALUE);
  std::vector<std::uint8_t> pixels(static_cast<std::size_t>(image.width() * image.height()));
  vit_img_sample cut{};
  cut.timestamp = 3000;
  cut.data = pixels.data();
  cut.width = cut.stride = static_cast<std::uint32_t>(image.width());
  cut.height = static_cast<std::uint32_t>(image.height());
  cut.size = static_cast<std::uint32_t>(pixels.size() - 1);
  cut.format = VIT_IMAGE_FORMAT_L8;
  EXPECT_EQ(VIT(vit_tracker_push_img_sample)(tracker_, &cut), VIT_ERROR_INVALID_VALUE);
  vit_imu_sample sample{5, 0, 0, 9.8F, 0, 0, 0};
  EXPECT_EQ(VIT(vit_tracker_push_imu_sample)(tracker_, &sample), VIT_SUCCESS);
  EXPECT_EQ(VIT(vit_tracker_push_imu_sample)(tracker_, &sample), VIT_ERROR_INVALID_VALUE);
  EXPECT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_ERROR_NOT_ENABLED);
}

TEST_F(VitTest, StopsResetsAndStartsAgain) {
  const vit_camera_calibration camera = calibration();
  ASSERT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_SUCCESS);
  const ImageU8 image = sequence_.imageAt(0.0);
  bool running = true;
  for (int round = 0; round < 4; ++round) {
    ASSERT_EQ(VIT(vit_tracker_start)(tracker_), VIT_SUCCESS);
    // Times start over with each sequence.
    for (std::int64_t i = 0; i < 10; ++i) EXPECT_EQ(push(image, 1000 + i), VIT_SUCCESS);
    const vit_imu_sample sample{1000, 0, 0, 9.8F, 0, 0, 0};
    EXPECT_EQ(VIT(vit_tracker_push_imu_sample)(tracker_, &sample), VIT_SUCCESS);
    EXPECT_EQ(VIT(vit_tracker_reset)(tracker_), VIT_SUCCESS);
    ASSERT_EQ(VIT(vit_tracker_stop)(tracker_), VIT_SUCCESS);
    ASSERT_EQ(VIT(vit_tracker_is_running)(tracker_, &running), VIT_SUCCESS);
    EXPECT_FALSE(running);
    EXPECT_EQ(pop(), nullptr);
  }
}

TEST_F(VitTest, RefusesSettingsThatItCannotFollow) {
  std::ofstream(settings_) << "backend=gles\n";
  const std::string path = settings_.string();
  const vit_config config{path.c_str(), 1, 0, false};
  vit_tracker* other = nullptr;
  EXPECT_EQ(VIT(vit_tracker_create)(&config, &other), VIT_ERROR_INVALID_VALUE);
  EXPECT_EQ(other, nullptr);
}

TEST_F(VitTest, NeedsACameraAndRefusesLensesThatItLacks) {
  EXPECT_EQ(VIT(vit_tracker_start)(tracker_), VIT_ERROR_INVALID_VALUE);
  vit_camera_calibration camera = calibration();
  camera.model = VIT_DISTORTION_RT8;
  camera.distortion_count = 9;
  camera.distortion[6] = 0.1;
  EXPECT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_ERROR_NOT_SUPPORTED);
  camera.distortion[6] = 0.0;
  camera.distortion[8] = -1.0;  // a validity radius that is not known
  EXPECT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_SUCCESS);
  camera.transform[0] = std::nan("");
  EXPECT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_ERROR_INVALID_VALUE);
  camera.transform[0] = 1.0;
  camera.fx = 0.0;
  EXPECT_EQ(VIT(vit_tracker_add_camera_calibration)(tracker_, &camera), VIT_ERROR_INVALID_VALUE);
}

TEST_F(VitTest, SurvivesNullEverywhere) {
  EXPECT_EQ(VIT(vit_tracker_create)(nullptr, nullptr), VIT_ERROR_INVALID_VALUE);
  EXPECT_EQ(VIT(vit_tracker_push_img_sample)(tracker_, nullptr), VIT_ERROR_INVALID_VALUE);
  EXPECT_EQ(VIT(vit_tracker_start)(nullptr), VIT_ERROR_INVALID_VALUE);
  EXPECT_EQ(VIT(vit_tracker_pop_pose)(tracker_, nullptr), VIT_SUCCESS);  // drops one
  EXPECT_EQ(VIT(vit_pose_get_data)(nullptr, nullptr), VIT_ERROR_INVALID_VALUE);
  VIT(vit_tracker_destroy)(nullptr);
  VIT(vit_pose_destroy)(nullptr);
}

}  // namespace
}  // namespace glide::test
