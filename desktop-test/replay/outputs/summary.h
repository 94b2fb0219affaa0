#pragma once

#include "replay/evaluation/accuracy.h"
#include "replay/outputs/run_record.h"
#include "replay/outputs/statistics.h"

#include <filesystem>
#include <optional>
#include <string>

namespace glide::replay {

/// What the summary is made of.
struct SummaryInput {
  const RunRecord& run;
  const FrameCounts& counts;
  const std::optional<Accuracy>& accuracy;
  std::filesystem::path output;
  bool has_color = false;
};

/// The table at the end of a run, for people. ASCII, at most 100 columns but for paths and the
/// escape codes of colours.
std::string summaryText(const SummaryInput& input);

/// Why there is no map, from the last frame's progress: "too little motion: move the camera
/// sideways".
std::string initializationHint(const RunRecord& run);

}  // namespace glide::replay
