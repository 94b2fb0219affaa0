#pragma once

#include "glide/config.h"

#include <string_view>

namespace glide {

/// What a config field is called and may hold. Enums and lists have no range (min = max = 0).
struct FieldInfo {
  std::string_view name;  ///< dotted path, for instance "direct.patch_size"
  std::string_view unit;  ///< empty for pure numbers and enums
  double min = 0.0;       ///< smallest legal value
  double max = 0.0;       ///< largest legal value
};

namespace config_fields {

template <class ConfigT, class Visitor>
void visitCamera(ConfigT& config, Visitor& visit) {
  auto& camera = config.camera;
  visit(FieldInfo{"camera.width", "px", 1, 65536}, camera.width);
  visit(FieldInfo{"camera.height", "px", 1, 65536}, camera.height);
  visit(FieldInfo{"camera.fx", "px", 1e-3, 1e6}, camera.fx);
  visit(FieldInfo{"camera.fy", "px", 1e-3, 1e6}, camera.fy);
  visit(FieldInfo{"camera.cx", "px", -1e6, 1e6}, camera.cx);
  visit(FieldInfo{"camera.cy", "px", -1e6, 1e6}, camera.cy);
  visit(FieldInfo{"camera.distortion", ""}, camera.distortion);
  visit(FieldInfo{"camera.coefficients", ""}, camera.coefficients);
}

template <class ConfigT, class Visitor>
void visitModes(ConfigT& config, Visitor& visit) {
  visit(FieldInfo{"backend", ""}, config.backend);
  visit(FieldInfo{"tracker", ""}, config.tracker);
  visit(FieldInfo{"execution", ""}, config.execution);
  visit(FieldInfo{"mode", ""}, config.mode);
  visit(FieldInfo{"tracked_points", ""}, config.tracked_points);
}

template <class ConfigT, class Visitor>
void visitDirect(ConfigT& config, Visitor& visit) {
  auto& direct = config.direct;
  visit(FieldInfo{"direct.patch_size", "px", 5, 15}, direct.patch_size);
  visit(FieldInfo{"direct.levels", "", 1, 8}, direct.levels);
  visit(FieldInfo{"direct.max_iterations", "", 1, 50}, direct.max_iterations);
  visit(FieldInfo{"direct.photometric", ""}, direct.photometric);
  visit(FieldInfo{"direct.hessian", ""}, direct.hessian);
  visit(FieldInfo{"direct.huber_factor", "", 0.5, 10}, direct.huber_factor);
  visit(FieldInfo{"direct.huber_floor", "grey levels", 0.1, 100}, direct.huber_floor);
  visit(FieldInfo{"direct.convergence", "", 1e-9, 1e-1}, direct.convergence);
  visit(FieldInfo{"direct.min_points", "", 6, 1000}, direct.min_points);
  visit(FieldInfo{"direct.max_points", "", 15, 4096}, direct.max_points);
  visit(FieldInfo{"direct.max_direct_frames", "frames", 1, 1000}, direct.max_direct_frames);
  visit(FieldInfo{"direct.max_rms", "grey levels", 1, 255}, direct.max_rms);
  visit(FieldInfo{"direct.max_rms_contrast", "", 0.05, 10}, direct.max_rms_contrast);
  visit(FieldInfo{"direct.max_rms_growth", "", 1.1, 100}, direct.max_rms_growth);
  visit(FieldInfo{"direct.max_baseline", "", 0.001, 10}, direct.max_baseline);
  visit(FieldInfo{"direct.max_rotation_deg", "deg", 0.1, 180}, direct.max_rotation_deg);
  visit(FieldInfo{"direct.min_visible_ratio", "", 0, 1}, direct.min_visible_ratio);
  visit(FieldInfo{"direct.min_inlier_ratio", "", 0, 1}, direct.min_inlier_ratio);
}

template <class ConfigT, class Visitor>
void visitFeatures(ConfigT& config, Visitor& visit) {
  auto& features = config.features;
  visit(FieldInfo{"features.count", "", 100, 10000}, features.count);
  visit(FieldInfo{"features.initialization_count", "", 100, 10000}, features.initialization_count);
  visit(FieldInfo{"features.levels", "", 1, 12}, features.levels);
  visit(FieldInfo{"features.scale_factor", "", 1.05, 2}, features.scale_factor);
  visit(FieldInfo{"features.fast_threshold", "grey levels", 2, 255}, features.fast_threshold);
  visit(FieldInfo{"features.fast_threshold_low", "grey levels", 1, 255},
        features.fast_threshold_low);
}

template <class ConfigT, class Visitor>
void visitInitialization(ConfigT& config, Visitor& visit) {
  auto& start = config.initialization;
  visit(FieldInfo{"initialization.min_matches", "", 20, 10000}, start.min_matches);
  visit(FieldInfo{"initialization.min_landmarks", "", 10, 10000}, start.min_landmarks);
  visit(FieldInfo{"initialization.min_parallax_deg", "deg", 0.1, 30}, start.min_parallax_deg);
  visit(FieldInfo{"initialization.sigma_px", "px", 0.1, 10}, start.sigma_px);
  visit(FieldInfo{"initialization.median_depth", "scene units", 1e-3, 1e3}, start.median_depth);
  visit(FieldInfo{"initialization.max_reference_age", "frames", 2, 10000}, start.max_reference_age);
}

template <class ConfigT, class Visitor>
void visitIndirect(ConfigT& config, Visitor& visit) {
  auto& indirect = config.indirect;
  visit(FieldInfo{"indirect.min_inliers", "", 6, 1000}, indirect.min_inliers);
  visit(FieldInfo{"indirect.search_radius_px", "px", 1, 100}, indirect.search_radius_px);
  visit(FieldInfo{"indirect.max_descriptor_distance", "bits", 1, 256},
        indirect.max_descriptor_distance);
  visit(FieldInfo{"indirect.ratio", "", 0.1, 1}, indirect.ratio);
  visit(FieldInfo{"indirect.max_local_landmarks", "", 100, 100000}, indirect.max_local_landmarks);
}

template <class ConfigT, class Visitor>
void visitKeyframes(ConfigT& config, Visitor& visit) {
  auto& keyframes = config.keyframes;
  visit(FieldInfo{"keyframes.min_interval", "frames", 0, 1000}, keyframes.min_interval);
  visit(FieldInfo{"keyframes.max_interval", "frames", 1, 100000}, keyframes.max_interval);
  visit(FieldInfo{"keyframes.min_tracked_ratio", "", 0, 1}, keyframes.min_tracked_ratio);
  visit(FieldInfo{"keyframes.min_baseline", "", 0, 10}, keyframes.min_baseline);
  visit(FieldInfo{"keyframes.min_tracked", "", 0, 10000}, keyframes.min_tracked);
}

template <class ConfigT, class Visitor>
void visitMapping(ConfigT& config, Visitor& visit) {
  auto& mapping = config.mapping;
  visit(FieldInfo{"mapping.neighbors", "", 1, 100}, mapping.neighbors);
  visit(FieldInfo{"mapping.local_keyframes", "", 2, 200}, mapping.local_keyframes);
  visit(FieldInfo{"mapping.min_covisibility", "", 1, 1000}, mapping.min_covisibility);
  visit(FieldInfo{"mapping.min_parallax_deg", "deg", 0.05, 30}, mapping.min_parallax_deg);
  visit(FieldInfo{"mapping.redundant_ratio", "", 0.1, 1}, mapping.redundant_ratio);
  visit(FieldInfo{"mapping.ba_iterations", "", 1, 200}, mapping.ba_iterations);
  visit(FieldInfo{"mapping.queue_capacity", "", 1, 100}, mapping.queue_capacity);
}

template <class ConfigT, class Visitor>
void visitCalibration(ConfigT& config, Visitor& visit) {
  visit(FieldInfo{"calibration.refinement", ""}, config.calibration.refinement);
}

template <class ConfigT, class Visitor>
void visitLoop(ConfigT& config, Visitor& visit) {
  visit(FieldInfo{"loop.closing", ""}, config.loop.closing);
}

template <class ConfigT, class Visitor>
void visitGl(ConfigT& config, Visitor& visit) {
  visit(FieldInfo{"gl.state", ""}, config.gl.state);
  visit(FieldInfo{"gl.creation", ""}, config.gl.creation);
  visit(FieldInfo{"gl.plan", ""}, config.gl.plan);
  visit(FieldInfo{"gl.autotune", ""}, config.gl.autotune);
  visit(FieldInfo{"gl.cache_dir", ""}, config.gl.cache_dir);
}

}  // namespace config_fields

/// Calls visit(FieldInfo, field&) for every field of a Config (or const Config&) in the order of
/// config.h. Fields are int, double, an enum that has enumNames(), std::string,
/// or std::vector<double>. This is
/// the one list of names and ranges: validate(), --set, --print-config and stats.json all read it.
template <class ConfigT, class Visitor>
void forEachField(ConfigT& config, Visitor&& visit) {
  config_fields::visitCamera(config, visit);
  config_fields::visitModes(config, visit);
  config_fields::visitDirect(config, visit);
  config_fields::visitFeatures(config, visit);
  config_fields::visitInitialization(config, visit);
  config_fields::visitIndirect(config, visit);
  config_fields::visitKeyframes(config, visit);
  config_fields::visitMapping(config, visit);
  config_fields::visitCalibration(config, visit);
  config_fields::visitLoop(config, visit);
  config_fields::visitGl(config, visit);
}

}  // namespace glide
