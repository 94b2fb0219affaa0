#include "track/point_reporter.h"

#include <optional>

namespace glide {

PointReporter::PointReporter(const Config::Direct& config, const CameraModel& camera)
    : camera_(camera), residuals_(config, camera) {}

void PointReporter::reportMatches(const Frame& frame,
                                  const TrackedFrame& tracked,
                                  std::vector<TrackedPoint>* points) const {
  const CameraModel& camera = frame.map->cameraOr(camera_);
  for (std::size_t i = 0; i < tracked.landmarks.size(); ++i) {
    const LandmarkId id = tracked.landmarks[i];
    const MapSnapshot::LandmarkEntry* landmark = frame.map->landmark(id);
    if (landmark == nullptr) continue;
    const Eigen::Vector2f& uv = tracked.features->feature(i).uv;
    const std::optional<Vec2d> projected = camera.project(tracked.T_cam_world * landmark->p_world);
    if (!projected) continue;
    const double distance = (uv.cast<double>() - *projected).norm();
    points->push_back({id.value, uv.x(), uv.y(), static_cast<float>(distance), true});
  }
}

void PointReporter::setReference(const ImageViewU8& luma, const DirectTracker& tracker) {
  residuals_.setReference(luma, tracker.referencePoints());
}

void PointReporter::reportAlignment(const ImageViewU8& luma,
                                    const DirectTracker& tracker,
                                    std::vector<TrackedPoint>* points) {
  for (const PointResiduals::Residual& seen : residuals_.evaluate(luma, tracker.alignment())) {
    const Eigen::Vector2f uv = seen.uv.cast<float>();
    points->push_back({tracker.referenceLandmarks()[seen.point].value,
                       uv.x(),
                       uv.y(),
                       static_cast<float>(seen.rms),
                       seen.is_inlier});
  }
}

}  // namespace glide
