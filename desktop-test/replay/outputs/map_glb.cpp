#include "replay/outputs/map_glb.h"

#include "replay/outputs/glb_writer.h"

#include "render/packed_color.h"

#include "glide/map_renderer.h"
#include "glide/render_types.h"

#include <utility>
#include <vector>

namespace glide::replay {
namespace {

using Primitive = GlbWriter::Primitive;

Point3f toFloat(const Vec3d& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y()), static_cast<float>(p.z())};
}

Rgb8 toRgb8(const Color& color) {
  const PackedColor packed = packColor(color);
  return {packed[0], packed[1], packed[2]};
}

std::vector<Primitive> landmarkPoints(const MapView& map, const PointColors& colors) {
  Primitive points{GlbMode::points, {}, {}, {}};
  for (const MapView::Landmark& landmark : map.landmarks) {
    const auto& p = landmark.p_world;
    points.positions.push_back(toFloat({p[0], p[1], p[2]}));
    points.colors.push_back(colors.of(landmark.id));
  }
  if (points.positions.empty()) return {};
  return {std::move(points)};
}

/// A strip for each stretch of frames that have a place in the final map.
std::vector<Primitive> trajectoryStrips(const RunRecord& run, const RunTrajectories& trajectories) {
  std::vector<Primitive> strips;
  bool is_open = false;
  auto pose = trajectories.camera.recomposed.begin();
  for (std::size_t i = 0; i < run.frames.size(); ++i) {
    if (!trajectories.kept[i]) {
      is_open = false;
      continue;
    }
    if (!is_open) strips.push_back({GlbMode::line_strip, {}, {}, {}});
    is_open = true;
    const bool is_direct = run.frames[i].result.tracker == TrackerKind::direct;
    strips.back().positions.push_back(toFloat(pose->T_world_rig.t));
    strips.back().colors.push_back(toRgb8(is_direct ? kDirectColor : kIndirectColor));
    ++pose;
  }
  std::erase_if(strips, [](const Primitive& strip) { return strip.positions.size() < 2; });
  return strips;
}

/// A frustum's eye and the corners of its image, in the camera's frame.
std::vector<Vec3d> frustumCorners(const CameraIntrinsics& camera, double depth) {
  const auto corner = [&](double u, double v) {
    return Vec3d(depth * (u - camera.cx) / camera.fx, depth * (v - camera.cy) / camera.fy, depth);
  };
  const double right = camera.width - 1.0;
  const double bottom = camera.height - 1.0;
  return {Vec3d::Zero(), corner(0, 0), corner(right, 0), corner(right, bottom), corner(0, bottom)};
}

std::vector<Primitive> keyframeFrusta(const RunRecord& run, const Estimates& estimates) {
  constexpr std::uint32_t kEdges[] = {0, 1, 0, 2, 0, 3, 0, 4, 1, 2, 2, 3, 3, 4, 4, 1};
  const std::vector<Vec3d> corners =
      frustumCorners(run.config.camera, static_cast<double>(MapStyle{}.frustum_size));
  Primitive lines{GlbMode::lines, {}, {}, {}};
  for (const auto& keyframe : estimates.keyframes) {
    const auto first = static_cast<std::uint32_t>(lines.positions.size());
    for (const Vec3d& corner : corners)
      lines.positions.push_back(toFloat(keyframe.T_world_rig * corner));
    for (const std::uint32_t vertex : kEdges) lines.indices.push_back(first + vertex);
  }
  if (lines.positions.empty()) return {};
  lines.colors.assign(lines.positions.size(), toRgb8(kIndirectColor));
  return {std::move(lines)};
}

}  // namespace

std::string mapGlb(const RunRecord& run,
                   const RunTrajectories& trajectories,
                   const PointColors& colors) {
  GlbWriter glb;
  glb.addMesh("landmarks", landmarkPoints(*run.map, colors));
  glb.addMesh("trajectory", trajectoryStrips(run, trajectories));
  glb.addMesh("keyframes", keyframeFrusta(run, trajectories.camera));
  return glb.finish({{"name", "map"},
                     {"rotation", {1.0, 0.0, 0.0, 0.0}},  // half a turn about x
                     {"extras", {{"unit", "arbitrary"}, {"revision", run.map->revision}}}});
}

}  // namespace glide::replay
