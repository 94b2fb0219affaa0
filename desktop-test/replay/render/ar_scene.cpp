#include "replay/render/ar_scene.h"

#include "ar/surfaces.h"

#include "geometry/pose_conversion.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace glide::replay {
namespace {

constexpr std::size_t kMostCubes = 6;
constexpr double kEdgeShare = 0.06;  // of the distance of the first place: a tea caddy on a table
constexpr double kApart = 2.5;       // edges between two cubes
constexpr double kSteepest = 0.87;   // cosine: what leans more than 30 degrees is no place
constexpr int kPlanePoints = 6;      // landmarks that a place rests on, at least
constexpr int kColumns = 15,
              kRows = 10;         // of pixels that are tried, in the lower half of the image
constexpr double kMargin = 0.15;  // of the image's width at its sides
// A table that several pixels show is no accident of a few landmarks.
constexpr int kSupporters = 5;         // pixels
constexpr double kSameHeight = 0.012;  // of the distance
constexpr double kSameSlope = 0.97;    // cosine, 14 degrees

/// What one pixel shows: a place on a surface that is not steep.
struct Place {
  Vec3d p_world;
  Vec3d down;  ///< into the surface
  double distance = 0.0;
};

bool isSameSurface(const Place& a, const Place& b) {
  return std::abs((b.p_world - a.p_world).dot(a.down)) < kSameHeight * a.distance &&
         b.down.dot(a.down) > kSameSlope;
}

/// Where the image is tried, the middle of the lowest row first.
std::vector<Vec2d> pixelsToTry(const CameraIntrinsics& camera) {
  std::vector<Vec2d> pixels;
  for (int row = 0; row < kRows; ++row) {
    const double v = camera.height * (0.95 - 0.45 * row / kRows);
    for (int column = 0; column < kColumns; ++column) {
      const int side = (column + 1) / 2 * (column % 2 == 0 ? 1 : -1);
      const double share = 0.5 + (1.0 - 2.0 * kMargin) * side / (kColumns - 1);
      pixels.emplace_back(share * camera.width, v);
    }
  }
  return pixels;
}

std::vector<Place> placesInView(const MapView& map,
                                const CameraModel& camera,
                                const SE3d& T_world_cam) {
  std::vector<Place> places;
  const std::vector<VisiblePoint> visible = visiblePoints(map, camera, T_world_cam.inverse());
  for (const Vec2d& uv : pixelsToTry(camera.intrinsics())) {
    const std::vector<SurfaceHit> hits = hitTest(visible, camera, uv);
    if (hits.empty() || hits.front().points < kPlanePoints) continue;
    const SE3d T_world_hit = T_world_cam * hits.front().T_cam_hit;
    const Vec3d down = T_world_hit.q * Vec3d::UnitY();
    if (down.y() > kSteepest) places.push_back({T_world_hit.t, down, hits.front().distance});
  }
  return places;
}

/// The pose there, upright on the surface that its neighbours show, too; nothing when too few do.
std::optional<SE3d> standingAt(const Place& place, const std::vector<Place>& places) {
  Vec3d down = Vec3d::Zero();
  int supporters = 0;
  for (const Place& other : places) {
    if (!isSameSurface(place, other)) continue;
    down += other.down;
    ++supporters;
  }
  if (supporters < kSupporters) return std::nullopt;
  return SE3d{Eigen::Quaterniond::FromTwoVectors(Vec3d::UnitY(), down), place.p_world};
}

}  // namespace

void ArScene::show(const FrameResult& frame, const MapView& map) {
  anchors_.follow(map);
  forgetGone();
  const bool is_tracked = frame.state == TrackingState::tracking;
  if (is_tracked && frame.stats.keyframe && ids_.size() < kMostCubes) placeOne(frame, map);
}

/// Cubes of a map that is gone take no room from those of the next.
void ArScene::forgetGone() {
  std::erase_if(ids_, [&](std::uint64_t id) {
    const std::optional<Anchors::State> state = anchors_.state(id);
    if (state && state->is_tracked) return false;
    anchors_.destroy(id);
    return true;
  });
}

void ArScene::placeOne(const FrameResult& frame, const MapView& map) {
  const std::vector<Place> places = placesInView(map, camera_, fromPose(frame.T_world_cam));
  for (const Place& place : places) {
    const std::optional<SE3d> T_world_cube = standingAt(place, places);
    if (!T_world_cube || !isFree(place.p_world)) continue;
    const std::optional<std::uint64_t> id = anchors_.create(*T_world_cube, map);
    if (!id) return;
    if (ids_.empty()) edge_ = kEdgeShare * place.distance;
    ids_.push_back(*id);
    return;
  }
}

bool ArScene::isFree(const Vec3d& p_world) const {
  return std::all_of(ids_.begin(), ids_.end(), [&](std::uint64_t id) {
    const std::optional<Anchors::State> state = anchors_.state(id);
    return !state || (state->T_world_anchor.t - p_world).norm() > kApart * edge_;
  });
}

std::vector<Pose> ArScene::cubes() const {
  std::vector<Pose> poses;
  for (const std::uint64_t id : ids_) {
    const std::optional<Anchors::State> state = anchors_.state(id);
    if (state && state->is_tracked) poses.push_back(toPose(state->T_world_anchor));
  }
  return poses;
}

}  // namespace glide::replay
