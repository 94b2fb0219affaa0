#pragma once

#include "gpu/device_cache.h"
#include "gpu/driver_quirks.h"
#include "gpu/gpu_tuning.h"

#include "glide/config.h"

#include <functional>
#include <optional>

namespace glide {

/// Of all that is tried on a device, building shaders included.
inline constexpr double kTuningBudgetMs = 300.0;

/// How candidates are looked at: on the GPU (TuningTrial), or what a test makes up.
struct TuningProbe {
  /// Milliseconds of a direct frame; nothing when the device cannot run the candidate or its pose
  /// is wrong.
  std::function<std::optional<double>(const GpuTuning&)> frame_ms;
  /// A clock that never goes back.
  std::function<double()> now_ms;
};

/// Tries GpuTuning's defaults and then what may be faster, one property after the other, and gives
/// back the fastest. Begins nothing that would end after kTuningBudgetMs if it took as long as the
/// slowest candidate so far. A candidate has to win clearly: on equal devices the defaults stay.
GpuTuning fastestTuning(const TuningProbe& probe);

/// What a session's aligner runs with: the paper's plan when the configuration says so; else what
/// `files` keep of this device, image size and patch; else, when it may be tried and kept, the
/// fastest; else the defaults. Measured times differ from run to run, and the group size decides
/// in which order sums are rounded: so Execution::inline_, which promises the same bytes, tries
/// nothing. Nor do drivers that are slow to build programs.
GpuTuning chooseTuning(const Config& config,
                       const DriverQuirks& quirks,
                       const DeviceCache& files,
                       const TuningProbe& probe);

}  // namespace glide
