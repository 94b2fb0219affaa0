#include "vit/vit_features.h"

#include "ar/surfaces.h"

#include "geometry/camera_model.h"

#include "glide/result.h"

#include <cstdint>

namespace glide {

std::vector<vit_pose_feature> visibleFeatures(const MapView& map,
                                              const CameraIntrinsics& given,
                                              const SE3d& T_cam_world) {
  std::vector<vit_pose_feature> features;
  const Result<CameraModel> camera = CameraModel::create(map.corrected_camera.value_or(given));
  if (!camera) return features;
  for (const VisiblePoint& point : visiblePoints(map, *camera, T_cam_world)) {
    features.push_back({static_cast<std::int64_t>(map.landmarks[point.index].id),
                        static_cast<float>(point.uv.x()),
                        static_cast<float>(point.uv.y()),
                        static_cast<float>(point.p_cam.z())});
  }
  return features;
}

}  // namespace glide
