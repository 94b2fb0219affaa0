// glide-growth OUT [SECONDS]: a camera circles in one room for ten minutes, rendered and tracked in
// this process; writes OUT/growth.csv and OUT/growth.png. Exit status: 0 ok, 1 usage or refused, 2
// cannot write.
#include "suites/growth_plot.h"
#include "synthetic/sequence.h"

#include "glide/session.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <string>
#include <unistd.h>

namespace {

using namespace glide;

constexpr int kRefused = 1, kCannotWrite = 2;
constexpr double kDefaultSeconds = 600.0, kNoise = 2.0;
constexpr int kWidth = 320, kHeight = 240;
constexpr int kFramesPerSample = 30;

double residentMb() {
  std::ifstream statm("/proc/self/statm");
  long total_pages = 0, resident_pages = 0;
  statm >> total_pages >> resident_pages;
  constexpr double kBytesPerMb = 1024.0 * 1024.0;
  return static_cast<double>(resident_pages) * static_cast<double>(sysconf(_SC_PAGESIZE)) /
         kBytesPerMb;
}

synthetic::SequenceOptions orbitOptions(double seconds) {
  synthetic::SequenceOptions options;
  options.camera = synthetic::makeCamera(DistortionModel::none, kWidth, kHeight);
  options.motion.kind = synthetic::MotionKind::orbit;
  options.sensor.noise = kNoise;
  options.frames = std::max(1, static_cast<int>(seconds * options.fps));
  return options;
}

growth::Sample sampleOf(const MapView& map, double t_s) {
  const auto retired = std::count_if(map.keyframes.begin(),
                                     map.keyframes.end(),
                                     [](const auto& keyframe) { return keyframe.retired; });
  return {t_s,
          map.keyframes.size() - static_cast<std::size_t>(retired),
          map.landmarks.size(),
          residentMb()};
}

/// Plays the sequence; a sample for each second of it.
std::vector<growth::Sample> play(synthetic::Sequence* sequence, Session* session, int* lost) {
  std::vector<growth::Sample> samples;
  ImageU8 image;
  const double fps = sequence->options().fps;
  for (int i = 0; i < sequence->size(); ++i) {
    sequence->image(i, &image);
    const Luma luma{image.row(0), image.width(), image.height(), image.stride()};
    const Result<FrameResult> result = session->update({sequence->timestamp(i), luma});
    if (!result || result->state == TrackingState::lost) ++*lost;
    if (i % kFramesPerSample != 0) continue;
    samples.push_back(sampleOf(*session->map(), i / fps));
    const growth::Sample& now = samples.back();
    if (samples.size() % 60 == 1)
      std::printf("%5.0f s: %zu keyframes, %zu landmarks, %.1f MB, %d frames lost\n",
                  now.t_s,
                  now.keyframes,
                  now.landmarks,
                  now.rss_mb,
                  *lost);
    std::fflush(stdout);
  }
  return samples;
}

bool writeTable(const std::vector<growth::Sample>& samples, const std::string& file) {
  std::ofstream out(file);
  out << "t_s,keyframes,landmarks,rss_mb\n";
  for (const growth::Sample& sample : samples)
    out << sample.t_s << ',' << sample.keyframes << ',' << sample.landmarks << ',' << sample.rss_mb
        << '\n';
  out.flush();
  return out.good();
}

int run(const std::filesystem::path& folder, double seconds) {
  const synthetic::SequenceOptions options = orbitOptions(seconds);
  Config config;
  config.camera = options.camera;
  config.backend = Backend::cpu;
  config.execution = Execution::inline_;
  Result<synthetic::Sequence> sequence = synthetic::Sequence::create(options);
  Result<Session> session = Session::create(config);
  if (!sequence || !session) return kRefused;
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  int lost = 0;
  const auto samples = play(&*sequence, &*session, &lost);
  const bool is_written = writeTable(samples, (folder / "growth.csv").string()) &&
                          growth::writePlot(samples, (folder / "growth.png").string());
  return is_written ? 0 : kCannotWrite;
}

}  // namespace

int main(int argc, char** argv) {
  const double seconds = argc == 3 ? std::atof(argv[2]) : kDefaultSeconds;
  if (argc < 2 || argc > 3 || !(seconds > 0.0)) {
    std::fprintf(stderr, "usage: glide-growth OUT [SECONDS]\n");
    return kRefused;
  }
  return run(argv[1], seconds);
}
