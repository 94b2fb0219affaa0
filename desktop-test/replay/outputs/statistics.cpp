#include "replay/outputs/statistics.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace glide::replay {
namespace {

double percentile(const std::vector<double>& sorted, double share) {
  const double rank = share * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(rank);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double weight = rank - static_cast<double>(below);
  return sorted[below] * (1.0 - weight) + sorted[above] * weight;
}

void countFrame(const FrameResult& frame, bool is_kept, FrameCounts& counts) {
  ++counts.in;
  if (frame.state == TrackingState::initializing) {
    ++counts.initializing;
  } else if (frame.state == TrackingState::lost || !is_kept) {
    ++counts.lost;
  } else {
    ++counts.tracked;
    ++(frame.tracker == TrackerKind::direct ? counts.direct : counts.indirect);
  }
}

}  // namespace

std::optional<Spread> spreadOf(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  std::sort(values.begin(), values.end());
  const double sum = std::accumulate(values.begin(), values.end(), 0.0);
  return Spread{percentile(values, 0.5),
                percentile(values, 0.95),
                values.back(),
                sum / static_cast<double>(values.size())};
}

FrameCounts countFrames(const RunRecord& run, const RunTrajectories& trajectories) {
  FrameCounts counts;
  counts.dropped = run.dropped;
  int since_first_pose = 0;
  TrackingState before = TrackingState::initializing;
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    const FrameRecord& frame = run.frames[i];
    countFrame(frame.result, trajectories.kept[i], counts);
    const bool is_tracked = frame.result.state == TrackingState::tracking;
    if (is_tracked && !counts.first_pose_index) counts.first_pose_index = frame.index;
    if (counts.first_pose_index) ++since_first_pose;
    if (is_tracked && before == TrackingState::lost) ++counts.relocalisations;
    before = frame.result.state;
  }
  if (since_first_pose > 0) {
    counts.tracked_ratio = static_cast<double>(counts.tracked) / since_first_pose;
  }
  if (counts.tracked > 0) {
    counts.direct_share = static_cast<double>(counts.direct) / counts.tracked;
  }
  return counts;
}

std::optional<Spread> stageSpread(const RunRecord& run, double FrameStats::*stage) {
  std::vector<double> values;
  for (const FrameRecord& frame : run.frames) {
    const double ms = frame.result.stats.*stage;
    if (ms > 0.0) values.push_back(ms);
  }
  return spreadOf(std::move(values));
}

std::optional<Spread> spreadWithPyramid(const RunRecord& run, double FrameStats::*stage) {
  std::vector<double> values;
  for (const FrameRecord& frame : run.frames) {
    const FrameStats& stats = frame.result.stats;
    if (stats.*stage > 0.0) values.push_back(stats.pyramid_ms + stats.*stage);
  }
  return spreadOf(std::move(values));
}

std::optional<Spread> updateSpread(const RunRecord& run, std::optional<TrackerKind> tracker) {
  std::vector<double> values;
  for (const FrameRecord& frame : run.frames) {
    if (tracker && frame.result.tracker != *tracker) continue;
    values.push_back(frame.result.stats.update_ms);
  }
  return spreadOf(std::move(values));
}

}  // namespace glide::replay
