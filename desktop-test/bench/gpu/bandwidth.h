#pragma once

#include "glide/result.h"

namespace glide::gpubench {

/// Bytes read and written in a second, GB/s (1e9), while the device copies a buffer of 64 MiB to
/// another (glCopyBufferSubData, the best of some tries, wall clock around a fence). An error where
/// GL refuses. Needs a current context; leaves the copy bindings empty.
Result<double> measureBandwidth();

}  // namespace glide::gpubench
