#pragma once

#include "synthetic/sequence.h"

#include "geometry/lie.h"

#include "glide/session.h"

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace glide::test {

/// What a session answered to a rendered sequence, frame by frame, with the truth.
struct Playback {
  std::vector<FrameResult> results;
  std::vector<SE3d> T_world_cam_truth;
  std::vector<std::size_t> keyframes;  ///< in the map after each frame
  std::shared_ptr<const MapView> map;  ///< after the last frame
};

/// A room seen by a 320x240 pinhole camera in a moving hand, without noise: what the tests vary.
synthetic::SequenceOptions roomWalk(int frames);

/// The defaults on the CPU with mapping inside of update().
Config inlineConfig();

/// Renders the sequence and feeds it; keyframes are waited for. Sets the camera of the config.
/// Reports a test failure and stops where the session refuses.
Playback play(const synthetic::SequenceOptions& options, Config config);

/// How an image is handed to the session.
using MakeInput = std::function<decltype(FrameInput::image)(const ImageU8&)>;
/// The same with images that are not handed over as pixels.
Playback playAs(const MakeInput& make_input,
                const synthetic::SequenceOptions& options,
                Config config);

/// Depth the scene is seen at, metres.
double typicalDepth_m(synthetic::SceneKind kind);

/// Index of the first tracked frame; the number of frames when there is none.
int firstPose(const Playback& run);
/// Frames after the first pose that are not tracked.
int untracked(const Playback& run);
/// Frames of the direct tracker over all tracked frames.
double directShare(const Playback& run);

/// Final poses, recomposed from the keyframes of the last map, in metres of the truth after the
/// best similarity.
struct Evaluation {
  double ate_rmse_m = 1e9;
  double metres_per_unit = 0.0;
};
Evaluation evaluate(const Playback& run);

/// The numbers above in one line.
std::string summarize(const Playback& run);

/// For failure messages: the untracked and indirect frames with their reasons.
std::string describe(const Playback& run);

}  // namespace glide::test
