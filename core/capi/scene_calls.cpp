#include "capi/conversion.h"
#include "capi/counted.h"
#include "capi/handles.h"
#include "capi/sized_struct.h"

#include "glide/glide.h"

#include <cmath>
#include <string>
#include <vector>

using namespace glide;  // NOLINT(google-build-using-namespace): the file is the C side of it

namespace {

template <class T>
glide_status giveAll(const std::vector<T>& values, const CountedOut<T>& out) {
  return out.fill(values.size(), [&](std::size_t i) { return values[i]; });
}

}  // namespace

extern "C" {

glide_status glide_session_set_metric_scale(glide_session* session, float metres_per_unit) {
  return withSession(session, [&](AppSession& app) {
    if (!(metres_per_unit > 0.0F) || !std::isfinite(metres_per_unit))
      return refuseArgument("metres_per_unit is not a positive number");
    return app.setMetricScale(static_cast<double>(metres_per_unit));
  });
}

glide_status glide_session_set_gravity(glide_session* session, const float down[3]) {
  return withSession(session, [&](AppSession& app) {
    if (down == nullptr) return refuseArgument("down is null");
    const Vec3d down_cam = Eigen::Map<const Eigen::Vector3f>(down).cast<double>();
    if (!(down_cam.norm() > 0.0) || !down_cam.allFinite())
      return refuseArgument("down is no direction");
    return app.setGravity(down_cam);
  });
}

glide_status glide_session_set_display(glide_session* session,
                                       int32_t rotation_deg,
                                       int32_t width,
                                       int32_t height) {
  return withSession(session, [&](AppSession& app) {
    if (rotation_deg < 0 || rotation_deg > 270 || rotation_deg % 90 != 0)
      return refuseArgument("rotation_deg is none of 0, 90, 180, 270");
    if (width <= 0 || height <= 0)
      return refuseArgument("width or height of the display is not positive");
    return app.setDisplay({rotation_deg, width, height});
  });
}

glide_status glide_session_view_matrix(glide_session* session, float matrix[16]) {
  return withSession(session, [&](AppSession& app) {
    if (matrix == nullptr) return refuseArgument("matrix is null");
    return app.viewMatrix(matrix);
  });
}

glide_status glide_session_projection_matrix(glide_session* session,
                                             float near_plane,
                                             float far_plane,
                                             float matrix[16]) {
  return withSession(session, [&](AppSession& app) {
    if (matrix == nullptr) return refuseArgument("matrix is null");
    if (!(near_plane > 0.0F) || !(far_plane > near_plane) || !std::isfinite(far_plane))
      return refuseArgument("the planes are not 0 < near < far");
    return app.projectionMatrix({static_cast<double>(near_plane), static_cast<double>(far_plane)},
                                matrix);
  });
}

glide_status glide_session_point_cloud(glide_session* session,
                                       size_t capacity,
                                       glide_point* points,
                                       size_t* count) {
  return withSession(session, [&](AppSession& app) {
    const CountedOut<glide_point> out{capacity, points, count};
    if (!out.isValid()) return refuseArgument("points or count is null");
    return giveAll(app.pointCloud(), out);
  });
}

glide_status glide_session_tracked_points(glide_session* session,
                                          size_t capacity,
                                          glide_tracked_point* points,
                                          size_t* count) {
  return withSession(session, [&](AppSession& app) {
    const CountedOut<glide_tracked_point> out{capacity, points, count};
    if (!out.isValid()) return refuseArgument("points or count is null");
    return giveAll(app.trackedPoints(), out);
  });
}

glide_status glide_session_hit_test(
    glide_session* session, const float uv[2], size_t capacity, glide_hit* hits, size_t* count) {
  return withSession(session, [&](AppSession& app) {
    const CountedOut<glide_hit> out{capacity, hits, count};
    if (uv == nullptr || !out.isValid()) return refuseArgument("uv, hits or count is null");
    return giveAll(app.hitTest({static_cast<double>(uv[0]), static_cast<double>(uv[1])}), out);
  });
}

glide_status glide_anchor_create(glide_session* session, const glide_pose* pose, uint64_t* anchor) {
  return withSession(session, [&](AppSession& app) {
    if (pose == nullptr || anchor == nullptr) return refuseArgument("pose or anchor is null");
    if (!isSound(*pose))
      return refuseArgument("pose is not finite, or its quaternion is not of length one");
    return app.createAnchor(*pose, anchor);
  });
}

glide_status glide_anchor_get(glide_session* session, uint64_t anchor, glide_anchor* state) {
  return withSession(session, [&](AppSession& app) {
    if (!isWritable(state)) return refuseArgument("state is null, or its struct_size is not set");
    return app.anchor(anchor, state);
  });
}

glide_status glide_anchor_destroy(glide_session* session, uint64_t anchor) {
  return withSession(session, [&](AppSession& app) { return app.destroyAnchor(anchor); });
}

}  // extern "C"
