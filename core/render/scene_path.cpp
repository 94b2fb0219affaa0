#include "render/scene_path.h"

#include "geometry/pose_conversion.h"

#include <utility>

namespace glide {
namespace {

/// Of frames that say of no tracker that it placed them.
constexpr Color kUnknownColor{0.5F, 0.5F, 0.5F, 1.0F};

const Color& colorOf(TrackerKind tracker) {
  switch (tracker) {
    case TrackerKind::direct:
      return kDirectColor;
    case TrackerKind::indirect:
      return kIndirectColor;
    case TrackerKind::none:
      break;
  }
  return kUnknownColor;
}

}  // namespace

PoseRecord poseRecord(const SE3d& T_world_cam, const PackedColor& color) {
  const Eigen::Vector3f t = T_world_cam.t.cast<float>();
  const Eigen::Quaternionf q = T_world_cam.q.cast<float>();
  return {{t.x(), t.y(), t.z()}, {q.x(), q.y(), q.z(), q.w()}, color};
}

void ScenePath::append(const FrameResult& frame, const MapView& map) {
  if (frame.state != TrackingState::tracking) {
    is_interrupted_ = true;
    return;
  }
  if (frame.map_generation != generation_) beginIn(frame.map_generation);
  Color color = colorOf(frame.tracker);
  if (is_interrupted_) color[3] = 0.0F;
  is_interrupted_ = false;
  frames_.push_back({frame.reference_keyframe,
                     frame.reference_scale,
                     fromPose(frame.T_ref_cam),
                     fromPose(frame.T_world_cam),
                     packColor(color)});
  records_.append(placed(frames_.back(), map));
}

void ScenePath::place(const MapView& map) {
  if (map.generation != generation_) beginIn(map.generation);
  std::vector<PoseRecord> records;
  records.reserve(frames_.size());
  for (const Frame& frame : frames_) records.push_back(placed(frame, map));
  records_.assign(std::move(records));
}

void ScenePath::beginIn(std::uint64_t generation) {
  generation_ = generation;
  frames_.clear();
  records_.assign({});
  is_interrupted_ = true;
}

PoseRecord ScenePath::placed(const Frame& frame, const MapView& map) const {
  const bool is_of_map = map.generation == generation_;
  const MapView::Keyframe* keyframe = is_of_map ? map.keyframe(frame.keyframe) : nullptr;
  if (keyframe == nullptr) return poseRecord(frame.T_world_cam, frame.color);
  const double growth = keyframe->scale / frame.reference_scale;
  const SE3d T_ref_cam{frame.T_ref_cam.q, growth * frame.T_ref_cam.t};
  return poseRecord(fromPose(keyframe->T_world_cam) * T_ref_cam, frame.color);
}

}  // namespace glide
