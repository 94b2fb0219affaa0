#pragma once

#include "replay/outputs/frame_observer.h"
#include "replay/outputs/report_thumbnails.h"

#include <nlohmann/json.hpp>

#include <cstddef>
#include <vector>

namespace glide::replay {

/// A larger map is thinned to this many landmarks in the report, the best observed ones.
inline constexpr std::size_t kMaxReportLandmarks = 15000;

/// What report.html holds of a run (docs/report.md): columns of numbers as base64, the files
/// that it offers for download as they are, pictures.
nlohmann::ordered_json reportData(const FinishedRun& finished,
                                  const std::vector<Thumbnail>& pictures);

}  // namespace glide::replay
