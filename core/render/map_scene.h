#pragma once

#include "render/scene_array.h"
#include "render/scene_bounds.h"
#include "render/scene_path.h"
#include "render/scene_records.h"

#include "glide/map_renderer.h"

#include <memory>
#include <span>

namespace glide {

/// Everything that MapRenderer draws, as the shaders take it, with what of it has changed since it
/// was uploaded. No GL: owned by the thread that draws.
class MapScene {
 public:
  void setStyle(const MapStyle& style);
  void setMap(std::shared_ptr<const MapView> map);
  void addFrame(const FrameResult& frame);
  void setTruth(std::span<const Pose> T_world_cam);

  const MapStyle& style() const { return style_; }
  /// Of landmarks and keyframes.
  const SceneBounds& bounds() const { return bounds_; }
  /// Whether something is not uploaded yet.
  bool isChanged() const;
  /// The GPU's copies are gone.
  void markLost();

  // What the buffers take.
  SceneArray<LandmarkRecord>& landmarks() { return landmarks_; }
  SceneArray<PoseRecord>& keyframes() { return keyframes_; }
  SceneArray<PoseRecord>& frames() { return path_.records(); }
  SceneArray<PointRecord>& covisibility() { return covisibility_; }
  SceneArray<PointRecord>& loops() { return loops_; }
  SceneArray<PointRecord>& truth() { return truth_; }
  const SceneArray<LandmarkRecord>& landmarks() const { return landmarks_; }
  const SceneArray<PoseRecord>& keyframes() const { return keyframes_; }
  const SceneArray<PoseRecord>& frames() const { return path_.records(); }
  const SceneArray<PointRecord>& covisibility() const { return covisibility_; }  ///< two a line
  const SceneArray<PointRecord>& loops() const { return loops_; }                ///< two a line
  const SceneArray<PointRecord>& truth() const { return truth_; }                ///< a polyline

 private:
  MapStyle style_;
  std::shared_ptr<const MapView> map_ = std::make_shared<MapView>();
  ScenePath path_;
  SceneBounds bounds_;
  SceneArray<LandmarkRecord> landmarks_;
  SceneArray<PoseRecord> keyframes_;
  SceneArray<PointRecord> covisibility_, loops_, truth_;
};

}  // namespace glide
