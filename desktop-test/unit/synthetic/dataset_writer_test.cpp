#include "synthetic/dataset_writer.h"

#include "unit/synthetic/small_color_scene.h"
#include "unit/synthetic/small_scene.h"

#include <gmock/gmock.h>

#include <fstream>
#include <sstream>
#include <string>
#include <unistd.h>

namespace glide::synthetic {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class WriteDataset : public testing::Test {
 protected:
  void SetUp() override {
    const auto* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ =
        fs::temp_directory_path() / ("glide-synth-" + std::to_string(getpid()) + test->name());
  }
  void TearDown() override { fs::remove_all(folder_); }

  Sequence makeSequence() {
    SequenceOptions options = smallSequence(DistortionModel::radial_tangential);
    options.frames = 3;
    return Sequence::create(options, smallScene()).value();
  }
  std::string text(const std::string& file) const {
    std::ostringstream content;
    content << std::ifstream(folder_ / file).rdbuf();
    return content.str();
  }
  static int lines(const std::string& text) {
    return static_cast<int>(std::count(text.begin(), text.end(), '\n'));
  }

  fs::path folder_;
};

TEST_F(WriteDataset, InTumLayoutListsImagesAndCameraPoses) {
  Sequence sequence = makeSequence();
  int progress = 0;
  ASSERT_TRUE(writeDataset(&sequence, {Layout::tum, false}, folder_, [&](int done) {
                progress = done;
              }).ok());
  EXPECT_EQ(progress, 3);
  EXPECT_EQ(lines(text("rgb.txt")), 4);
  EXPECT_THAT(text("rgb.txt"), HasSubstr("\n1000.033333 rgb/1000.033333.png\n"));
  EXPECT_TRUE(fs::exists(folder_ / "rgb" / "1000.066667.png"));
  EXPECT_THAT(text("camera.yaml"), HasSubstr("Camera.k1: -0.28\n"));
  std::istringstream line(
      text("groundtruth.txt").substr(text("groundtruth.txt").find("1000.033333")));
  double t = 0.0;
  Vec3d p;
  line >> t >> p.x() >> p.y() >> p.z();
  EXPECT_LT((p - sequence.T_world_cam(1).t).norm(), 1e-8);
}

TEST_F(WriteDataset, InEurocLayoutTellsTheBodysPoseAndWhereTheCameraSits) {
  Sequence sequence = makeSequence();
  ASSERT_TRUE(writeDataset(&sequence, {Layout::euroc, false}, folder_, [](int) {}).ok());
  EXPECT_THAT(text("mav0/cam0/data.csv"), HasSubstr("\n1000033333333,1000033333333.png\n"));
  EXPECT_TRUE(fs::exists(folder_ / "mav0/cam0/data/1000066666667.png"));
  EXPECT_THAT(text("mav0/cam0/sensor.yaml"), HasSubstr("distortion_model: radial-tangential\n"));
  std::string truth = text("mav0/state_groundtruth_estimate0/data.csv");
  truth = truth.substr(truth.find("1000033333333,"));
  std::replace(truth.begin(), truth.end(), ',', ' ');
  std::istringstream line(truth);
  double t = 0.0;
  SE3d T_world_body;
  line >> t >> T_world_body.t.x() >> T_world_body.t.y() >> T_world_body.t.z();
  line >> T_world_body.q.w() >> T_world_body.q.x() >> T_world_body.q.y() >> T_world_body.q.z();
  // T_BS as in sensor.yaml: camera forward is body forward, camera right is minus body left.
  const Vec3d camera_in_body(0.06, 0.02, -0.01);
  EXPECT_LT((T_world_body * camera_in_body - sequence.T_world_cam(1).t).norm(), 1e-7);
  const Vec3d forward_cam = sequence.T_world_cam(1).q * Vec3d::UnitZ();
  EXPECT_LT((T_world_body.q * Vec3d::UnitX() - forward_cam).norm(), 1e-7);
}

TEST_F(WriteDataset, WritesColoursWhenAskedTo) {
  SequenceOptions options = smallSequence(DistortionModel::none);
  options.frames = 2;
  Sequence sequence = Sequence::create(options, smallColorScene()).value();
  ASSERT_TRUE(writeDataset(&sequence, {Layout::tum, true}, folder_, [](int) {}).ok());
  constexpr std::size_t kColorType = 25;  // where a PNG's header says it; 2 = red, green, blue
  EXPECT_EQ(text("rgb/1000.000000.png").at(kColorType), 2);
}

TEST_F(WriteDataset, NamesTheFolderThatCannotBeMade) {
  std::ofstream(folder_) << "a file in the way";
  Sequence sequence = makeSequence();
  const auto status = writeDataset(&sequence, {Layout::tum, false}, folder_, [](int) {});
  ASSERT_FALSE(status.ok());
  EXPECT_THAT(status.error().message, HasSubstr(folder_.string()));
}

}  // namespace
}  // namespace glide::synthetic
