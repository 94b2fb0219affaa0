#include "replay/outputs/report_frames.h"

#include "replay/outputs/base64.h"

#include "glide/enum_names.h"

#include <algorithm>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace glide::replay {
namespace {

using Json = nlohmann::ordered_json;

constexpr double kSecondsPerNs = 1e-9;

template <class E>
Json namesOf(E any) {
  Json names = Json::array();
  for (const auto& entry : enumNames(any)) names.push_back(entry.name);
  return names;
}

/// Place of a value in namesOf its type.
template <class E>
std::uint8_t placeOf(E value) {
  const auto& entries = enumNames(value);
  const auto found = std::find_if(
      entries.begin(), entries.end(), [&](const auto& entry) { return entry.value == value; });
  return static_cast<std::uint8_t>(found - entries.begin());
}

template <class T, class Get>
std::string column(const RunRecord& run, Get get) {
  std::vector<T> numbers;
  numbers.reserve(run.frames.size());
  for (const FrameRecord& frame : run.frames) numbers.push_back(static_cast<T>(get(frame)));
  return base64Of(numbers);
}

Json identity(const RunRecord& run) {
  const std::int64_t start_ns = run.frames.empty() ? 0 : run.frames.front().result.t_ns;
  return {{"index", column<std::uint32_t>(run, [](const auto& frame) { return frame.index; })},
          {"time_s", column<float>(run, [&](const auto& frame) {
             return static_cast<double>(frame.result.t_ns - start_ns) * kSecondsPerNs;
           })}};
}

Json verdicts(const RunRecord& run) {
  const auto place = [&](auto FrameResult::*member) {
    return column<std::uint8_t>(run,
                                [&](const auto& frame) { return placeOf(frame.result.*member); });
  };
  return {{"state", place(&FrameResult::state)},
          {"tracker", place(&FrameResult::tracker)},
          {"reason", place(&FrameResult::switch_reason)},
          {"keyframe", column<std::uint8_t>(run, [](const auto& frame) {
             return frame.result.stats.keyframe;
           })}};
}

Json measurements(const RunRecord& run) {
  const auto stat = [&](auto FrameStats::*member) {
    return column<float>(run, [&](const auto& frame) { return frame.result.stats.*member; });
  };
  return {{"update_ms", stat(&FrameStats::update_ms)},
          {"mapping_ms", stat(&FrameStats::mapping_ms)},
          {"pyramid_ms", stat(&FrameStats::pyramid_ms)},
          {"precompute_ms", stat(&FrameStats::precompute_ms)},
          {"align_ms", stat(&FrameStats::align_ms)},
          {"features_ms", stat(&FrameStats::features_ms)},
          {"match_ms", stat(&FrameStats::match_ms)},
          {"pose_ms", stat(&FrameStats::pose_ms)},
          {"visible", stat(&FrameStats::visible)},
          {"inliers", stat(&FrameStats::inliers)},
          {"rms", stat(&FrameStats::rms)}};
}

}  // namespace

Json reportFrames(const RunRecord& run, const RunTrajectories& trajectories) {
  Json frames = {{"count", run.frames.size()},
                 {"names",
                  {{"state", namesOf(TrackingState{})},
                   {"tracker", namesOf(TrackerKind{})},
                   {"reason", namesOf(SwitchReason{})}}}};
  frames.update(identity(run));
  frames.update(verdicts(run));
  frames.update(measurements(run));
  frames["placed"] =
      base64Of(std::vector<std::uint8_t>(trajectories.kept.begin(), trajectories.kept.end()));
  return frames;
}

}  // namespace glide::replay
