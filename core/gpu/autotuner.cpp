#include "gpu/autotuner.h"

#include "gpu/shader_source.h"

#include "base/hash.h"

#include "glide/enum_names.h"

#include <algorithm>
#include <array>
#include <limits>
#include <string>

namespace glide {
namespace {

constexpr std::string_view kKind = "tuning";

/// A candidate must be this much faster: less is noise, and equal devices shall run alike.
constexpr double kClearlyFaster = 0.95;

/// Level 1 of a VGA image and those below: workgroups that are worth a whole device.
constexpr int kLargeSingleGroup = 100'000;

/// One step away from the best so far.
using Change = void (*)(GpuTuning*);

constexpr std::array<Change, 5> kChanges{
    [](GpuTuning* tuning) { tuning->group_size = 128; },
    [](GpuTuning* tuning) { tuning->group_size = 32; },
    [](GpuTuning* tuning) { tuning->pyramid = PyramidKernel::tile; },
    [](GpuTuning* tuning) { tuning->single_group_pixels = 0; },
    [](GpuTuning* tuning) { tuning->single_group_pixels = kLargeSingleGroup; },
};

/// The best candidate so far, and the time that is left.
class Race {
 public:
  explicit Race(const TuningProbe& probe) : probe_(probe), start_ms_(probe.now_ms()) {}

  const GpuTuning& best() const { return best_; }
  double bestMs() const { return best_ms_; }
  bool hasTime() const {
    return probe_.now_ms() - start_ms_ + slowest_trial_ms_ <= kTuningBudgetMs;
  }
  /// Milliseconds of the candidate's frame, infinite when it cannot run.
  double measure(const GpuTuning& candidate) {
    const double before_ms = probe_.now_ms();
    const std::optional<double> frame_ms = probe_.frame_ms(candidate);
    slowest_trial_ms_ = std::max(slowest_trial_ms_, probe_.now_ms() - before_ms);
    return frame_ms.value_or(std::numeric_limits<double>::infinity());
  }
  void enter(const GpuTuning& candidate) {
    const double frame_ms = measure(candidate);
    if (frame_ms >= best_ms_ * kClearlyFaster) return;
    best_ = candidate;
    best_ms_ = frame_ms;
  }

 private:
  const TuningProbe& probe_;
  double start_ms_;
  double slowest_trial_ms_ = 0.0;
  GpuTuning best_;
  double best_ms_ = std::numeric_limits<double>::infinity();
};

/// All that decides which tuning is fastest, beside the device.
std::string keyOf(const Config& config) {
  std::uint64_t shaders = kHashStart;
  for (const EmbeddedShader& shader : embeddedShaders()) {
    shaders = fnv1a(bytesOf(shader.text), shaders);
  }
  const Config::Direct& direct = config.direct;
  std::string key = "shaders " + std::to_string(shaders);
  for (const int value : {config.camera.width,
                          config.camera.height,
                          direct.levels,
                          direct.patch_size,
                          direct.max_points}) {
    key += " " + std::to_string(value);
  }
  return key + " " + std::string(enumName(config.camera.distortion));
}

GpuTuning paperTuning() {
  GpuTuning tuning;
  tuning.plan = GpuPlan::paper;
  return tuning;
}

bool mayTry(const Config& config, const DriverQuirks& quirks, const DeviceCache& files) {
  return config.gl.autotune == GpuAutotune::on && config.execution == Execution::threaded &&
         files.isKept() && !quirks.has_slow_builds;
}

}  // namespace

GpuTuning fastestTuning(const TuningProbe& probe) {
  Race race(probe);
  race.enter(GpuTuning{});
  for (const Change change : kChanges) {
    GpuTuning candidate = race.best();
    change(&candidate);
    if (!race.hasTime()) return race.best();
    if (candidate != race.best()) race.enter(candidate);
  }
  // A GPU that raises its clock while it is tried flatters whoever comes later.
  if (race.best() != GpuTuning{} && race.hasTime() &&
      race.bestMs() >= race.measure(GpuTuning{}) * kClearlyFaster) {
    return GpuTuning{};
  }
  return race.best();
}

GpuTuning chooseTuning(const Config& config,
                       const DriverQuirks& quirks,
                       const DeviceCache& files,
                       const TuningProbe& probe) {
  if (config.gl.plan == GpuPlanChoice::paper) return paperTuning();
  const std::string key = keyOf(config);
  if (const auto kept = files.load(kKind, key)) {
    if (const std::optional<GpuTuning> tuning = decodeTuning(*kept)) return *tuning;
  }
  if (!mayTry(config, quirks, files)) return GpuTuning{};
  const GpuTuning fastest = fastestTuning(probe);
  files.store(kKind, key, encodeTuning(fastest));
  return fastest;
}

}  // namespace glide
