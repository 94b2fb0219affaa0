#pragma once

#include "replay/outputs/run_record.h"

#include <string>

namespace glide::replay {

/// frames.csv: a header line, then one line per frame that the session was given.
std::string framesCsv(const RunRecord& run);

}  // namespace glide::replay
