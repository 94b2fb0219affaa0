#pragma once

#include "bench/gpu/sweep.h"

#include <string>

namespace glide::gpubench {

/// Frame cost over points and over patch pixels, a curve a plan, as a PNG; whether it could be
/// written.
bool writePlot(const Sweep& sweep, const std::string& file);

}  // namespace glide::gpubench
