#pragma once

#include "replay/outputs/run_record.h"
#include "replay/outputs/run_trajectories.h"

#include <optional>
#include <vector>

namespace glide::replay {

/// Spread of a series. Percentiles interpolate linearly between the two nearest ranks.
struct Spread {
  double median = 0.0, p95 = 0.0, max = 0.0, mean = 0.0;
};
/// Nothing for an empty series.
std::optional<Spread> spreadOf(std::vector<double> values);

/// Frames of a run by what became of them: in = tracked + lost + initializing.
struct FrameCounts {
  int in = 0;
  int tracked = 0;  ///< direct + indirect: the poses of trajectory.tum
  int direct = 0;
  int indirect = 0;
  int lost = 0;  ///< frames of a map that was given up later are among them
  int initializing = 0;
  int dropped = 0;
  std::optional<int> first_pose_index;  ///< FrameRecord::index of the first tracked frame
  double tracked_ratio = 0.0;           ///< tracked / frames since the first pose; 0 without one
  double direct_share = 0.0;            ///< direct / tracked; 0 without one
  int relocalisations = 0;              ///< tracked frames that follow a lost one
};
FrameCounts countFrames(const RunRecord& run, const RunTrajectories& trajectories);

/// Times of one stage over the frames in which it ran.
std::optional<Spread> stageSpread(const RunRecord& run, double FrameStats::*stage);

/// Time of the pyramid and a stage together over the frames in which the stage ran: the paper's
/// sums Pre (precompute) and Trk (align).
std::optional<Spread> spreadWithPyramid(const RunRecord& run, double FrameStats::*stage);

/// Time of the tracking call over all frames, or over those that one tracker placed.
std::optional<Spread> updateSpread(const RunRecord& run, std::optional<TrackerKind> tracker);

}  // namespace glide::replay
