#pragma once

#include "gpu/autotuner.h"
#include "gpu/gl_caps.h"
#include "gpu/gpu_tuning.h"
#include "gpu/program_cache.h"
#include "photometric/align_types.h"

#include "base/stopwatch.h"
#include "geometry/camera_model.h"
#include "image/image.h"

#include "glide/config.h"

#include <optional>
#include <vector>

namespace glide {

/// Runs candidates of the autotuner on the GPU: an aligner of the session's camera and
/// configuration each, on an image that is made up. On the GL thread; needs the context of `caps`.
class TuningTrial {
 public:
  /// Cheap: the image is made when the first candidate runs.
  TuningTrial(const GlCaps& caps, const Config& config, const CameraModel& camera)
      : caps_(caps), config_(config), camera_(camera) {}

  /// What fastestTuning asks; valid as long as this is. Candidates take their programs from
  /// `programs` and leave them there for the session's aligner.
  TuningProbe probe(const ProgramCache& programs);

  /// Milliseconds of the fastest of a few direct frames, GPU time where the driver tells it;
  /// nothing when the candidate cannot run or does not find the pose.
  std::optional<double> frameMs(const GpuTuning& tuning, const ProgramCache& programs);

 private:
  struct Scene {
    ImageU8 image;
    std::vector<AlignPoint> points_ref;
  };
  const Scene& scene();

  GlCaps caps_;
  Config config_;
  CameraModel camera_;
  std::optional<Scene> scene_;
  Stopwatch clock_;
  double now_ms_ = 0.0;
};

}  // namespace glide
