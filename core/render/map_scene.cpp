#include "render/map_scene.h"

#include "render/scene_edges.h"

#include "geometry/pose_conversion.h"

#include <utility>
#include <vector>

namespace glide {
namespace {

std::array<float, 3> single(const std::array<double, 3>& p) {
  return {static_cast<float>(p[0]), static_cast<float>(p[1]), static_cast<float>(p[2])};
}

std::vector<LandmarkRecord> landmarkRecords(const MapView& map) {
  std::vector<LandmarkRecord> records;
  records.reserve(map.landmarks.size());
  for (const MapView::Landmark& landmark : map.landmarks)
    records.push_back({single(landmark.p_world), static_cast<float>(landmark.observations)});
  return records;
}

/// Keyframes are indirect by nature: the mapper made them of features.
std::vector<PoseRecord> keyframeRecords(const MapView& map) {
  const PackedColor color = packColor(kIndirectColor);
  std::vector<PoseRecord> records;
  for (const MapView::Keyframe& keyframe : map.keyframes) {
    if (keyframe.retired) continue;
    records.push_back(poseRecord(fromPose(keyframe.T_world_cam), color));
  }
  return records;
}

}  // namespace

void MapScene::setStyle(const MapStyle& style) {
  const bool other_edges = style.covisible_neighbors != style_.covisible_neighbors;
  style_ = style;
  if (other_edges) covisibility_.assign(covisibilityEdges(*map_, style_.covisible_neighbors));
}

void MapScene::setMap(std::shared_ptr<const MapView> map) {
  if (map == map_) return;
  map_ = std::move(map);
  landmarks_.assign(landmarkRecords(*map_));
  keyframes_.assign(keyframeRecords(*map_));
  covisibility_.assign(covisibilityEdges(*map_, style_.covisible_neighbors));
  loops_.assign(loopEdges(*map_));
  path_.place(*map_);
  bounds_ = boundsOf(landmarks_.items(), keyframes_.items());
}

void MapScene::addFrame(const FrameResult& frame) { path_.append(frame, *map_); }

void MapScene::setTruth(std::span<const Pose> T_world_cam) {
  std::vector<PointRecord> records;
  records.reserve(T_world_cam.size());
  for (const Pose& pose : T_world_cam)
    records.push_back({single(pose.t_xyz), packColor(kTruthColor)});
  truth_.assign(std::move(records));
}

bool MapScene::isChanged() const {
  return landmarks_.isChanged() || keyframes_.isChanged() || frames().isChanged() ||
         covisibility_.isChanged() || loops_.isChanged() || truth_.isChanged();
}

void MapScene::markLost() {
  landmarks_.markLost();
  keyframes_.markLost();
  path_.records().markLost();
  covisibility_.markLost();
  loops_.markLost();
  truth_.markLost();
}

}  // namespace glide
