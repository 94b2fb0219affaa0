// write_walk FOLDER COUNT: the session tests' walk as PGM images, for programs in other languages.
// Prints the arguments of track_folder that describe its camera.
#include "unit/session/sequence_fixture.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>

namespace {

constexpr double kStep_m = 0.01;

bool writePgm(const std::string& path, const glide::ImageU8& image) {
  std::ofstream file(path, std::ios::binary);
  file << "P5\n" << image.width() << " " << image.height() << "\n255\n";
  for (int y = 0; y < image.height(); ++y)
    file.write(reinterpret_cast<const char*>(image.row(y)), image.width());
  return file.good();
}

}  // namespace

int main(int count, char** arguments) {
  if (count != 3) return std::fprintf(stderr, "usage: write_walk FOLDER COUNT\n"), 1;
  const glide::test::SequenceFixture sequence;
  std::filesystem::create_directories(arguments[1]);
  for (int i = 0; i < std::atoi(arguments[2]); ++i) {
    char name[32];
    std::snprintf(name, sizeof name, "/%04d.pgm", i);
    if (!writePgm(arguments[1] + std::string(name), sequence.imageAt(i * kStep_m)))
      return std::fprintf(stderr, "cannot write %s%s\n", arguments[1], name), 1;
  }
  const glide::CameraIntrinsics camera = sequence.config().camera;
  std::printf("%d %d %g %g %g %g\n",
              camera.width,
              camera.height,
              camera.fx,
              camera.fy,
              camera.cx,
              camera.cy);
}
