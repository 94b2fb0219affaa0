#include "session/aligner_factory.h"

#include "photometric/cpu_aligner.h"

#include <utility>

#if defined(GLIDE_GLES)
#include "gpu/autotuner.h"
#include "gpu/device_cache.h"
#include "gpu/gl_caps.h"
#include "gpu/gpu_aligner.h"
#include "gpu/program_cache.h"
#include "gpu/tuning_trial.h"
#endif

namespace glide {
namespace {

Result<ChosenAligner> makeCpuAligner(const Config& config, const CameraModel& camera) {
  auto aligner = CpuAligner::create(config.direct, camera);
  if (!aligner) return aligner.error();
  ChosenAligner chosen;
  chosen.aligner = std::move(*aligner);
  chosen.info.backend = Backend::cpu;
  return chosen;
}

#if defined(GLIDE_GLES)
Result<ChosenAligner> makeGpuAligner(const Config& config, const CameraModel& camera) {
  const Result<GlCaps> caps = GlCaps::query();
  if (!caps) return caps.error();
  if (config.backend == Backend::automatic && caps->quirks.is_software)
    return Error{ErrorCode::unsupported, "the current GL is a software rasteriser"};
  const DeviceCache files(config.gl.cache_dir, *caps);
  const ProgramCache programs(files, *caps);
  TuningTrial trial(*caps, config, camera);
  const GpuTuning tuning = chooseTuning(config, caps->quirks, files, trial.probe(programs));
  auto aligner = GpuAligner::createWith(
      *caps, config.direct, camera, tuning, {GpuTiming::passive, config.gl.state, programs});
  if (!aligner) return aligner.error();
  ChosenAligner chosen;
  chosen.aligner = std::move(*aligner);
  chosen.info = {
      Backend::gles, caps->vendor, caps->renderer, caps->version, chosen.aligner->timer()};
  return chosen;
}
#else
Result<ChosenAligner> makeGpuAligner(const Config&, const CameraModel&) {
  return Error{ErrorCode::unsupported, "this build has no OpenGL ES backend (GLIDE_GLES=OFF)"};
}
#endif

}  // namespace

Result<ChosenAligner> chooseAligner(const Config& config, const CameraModel& camera) {
  if (config.backend == Backend::cpu) return makeCpuAligner(config, camera);
  Result<ChosenAligner> gpu = makeGpuAligner(config, camera);
  if (gpu.ok() || config.backend == Backend::gles) return gpu;
  return makeCpuAligner(config, camera);
}

}  // namespace glide
