#include "photometric/reference_cache.h"

#include <cmath>
#include <limits>

namespace glide {
namespace {

ReferencePoint projectPoint(const CameraModel& camera, const Vec3d& p_ref) {
  ReferencePoint point;
  point.p_ref = p_ref;
  if (const std::optional<Projection> projection = camera.projectWithJacobian(p_ref)) {
    point.uv = projection->uv;
    point.J_uv_twist << projection->J_uv_point, -projection->J_uv_point * skew(p_ref);
  } else {
    point.uv.setConstant(std::numeric_limits<double>::quiet_NaN());
    point.J_uv_twist.setZero();
  }
  return point;
}

/// Whether the patch and its central differences stay inside along one axis.
bool isPatchInside(double u, int half, int size) { return u >= half + 1 && u < size - half - 2; }

/// Collects the points that are valid at a level, `scale` = 2^-l, and their patch sites.
void collectPoints(const ImageF& image,
                   const std::vector<ReferencePoint>& points,
                   double scale,
                   int half,
                   ReferenceLevel* level) {
  level->point.clear();
  level->sites.clear();
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Vec2d uv = scale * points[i].uv;
    if (!isPatchInside(uv.x(), half, image.width())) continue;
    if (!isPatchInside(uv.y(), half, image.height())) continue;
    level->point.push_back(i);
    level->sites.push_back(PatchSite::around(uv.x(), uv.y(), half));
  }
}

void cacheNormals(const std::vector<ReferencePoint>& points, double scale, ReferenceLevel* level) {
  level->normals.resize(level->point.size());
  level->H_all.setZero();
  for (std::size_t slot = 0; slot < level->point.size(); ++slot) {
    const Mat26d J = scale * points[level->point[slot]].J_uv_twist;
    const PatchMoments& moments = level->moments[slot];
    const Vec3d gxx_gxy_gyy(moments.gx_gx, moments.gx_gy, moments.gy_gy);
    level->normals[slot] = makePointNormal(J, gxx_gxy_gyy);
    level->H_all += unpackHessian(level->normals[slot].H);
  }
}

}  // namespace

void ReferenceCache::reserve(int levels_count, int points_count, const PatchLayout& layout) {
  const auto count = static_cast<std::size_t>(points_count);
  points.reserve(count);
  levels.resize(static_cast<std::size_t>(levels_count));
  for (ReferenceLevel& level : levels) {
    level.point.reserve(count);
    level.sites.reserve(count);
    level.moments.reserve(count);
    level.blocks.reserve(count * layout.blockSize());
    level.normals.reserve(count);
  }
}

void buildReferenceCache(const Pyramid& pyramid,
                         const CameraModel& camera,
                         const PatchLayout& layout,
                         std::span<const AlignPoint> points_ref,
                         ReferenceCache* out) {
  out->points.clear();
  for (const AlignPoint& point : points_ref) {
    out->points.push_back(projectPoint(camera, point.p_ref));
  }
  out->levels.resize(pyramid.levels.size());
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    const ImageF& image = pyramid.levels[l];
    const double scale = std::ldexp(1.0, -static_cast<int>(l));
    ReferenceLevel& level = out->levels[l];
    collectPoints(image, out->points, scale, layout.size / 2, &level);
    level.moments.resize(level.point.size());
    level.blocks.resize(level.point.size() * layout.blockSize());
    cachePatches(image, layout, level.sites, {level.blocks.data(), level.moments.data()});
    cacheNormals(out->points, scale, &level);
  }
}

}  // namespace glide
