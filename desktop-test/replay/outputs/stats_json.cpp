#include "replay/outputs/stats_json.h"

#include "glide/config_fields.h"
#include "glide/enum_names.h"
#include "glide/version.h"

#include <string>
#include <sys/resource.h>
#include <type_traits>

namespace glide::replay {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kSchema = 1;

template <class T>
Json orNull(const std::optional<T>& value) {
  return value ? Json(*value) : Json(nullptr);
}

Json spreadJson(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"median", spread->median},
          {"p95", spread->p95},
          {"max", spread->max},
          {"mean", spread->mean}};
}

Json shortSpreadJson(const std::optional<Spread>& spread) {
  if (!spread) return nullptr;
  return {{"median", spread->median}, {"p95", spread->p95}};
}

Json sourceJson(const SourceInfo& source) {
  return {{"kind", source.kind},
          {"path", source.path.string()},
          {"frames", source.frames},
          {"width", source.width},
          {"height", source.height}};
}

Json framesJson(const FrameCounts& counts) {
  return {{"in", counts.in},
          {"tracked", counts.tracked},
          {"direct", counts.direct},
          {"indirect", counts.indirect},
          {"lost", counts.lost},
          {"initializing", counts.initializing},
          {"dropped", counts.dropped}};
}

Json timesJson(const RunRecord& run) {
  const auto stage = [&](double FrameStats::*member) {
    return shortSpreadJson(stageSpread(run, member));
  };
  return {{"update", spreadJson(updateSpread(run, std::nullopt))},
          {"direct", spreadJson(updateSpread(run, TrackerKind::direct))},
          {"indirect", spreadJson(updateSpread(run, TrackerKind::indirect))},
          {"stages",
           {{"pyramid", stage(&FrameStats::pyramid_ms)},
            {"precompute", stage(&FrameStats::precompute_ms)},
            {"align", stage(&FrameStats::align_ms)},
            {"features", stage(&FrameStats::features_ms)},
            {"match", stage(&FrameStats::match_ms)},
            {"pose", stage(&FrameStats::pose_ms)}}}};
}

/// The session times its GL work on the CPU around one fence and one readback: "sync".
Json gpuJson(const RunRecord& run) {
  const BackendInfo& backend = run.backend;
  const bool is_gl = backend.backend == Backend::gles;
  const auto glText = [&](const std::string& text) { return is_gl ? Json(text) : Json(nullptr); };
  return {{"backend", enumName(backend.backend)},
          {"vendor", glText(backend.vendor)},
          {"renderer", glText(backend.renderer)},
          {"version", glText(backend.version)},
          {"pre_ms", shortSpreadJson(spreadWithPyramid(run, &FrameStats::precompute_ms))},
          {"trk_ms", shortSpreadJson(spreadWithPyramid(run, &FrameStats::align_ms))},
          {"timer", enumName(backend.timer)}};
}

Json mapJson(const RunRecord& run, const FrameCounts& counts) {
  int keyframes = 0;
  for (const MapView::Keyframe& keyframe : run.map->keyframes) keyframes += !keyframe.retired;
  const auto& corrected = run.map->corrected_camera;
  return {{"keyframes", keyframes},
          {"landmarks", run.map->landmarks.size()},
          {"loops_closed", run.map->loops.size()},
          {"relocalisations", counts.relocalisations},
          {"resets", run.map->resets},
          {"corrected_k1", corrected ? Json(corrected->coefficients.front()) : Json(nullptr)}};
}

Json accuracyJson(const std::optional<Accuracy>& accuracy) {
  if (!accuracy) return nullptr;
  const auto& final_error = accuracy->final_error;
  const auto& relative = accuracy->relative_error;
  const auto rmse = [](const std::optional<AbsoluteError>& error) {
    return error ? Json(error->rmse_m) : Json(nullptr);
  };
  return {{"gt", accuracy->truth_file},
          {"matched", accuracy->matched},
          {"ate_rmse_m", rmse(final_error)},
          {"ate_max_m", final_error ? Json(final_error->max_m) : Json(nullptr)},
          {"ate_live_rmse_m", rmse(accuracy->live_error)},
          {"ate_keyframes_rmse_m", rmse(accuracy->keyframe_error)},
          {"scale", final_error ? Json(final_error->scale) : Json(nullptr)},
          {"rpe_trans_m", relative ? Json(relative->trans_m) : Json(nullptr)},
          {"rpe_rot_deg", relative ? Json(relative->rot_deg) : Json(nullptr)}};
}

double peakRssMb() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return static_cast<double>(usage.ru_maxrss) / 1024.0;  // Linux counts in KiB
}

Json mapMb(const RunRecord& run) {
  constexpr double kBytesPerMb = 1024.0 * 1024.0;
  if (run.map_file_bytes == 0) return nullptr;
  return static_cast<double>(run.map_file_bytes) / kBytesPerMb;
}

std::string versionText() {
  return std::to_string(GLIDE_VERSION_MAJOR) + "." + std::to_string(GLIDE_VERSION_MINOR) + "." +
         std::to_string(GLIDE_VERSION_PATCH);
}

}  // namespace

Json configJson(const Config& config) {
  Json root = Json::object();
  forEachField(config, [&](const FieldInfo& field, const auto& value) {
    const std::size_t dot = field.name.find('.');
    const bool is_nested = dot != std::string_view::npos;
    Json& parent = is_nested ? root[std::string(field.name.substr(0, dot))] : root;
    Json& target = parent[std::string(is_nested ? field.name.substr(dot + 1) : field.name)];
    if constexpr (std::is_enum_v<std::decay_t<decltype(value)>>) {
      target = enumName(value);
    } else {
      target = value;
    }
  });
  return root;
}

Json statsJson(const RunRecord& run,
               const FrameCounts& counts,
               const std::optional<Accuracy>& accuracy) {
  Json stats;
  stats["schema"] = kSchema;
  stats["version"] = versionText();
  stats["source"] = sourceJson(run.source);
  stats["config"] = configJson(run.config);
  stats["frames"] = framesJson(counts);
  stats["tracked_ratio"] = counts.first_pose_index ? Json(counts.tracked_ratio) : Json(nullptr);
  stats["direct_share"] = counts.tracked > 0 ? Json(counts.direct_share) : Json(nullptr);
  stats["first_pose_index"] = orNull(counts.first_pose_index);
  stats["time_ms"] = timesJson(run);
  stats["gpu"] = gpuJson(run);
  stats["map"] = mapJson(run, counts);
  stats["accuracy"] = accuracyJson(accuracy);
  stats["pace"] = run.pace == Pace::lossless ? "lossless" : "realtime";
  stats["deterministic"] = run.config.execution == Execution::inline_;
  stats["interrupted"] = run.interrupted;
  stats["memory"] = {{"peak_rss_mb", peakRssMb()}, {"map_mb", mapMb(run)}};
  stats["startup_ms"] = run.startup_ms;
  stats["wall_s"] = run.wall_s;
  return stats;
}

}  // namespace glide::replay
