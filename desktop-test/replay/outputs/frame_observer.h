#pragma once

#include "replay/evaluation/accuracy.h"
#include "replay/outputs/point_colors.h"
#include "replay/outputs/run_record.h"
#include "replay/outputs/run_trajectories.h"
#include "replay/outputs/statistics.h"

#include "glide/result.h"

#include <filesystem>
#include <optional>

namespace glide::replay {

/// A frame right after the session's answer to it.
struct FrameMoment {
  const FrameRecord& record;
  const SourceFrame& frame;
  const Session& session;
};

/// A replay at its end, everything computed.
struct FinishedRun {
  const RunRecord& run;
  const RunTrajectories& trajectories;
  const FrameCounts& counts;
  const std::optional<Accuracy>& accuracy;
  const std::optional<Trajectory>& truth;  ///< of the camera, metres
  std::filesystem::path output;            ///< folder
  const PointColors& colors;
};

/// Something that looks at a replay while it runs, to make a picture, a video or a file of it.
/// Lives on the thread of the replay, within the life of its GL context.
class FrameObserver {
 public:
  virtual ~FrameObserver() = default;
  /// An error takes it out of the replay, which goes on, writes everything else and fails then.
  virtual Status onFrame(const FrameMoment& moment) = 0;
  /// Called once, after the last frame, also when the replay was interrupted; not after an error.
  virtual Status onEnd(const FinishedRun& finished) = 0;
  /// Whether a person has seen enough: the replay ends after this frame, with everything written.
  virtual bool wantsToStop() const { return false; }
};

}  // namespace glide::replay
