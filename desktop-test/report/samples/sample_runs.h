#pragma once

#include "replay/evaluation/trajectory.h"
#include "replay/outputs/point_colors.h"
#include "replay/outputs/report_thumbnails.h"
#include "replay/outputs/run_record.h"

#include <optional>
#include <vector>

namespace glide::replay {

/// A made-up run with what a report takes of it; the same at every call.
struct SampleRun {
  RunRecord run;
  std::optional<Trajectory> truth;
  std::vector<Thumbnail> pictures;
  PointColors colors;
};

/// All that a run can have: both trackers and every reason to switch, dropped and lost frames, two
/// loops, a ground truth that stands elsewhere in another scale, and a name that wants to be
/// markup.
SampleRun sampleTour();
/// Frames, but never a map and no ground truth.
SampleRun sampleWithoutMap();
/// Tracked, but the map was given up: no keyframes, no landmarks.
SampleRun sampleGivenUp();
/// Not one frame.
SampleRun sampleWithoutFrames();

}  // namespace glide::replay
