// reference_run walk OUT COUNT, or reference_run tum FOLDER OUT COUNT: tracks images through the
// C++ API and writes what a client in another language needs to do the same and compare:
// OUT/0000.pgm... and OUT/sequence.txt, whose first line is the camera (width height fx fy cx cy
// model coefficients) and each further line a frame: t_ns, 1 when tracked, translation x y z and
// quaternion x y z w of the camera in GL axes.
#include "replay/calibration/calibration.h"
#include "replay/readers/dataset.h"
#include "replay/readers/image_decoder.h"
#include "unit/session/sequence_fixture.h"

#include "glide/session.h"

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <utility>
#include <vector>

namespace {

using namespace glide;

constexpr std::int64_t kFrame_ns = 33'333'333;
constexpr double kStep_m = 0.01;

struct Sequence {
  Config config;
  std::vector<std::pair<std::int64_t, ImageU8>> frames;
};

Sequence walk(int count) {
  const test::SequenceFixture fixture;
  Sequence sequence{fixture.config(), {}};
  for (int i = 0; i < count; ++i)
    sequence.frames.emplace_back((i + 1) * kFrame_ns, fixture.imageAt(i * kStep_m));
  return sequence;
}

Sequence tum(const std::filesystem::path& folder, int count) {
  const replay::Dataset dataset = replay::openTum(folder).value();
  Sequence sequence;
  sequence.config.camera = replay::loadCalibration(dataset.calibration.value()).value().camera;
  sequence.config.backend = Backend::cpu;
  sequence.config.execution = Execution::inline_;
  for (const replay::ImageEntry& entry : dataset.images) {
    if (static_cast<int>(sequence.frames.size()) == count) break;
    sequence.frames.emplace_back(entry.t_ns,
                                 std::move(replay::decodeImage(entry.file).value().gray));
  }
  return sequence;
}

void writePgm(const std::filesystem::path& path, const ImageU8& image) {
  std::ofstream file(path, std::ios::binary);
  file << "P5\n" << image.width() << " " << image.height() << "\n255\n";
  for (int y = 0; y < image.height(); ++y)
    file.write(reinterpret_cast<const char*>(image.row(y)), image.width());
}

void writeCamera(std::FILE* file, const CameraIntrinsics& camera) {
  std::fprintf(file, "%d %d", camera.width, camera.height);
  for (const double value : {camera.fx, camera.fy, camera.cx, camera.cy})
    std::fprintf(file, " %.17g", value);
  std::fprintf(file, " %d", static_cast<int>(camera.distortion));
  for (const double value : camera.coefficients) std::fprintf(file, " %.17g", value);
  std::fprintf(file, "\n");
}

/// Half a turn about x, of the world and of the camera: y and z change their signs.
void writeFrame(std::FILE* file, const FrameResult& frame) {
  const auto& t = frame.T_world_cam.t_xyz;
  const auto& q = frame.T_world_cam.q_xyzw;
  const int is_tracked = frame.state == TrackingState::tracking ? 1 : 0;
  std::fprintf(file, "%lld %d", static_cast<long long>(frame.t_ns), is_tracked);
  for (const double value : {t[0], -t[1], -t[2], q[0], -q[1], -q[2], q[3]})
    std::fprintf(file, " %.17g", value);
  std::fprintf(file, "\n");
}

int run(const Sequence& sequence, const std::filesystem::path& out) {
  std::filesystem::create_directories(out);
  std::FILE* file = std::fopen((out / "sequence.txt").c_str(), "w");
  if (file == nullptr) return std::fprintf(stderr, "cannot write into %s\n", out.c_str()), 1;
  writeCamera(file, sequence.config.camera);
  Session session = Session::create(sequence.config).value();
  int number = 0;
  for (const auto& [t_ns, image] : sequence.frames) {
    char name[32];
    std::snprintf(name, sizeof name, "%04d.pgm", number++);
    writePgm(out / name, image);
    const Luma luma{image.row(0), image.width(), image.height(), image.stride()};
    writeFrame(file, session.update({t_ns, luma}).value());
  }
  return std::fclose(file) == 0 ? 0 : 1;
}

}  // namespace

int main(int count, char** arguments) {
  const std::string kind = count > 1 ? arguments[1] : "";
  if (kind == "walk" && count == 4) return run(walk(std::atoi(arguments[3])), arguments[2]);
  if (kind == "tum" && count == 5)
    return run(tum(arguments[2], std::atoi(arguments[4])), arguments[3]);
  return std::fprintf(stderr, "usage: reference_run walk OUT COUNT | tum FOLDER OUT COUNT\n"), 1;
}
