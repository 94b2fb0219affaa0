#pragma once

#include "replay/cli/rendered_dataset.h"
#include "replay/common/text.h"
#include "replay/readers/scratch_folder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <string>
#include <vector>

namespace glide::replay {

/// A rendered dataset for all tests of a suite, and a folder for each test.
class DatasetTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    std::filesystem::remove_all(dataset());
    writeRenderedDataset(dataset());
  }
  static void TearDownTestSuite() { std::filesystem::remove_all(dataset()); }
  static std::filesystem::path dataset() {
    return std::filesystem::path(testing::TempDir()) / "glide_cli_dataset";
  }

  std::filesystem::path out() const { return folder_.path() / "out"; }
  /// A file that a replay has written into out().
  std::string output(const std::string& name) const {
    const auto text = readFile(out() / name);
    EXPECT_TRUE(text.ok()) << name;
    return text ? *text : "";
  }

  /// A private copy of the dataset, to damage.
  std::filesystem::path copy() const {
    const std::filesystem::path path = folder_.path() / "copy";
    std::filesystem::copy(dataset(), path, std::filesystem::copy_options::recursive);
    return path;
  }
  /// A copy with the images to and fro, one for each of these times.
  std::string walkFor(const std::vector<double>& times_s) const {
    constexpr int kPeriod = 2 * kRenderedFrames - 2;
    const std::filesystem::path walk = copy();
    std::string list;
    int frame = 0;
    for (const double t_s : times_s) {
      const int phase = frame++ % kPeriod;
      const int image = std::min(phase, kPeriod - phase);
      list += std::to_string(t_s) + " rgb/" + std::to_string(image) + ".png\n";
    }
    EXPECT_TRUE(writeFile(walk / "rgb.txt", list).ok());
    return walk.string();
  }
  /// Times of so many frames, 30 a second from 1 s on.
  static std::vector<double> steadyTimes(int count) {
    constexpr double kRate_Hz = 30.0;
    std::vector<double> times;
    for (int i = 0; i < count; ++i) times.push_back(1.0 + i / kRate_Hz);
    return times;
  }

  const ScratchFolder folder_;
};

}  // namespace glide::replay
