#include "e2e/synthetic_run.h"

#include "geometry/align_sim3.h"

#include "glide/enum_names.h"

#include <gtest/gtest.h>

#include <cmath>
#include <iostream>
#include <map>
#include <optional>
#include <sstream>
#include <utility>

namespace glide::test {
namespace {

constexpr int kWidth = 320, kHeight = 240;
constexpr std::uint64_t kSeed = 7;

/// Making a scene takes a second and most tests look at the same: kept, immutable, per kind.
std::shared_ptr<const synthetic::Scene> sceneOf(synthetic::SceneKind kind) {
  static std::map<synthetic::SceneKind, std::shared_ptr<const synthetic::Scene>> scenes;
  auto& scene = scenes[kind];
  if (!scene) scene = std::make_shared<const synthetic::Scene>(synthetic::makeScene(kind, kSeed));
  return scene;
}

SE3d toSE3(const Pose& pose) {
  const auto& [x, y, z, w] = pose.q_xyzw;
  return {Eigen::Quaterniond(w, x, y, z), Vec3d(pose.t_xyz[0], pose.t_xyz[1], pose.t_xyz[2])};
}

bool isTracked(const FrameResult& result) { return result.state == TrackingState::tracking; }

}  // namespace

synthetic::SequenceOptions roomWalk(int frames) {
  synthetic::SequenceOptions options;
  options.camera = synthetic::makeCamera(DistortionModel::none, kWidth, kHeight);
  options.frames = frames;
  options.seed = kSeed;
  return options;
}

Config inlineConfig() {
  Config config;
  config.backend = Backend::cpu;
  config.execution = Execution::inline_;
  return config;
}

Playback play(const synthetic::SequenceOptions& options, Config config) {
  const auto make_luma = [](const ImageU8& image) {
    return Luma{image.row(0), image.width(), image.height(), image.stride()};
  };
  return playAs(make_luma, options, std::move(config));
}

Playback playAs(const MakeInput& make_input,
                const synthetic::SequenceOptions& options,
                Config config) {
  Playback run;
  config.camera = options.camera;
  Result<synthetic::Sequence> sequence =
      synthetic::Sequence::create(options, sceneOf(options.scene));
  Result<Session> session = Session::create(config);
  if (!sequence || !session) {
    ADD_FAILURE() << (sequence ? session.error().message : sequence.error().message);
    return run;
  }
  ImageU8 image;
  for (int i = 0; i < sequence->size(); ++i) {
    sequence->image(i, &image);
    const Result<FrameResult> result = session->update({sequence->timestamp(i), make_input(image)});
    if (!result) {
      ADD_FAILURE() << "frame " << i << ": " << result.error().message;
      break;
    }
    if (result->stats.keyframe) session->waitForMapping();
    run.results.push_back(*result);
    run.T_world_cam_truth.push_back(sequence->T_world_cam(i));
    run.map = session->map();
    run.keyframes.push_back(run.map->keyframes.size());
  }
  std::cout << summarize(run) << '\n';  // shows how much room the bounds have left
  return run;
}

double typicalDepth_m(synthetic::SceneKind kind) { return sceneOf(kind)->viewpoint.depth; }

int firstPose(const Playback& run) {
  int first = 0;
  for (const FrameResult& result : run.results) {
    if (isTracked(result)) break;
    ++first;
  }
  return first;
}

int untracked(const Playback& run) {
  int count = 0;
  for (auto i = static_cast<std::size_t>(firstPose(run)); i < run.results.size(); ++i)
    count += isTracked(run.results[i]) ? 0 : 1;
  return count;
}

double directShare(const Playback& run) {
  int tracked = 0;
  int direct = 0;
  for (const FrameResult& result : run.results) {
    tracked += isTracked(result) ? 1 : 0;
    direct += isTracked(result) && result.tracker == TrackerKind::direct ? 1 : 0;
  }
  return tracked == 0 ? 0.0 : static_cast<double>(direct) / tracked;
}

Evaluation evaluate(const Playback& run) {
  std::map<std::uint64_t, const MapView::Keyframe*> keys;
  if (run.map) {
    for (const MapView::Keyframe& keyframe : run.map->keyframes) keys[keyframe.id] = &keyframe;
  }
  std::vector<Vec3d> truth;
  std::vector<Vec3d> estimate;
  for (std::size_t i = 0; i < run.results.size(); ++i) {
    const FrameResult& result = run.results[i];
    const auto reference = keys.find(result.reference_keyframe);
    if (!isTracked(result) || reference == keys.end()) continue;
    truth.push_back(run.T_world_cam_truth[i].t);
    const MapView::Keyframe& key = *reference->second;
    const Vec3d center_in_key = toSE3(result.T_ref_cam).t * (key.scale / result.reference_scale);
    estimate.push_back(toSE3(key.T_world_cam) * center_in_key);
  }
  const std::optional<Sim3d> S = alignSim3(truth, estimate, AlignScale::estimated);
  if (!S) return {};
  double sum = 0.0;
  for (std::size_t i = 0; i < truth.size(); ++i) sum += (truth[i] - *S * estimate[i]).squaredNorm();
  return {std::sqrt(sum / static_cast<double>(truth.size())), S->s};
}

std::string summarize(const Playback& run) {
  std::ostringstream text;
  text << "first pose " << firstPose(run) << ", untracked " << untracked(run) << " of "
       << run.results.size() << ", direct share " << directShare(run) << ", ATE "
       << 1e3 * evaluate(run).ate_rmse_m << " mm";
  return text.str();
}

std::string describe(const Playback& run) {
  std::ostringstream text;
  text << summarize(run) << ';';
  for (std::size_t i = 0; i < run.results.size(); ++i) {
    const FrameResult& result = run.results[i];
    if (result.tracker == TrackerKind::direct) continue;
    text << ' ' << i << ':' << enumName(result.state) << '/' << enumName(result.switch_reason);
    if (result.state == TrackingState::initializing)
      text << '/' << enumName(result.initialization.status);
  }
  return text.str();
}

}  // namespace glide::test
