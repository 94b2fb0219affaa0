#pragma once

#include "replay/app/job.h"

#include <optional>

namespace glide::replay {

/// Adds what writes report.html, as --report asks for it.
std::optional<Failure> addReportWatcher(Job& job);

}  // namespace glide::replay
