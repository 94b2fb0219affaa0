#include "replay/outputs/report_data.h"

#include "replay/outputs/base64.h"
#include "replay/outputs/map_ply.h"
#include "replay/outputs/report_frames.h"
#include "replay/outputs/report_truth.h"
#include "replay/outputs/stats_json.h"
#include "replay/outputs/summary.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <unordered_map>

namespace glide::replay {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kFormat = 1;  // of the data, for the page's own check

std::string base64OfText(const std::string& text) {
  return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
}

/// The best observed landmarks, in their order.
MapView thinned(const MapView& map) {
  std::vector<MapView::Landmark> best = map.landmarks;
  std::stable_sort(best.begin(), best.end(), [](const auto& a, const auto& b) {
    return a.observations > b.observations;
  });
  best.resize(std::min(best.size(), kMaxReportLandmarks));
  std::sort(best.begin(), best.end(), [](const auto& a, const auto& b) { return a.id < b.id; });
  MapView few;
  few.revision = map.revision;
  few.landmarks = std::move(best);
  return few;
}

Json mapJson(const MapView& map, const PointColors& colors) {
  const bool is_large = map.landmarks.size() > kMaxReportLandmarks;
  const std::string ply = mapPly(is_large ? thinned(map) : map, colors);
  return {{"landmarks", map.landmarks.size()},
          {"shown", std::min(map.landmarks.size(), kMaxReportLandmarks)},
          {"ply", base64OfText(ply)}};
}

void append(const Pose& pose, std::vector<float>* numbers) {
  for (const double number : pose.t_xyz) numbers->push_back(static_cast<float>(number));
  for (const double number : pose.q_xyzw) numbers->push_back(static_cast<float>(number));
}

Json keyframesJson(const RunRecord& run) {
  std::unordered_map<std::int64_t, std::int32_t> frame_at;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    frame_at[run.frames[i].result.t_ns] = static_cast<std::int32_t>(i);
  }
  std::vector<std::uint32_t> ids;
  std::vector<std::int32_t> frames;
  std::vector<float> poses;
  for (const MapView::Keyframe& keyframe : run.map->keyframes) {
    if (keyframe.retired) continue;
    const auto frame = frame_at.find(keyframe.t_ns);
    ids.push_back(static_cast<std::uint32_t>(keyframe.id));
    frames.push_back(frame == frame_at.end() ? -1 : frame->second);
    append(keyframe.T_world_cam, &poses);
  }
  return {{"count", ids.size()},
          {"id", base64Of(ids)},
          {"frame", base64Of(frames)},
          {"pose", base64Of(poses)}};
}

/// The two ends of each loop edge.
Json loopsJson(const MapView& map) {
  std::unordered_map<std::uint64_t, std::array<double, 3>> position;
  for (const MapView::Keyframe& keyframe : map.keyframes) {
    position[keyframe.id] = keyframe.T_world_cam.t_xyz;
  }
  std::vector<float> ends;
  for (const MapView::Loop& loop : map.loops) {
    const auto newer = position.find(loop.newer), older = position.find(loop.older);
    if (newer == position.end() || older == position.end()) continue;
    for (const auto& end : {newer, older}) {
      for (const double x : end->second) ends.push_back(static_cast<float>(x));
    }
  }
  return base64Of(ends);
}

Json truthJson(const FinishedRun& finished) {
  if (!finished.truth) return nullptr;
  const auto truth = reportTruth(*finished.truth, finished.trajectories.camera.recomposed);
  if (!truth) return nullptr;
  return {{"meters_per_unit", truth->meters_per_unit},
          {"path", base64Of(truth->path)},
          {"matched", base64Of(truth->matched)}};
}

Json picturesJson(const std::vector<Thumbnail>& pictures) {
  std::vector<std::uint32_t> frames;
  Json jpegs = Json::array();
  for (const Thumbnail& picture : pictures) {
    frames.push_back(static_cast<std::uint32_t>(picture.frame));
    jpegs.push_back(base64(picture.jpeg));
  }
  return {{"frame", base64Of(frames)}, {"jpeg", std::move(jpegs)}};
}

}  // namespace

Json reportData(const FinishedRun& finished, const std::vector<Thumbnail>& pictures) {
  const RunRecord& run = finished.run;
  Json skips = Json::array();
  for (const Skip& skip : run.skips) skips.push_back(describe(skip, run.source.listed));
  const bool has_map = finished.counts.first_pose_index.has_value();
  return {{"format", kFormat},
          {"name", run.source.name},
          {"hint", has_map ? Json(nullptr) : Json(initializationHint(run))},
          {"skips", std::move(skips)},
          {"stats", statsJson(run, finished.counts, finished.accuracy)},
          {"frames", reportFrames(run, finished.trajectories)},
          {"trajectory", tumText(finished.trajectories.camera.recomposed)},
          {"map", mapJson(*run.map, finished.colors)},
          {"keyframes", keyframesJson(run)},
          {"loops", loopsJson(*run.map)},
          {"truth", truthJson(finished)},
          {"pictures", picturesJson(pictures)}};
}

}  // namespace glide::replay
