#include "replay/readers/dataset.h"

#include "replay/readers/scratch_folder.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace glide::replay {
namespace {

using ::testing::HasSubstr;

std::string faultOf(const Result<Dataset>& dataset) {
  return dataset ? "" : dataset.error().message;
}

std::vector<std::int64_t> times(const Result<Dataset>& dataset) {
  std::vector<std::int64_t> result;
  for (const ImageEntry& image : dataset->images) result.push_back(image.t_ns);
  return result;
}

TEST(TumDataset, ListsImagesWithExactTimes) {
  const ScratchFolder folder;
  folder.write("rgb.txt",
               "# a\n#time, name\n1305031102.175304 rgb/a.png\n1305031102.2 rgb/b.png\n");
  const auto dataset = openTum(folder.path());
  ASSERT_TRUE(dataset.ok());
  EXPECT_EQ(times(dataset), (std::vector<std::int64_t>{1305031102175304000, 1305031102200000000}));
  EXPECT_EQ(dataset->images[0].file, folder.path() / "rgb/a.png");
  EXPECT_EQ(dataset->listed, 2);
  EXPECT_EQ(dataset->groundtruth, std::nullopt);
}

TEST(TumDataset, FindsCalibrationAndGroundTruthBesideTheList) {
  const ScratchFolder folder;
  folder.write("rgb.txt", "1.0 a.png\n");
  folder.write("camera.yaml", "");
  folder.write("groundtruth.txt", "");
  const auto dataset = openTum(folder.path());
  EXPECT_EQ(dataset->calibration, folder.path() / "camera.yaml");
  EXPECT_EQ(dataset->groundtruth, folder.path() / "groundtruth.txt");
}

TEST(TumDataset, TellsThePresetByTheFoldersName) {
  const ScratchFolder folder;
  for (const auto& [name, preset] : {std::pair{"rgbd_dataset_freiburg2_desk", "freiburg2"},
                                     {"tum_fr3_office", "freiburg3"},
                                     {"fr1_xyz", "freiburg1"},
                                     {"office", ""}}) {
    folder.write(std::string(name) + "/rgb.txt", "1.0 a.png\n");
    EXPECT_EQ(openTum(folder.path() / name)->preset, preset) << name;
    EXPECT_EQ(openTum(folder.path() / name / "")->name, name);
  }
}

TEST(TumDataset, NamesTheLineWhoseTimeGoesBack) {
  const ScratchFolder folder;
  folder.write("rgb.txt", "# list\n1.0 a.png\n3.0 b.png\n2.0 c.png\n");
  EXPECT_THAT(faultOf(openTum(folder.path())),
              HasSubstr("rgb.txt:4: timestamp 2.000000000 s lies before 3.000000000 s"));
}

TEST(TumDataset, SkipsAndCountsRepeatedTimes) {
  const ScratchFolder folder;
  folder.write("rgb.txt", "1.0 a.png\n1.0 b.png\n2.0 c.png\n");
  const auto dataset = openTum(folder.path());
  EXPECT_EQ(dataset->images.size(), 2u);
  ASSERT_EQ(dataset->skips.skips().size(), 1u);
  EXPECT_EQ(describe(dataset->skips.skips()[0], dataset->listed),
            "1 of 3 images repeat the timestamp of the one before (first: b.png)");
}

TEST(TumDataset, NamesTheLineThatIsBroken) {
  const ScratchFolder folder;
  folder.write("rgb.txt", "1.0 a.png\nyesterday b.png\n");
  EXPECT_THAT(faultOf(openTum(folder.path())), HasSubstr("rgb.txt:2: 'yesterday' is not a time"));
  folder.write("rgb.txt", "1.0\n");
  EXPECT_THAT(faultOf(openTum(folder.path())), HasSubstr("rgb.txt:1: expected a timestamp and a"));
  folder.write("rgb.txt", "# nothing\n");
  EXPECT_THAT(faultOf(openTum(folder.path())), HasSubstr("lists no image"));
}

TEST(EurocDataset, IsFoundFromTheTopAndFromTheCamera) {
  const ScratchFolder folder;
  folder.write("mav0/cam0/data.csv",
               "#timestamp [ns],filename\r\n1403636584763555584,1403636584763555584.png\r\n");
  folder.write("mav0/cam0/sensor.yaml", "");
  folder.write("mav0/state_groundtruth_estimate0/data.csv", "");
  for (const char* start : {"", "mav0", "mav0/cam0"}) {
    const auto dataset = openEuroc(folder.path() / start);
    ASSERT_TRUE(dataset.ok()) << start;
    EXPECT_EQ(times(dataset), std::vector<std::int64_t>{1403636584763555584});
    EXPECT_EQ(dataset->images[0].file.filename(), "1403636584763555584.png");
    EXPECT_EQ(dataset->images[0].file.parent_path().filename(), "data");
    EXPECT_TRUE(dataset->calibration.has_value()) << start;
    EXPECT_TRUE(dataset->groundtruth.has_value()) << start;
  }
}

TEST(EurocDataset, RefusesTimesThatAreNotNanoseconds) {
  const ScratchFolder folder;
  folder.write("cam0/data.csv", "1403636584.76,a.png\n");
  EXPECT_THAT(faultOf(openEuroc(folder.path())), HasSubstr("data.csv:1: '1403636584.76' is not"));
}

TEST(ImageFolder, OrdersNaturallyAtThirtyFramesPerSecond) {
  const ScratchFolder folder;
  for (const char* name : {"img10.png", "img9.png", "img1.PNG", "notes.txt"}) {
    folder.write(name, "");
  }
  const auto dataset = openImageFolder(folder.path(), std::nullopt);
  ASSERT_EQ(dataset->images.size(), 3u);
  EXPECT_EQ(dataset->images[0].name, "img1.PNG");
  EXPECT_EQ(dataset->images[1].name, "img9.png");
  EXPECT_EQ(dataset->images[2].name, "img10.png");
  EXPECT_EQ(times(dataset), (std::vector<std::int64_t>{0, 33333333, 66666666}));
}

TEST(ImageFolder, TakesTimesFromNamesThatAreNanosecondsOrSeconds) {
  const ScratchFolder ns;
  ns.write("1403636584763555584.png", "");
  ns.write("1403636584813555456.png", "");
  EXPECT_EQ(times(openImageFolder(ns.path(), std::nullopt)),
            (std::vector<std::int64_t>{1403636584763555584, 1403636584813555456}));
  EXPECT_EQ(times(openImageFolder(ns.path(), 10.0)), (std::vector<std::int64_t>{0, 100000000}));
}

TEST(ImageFolder, TakesTimesFromNamesThatAreSecondsWithAPoint) {
  const ScratchFolder folder;
  folder.write("9.5.jpg", "");
  folder.write("10.25.jpg", "");
  EXPECT_EQ(times(openImageFolder(folder.path(), std::nullopt)),
            (std::vector<std::int64_t>{9500000000, 10250000000}));
}

TEST(ImageFolder, RefusesAFolderWithoutImages) {
  const ScratchFolder folder;
  EXPECT_THAT(faultOf(openImageFolder(folder.path(), std::nullopt)), HasSubstr("has no images"));
}

TEST(NaturalOrder, ComparesRunsOfDigitsAsNumbers) {
  EXPECT_TRUE(naturalLess("a2b", "a10b"));
  EXPECT_FALSE(naturalLess("a10b", "a2b"));
  EXPECT_TRUE(naturalLess("a", "ab"));
  EXPECT_TRUE(naturalLess("a1", "a1b"));
  EXPECT_TRUE(naturalLess("a007", "a8"));
  EXPECT_FALSE(naturalLess("a1", "a1"));
  EXPECT_TRUE(naturalLess("a01", "a1") != naturalLess("a1", "a01"));
}

}  // namespace
}  // namespace glide::replay
