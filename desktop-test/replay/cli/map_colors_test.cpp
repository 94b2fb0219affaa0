#include "replay/cli/rendered_dataset.h"
#include "replay/cli/replay_program.h"
#include "replay/common/text.h"
#include "replay/readers/scratch_folder.h"

#include <gtest/gtest.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <cstdlib>
#include <string>
#include <vector>

namespace glide::replay {
namespace {

/// Makes the gray images orange: green is half of red, blue a quarter.
void tint(const std::filesystem::path& dataset) {
  for (int i = 0; i < kRenderedFrames; ++i) {
    const std::string file = (dataset / "rgb" / (std::to_string(i) + ".png")).string();
    const cv::Mat gray = cv::imread(file, cv::IMREAD_GRAYSCALE);
    std::vector<cv::Mat> channels{0.25 * gray, 0.5 * gray, gray};
    cv::Mat color;
    cv::merge(channels, color);
    cv::imwrite(file, color);
  }
}

struct Vertex {
  int red = 0, green = 0, blue = 0;
  bool isOrange() const {
    return red > 0 && std::abs(red - 2 * green) <= 3 && std::abs(red - 4 * blue) <= 6;
  }
};

std::vector<Vertex> verticesOf(const std::string& ply) {
  constexpr std::size_t kVertexBytes = 19, kColorOffset = 12;
  const std::string marker = "end_header\n";
  std::vector<Vertex> vertices;
  for (std::size_t at = ply.find(marker) + marker.size(); at < ply.size(); at += kVertexBytes) {
    const auto byte = [&](std::size_t i) {
      return static_cast<int>(static_cast<unsigned char>(ply[at + kColorOffset + i]));
    };
    vertices.push_back({byte(0), byte(1), byte(2)});
  }
  return vertices;
}

TEST(MapColors, AreThoseOfTheImages) {
  const ScratchFolder folder;
  const auto dataset = folder.path() / "orange";
  writeRenderedDataset(dataset);
  tint(dataset);
  const auto out = folder.path() / "out";
  const ProgramResult result = runReplay(
      {dataset.string(), "-o", out.string(), "--deterministic", "--no-report"}, folder.path());
  ASSERT_EQ(result.exit_code, 0) << result.err;
  const std::vector<Vertex> vertices = verticesOf(*readFile(out / "map.ply"));
  ASSERT_GT(vertices.size(), 100U);
  std::size_t orange = 0;
  for (const Vertex& vertex : vertices) orange += vertex.isOrange() ? 1 : 0;
  EXPECT_GT(orange, vertices.size() * 95 / 100);
}

}  // namespace
}  // namespace glide::replay
