#pragma once

#include "bench/gpu/measure.h"

#include <nlohmann/json.hpp>

#include <string>

namespace glide::gpubench {

/// The name of a plan in options, JSON and tables.
std::string planName(GpuPlan plan);

/// {vendor, renderer, version, timer}; timer: query or sync.
nlohmann::ordered_json gpuJson(const GlCaps& caps, const PlanRun& run);

/// What ./glide bench gpu --json writes: gpu, plans, pose_difference.
nlohmann::ordered_json toJson(const Measurement& measurement);

/// Stages and levels of all plans side by side.
std::string toMarkdown(const Measurement& measurement);

}  // namespace glide::gpubench
