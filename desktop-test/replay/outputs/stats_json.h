#pragma once

#include "replay/evaluation/accuracy.h"
#include "replay/outputs/run_record.h"
#include "replay/outputs/statistics.h"

#include <nlohmann/json.hpp>

#include <optional>

namespace glide::replay {

/// stats.json, schema 1 (docs/replay.md): all keys always present, null where not applicable.
nlohmann::ordered_json statsJson(const RunRecord& run,
                                 const FrameCounts& counts,
                                 const std::optional<Accuracy>& accuracy);

/// Every config field, nested by its dotted name.
nlohmann::ordered_json configJson(const Config& config);

}  // namespace glide::replay
