#include "render/camera_ar.h"

#include "geometry/pose_conversion.h"

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

// Fine enough that a piece is straight through any lens, and has one place in the order.
constexpr int kAxisParts = 24;
constexpr int kFaceParts = 6;
constexpr int kEdgeParts = 6;
constexpr int kShadowParts = 14;

constexpr Color kAxisX{0.922F, 0.251F, 0.204F, 1.0F};
constexpr Color kAxisY{0.298F, 0.784F, 0.314F, 1.0F};
constexpr Color kAxisZ{0.157F, 0.478F, 0.961F, 1.0F};
constexpr double kAxisRadius = 0.016;  // of its length
constexpr double kAxisEnd = 2.2;       // radius of the ball at its end over that of the axis

constexpr Color kEdgeColor{0.878F, 0.984F, 0.984F, 1.0F};
constexpr double kEdgeRadius = 0.011;  // of the cube's edge

constexpr float kMinRadiusPx = 0.8F;
constexpr float kMaxRadius = 0.05F;  // of the picture's height: right before the lens
// What lies farther outside, in sizes of the picture, is not seen; lines to it would be inexact.
constexpr float kReach = 8.0F;

double grid(int i, int parts) { return static_cast<double>(i) / parts; }

/// A net of (parts + 1)^2 points of a surface that were projected, row by row.
class Net {
 public:
  struct Point {
    std::optional<PointPx> at;
    PackedColor color{};
    double distance = 0.0;
  };

  explicit Net(int parts) : parts_(parts) {}
  int parts() const { return parts_; }
  void add(const Point& point) { points_.push_back(point); }

  /// Calls back with each mesh whose corners are all seen: quad, and mean distance.
  template <class Use>
  void forEachMesh(Use use) const {
    for (int row = 0; row < parts_; ++row) {
      for (int column = 0; column < parts_; ++column) useMesh(row, column, use);
    }
  }

 private:
  const Point& at(int row, int column) const {
    const auto columns = static_cast<std::size_t>(parts_) + 1;
    return points_[static_cast<std::size_t>(row) * columns + static_cast<std::size_t>(column)];
  }
  template <class Use>
  void useMesh(int row, int column, Use use) const {
    const std::array<const Point*, 4> corners{
        &at(row, column), &at(row, column + 1), &at(row + 1, column), &at(row + 1, column + 1)};
    std::array<PointPx, 4> places{};
    std::array<PackedColor, 4> colors{};
    double distance = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      if (!corners[i]->at) return;
      places[i] = *corners[i]->at;
      colors[i] = corners[i]->color;
      distance += 0.25 * corners[i]->distance;
    }
    use(inkQuad(places, colors), distance);
  }

  int parts_;
  std::vector<Point> points_;
};

}  // namespace

std::optional<PointPx> ArLens::project(const Vec3d& p_cam) const {
  const std::optional<Vec2d> uv = camera.project(p_cam);
  if (!uv) return std::nullopt;
  const PointPx at = layout.place({uv->x(), uv->y()}, {camera.width(), camera.height()});
  const float reach = kReach * static_cast<float>(std::max(layout.area.width, layout.area.height));
  if (std::abs(at[0]) > reach || std::abs(at[1]) > reach) return std::nullopt;
  return at;
}

float ArLens::radiusAt(const Vec3d& p_cam, double radius) const {
  const double focal_px = camera.fx() * layout.area.width / camera.width();
  const auto radius_px = static_cast<float>(focal_px * radius / p_cam.norm());
  const float most = kMaxRadius * static_cast<float>(layout.area.height);
  return std::max(kMinRadiusPx, std::min(radius_px, most));
}

void ArInk::append(const ArContent& content, std::vector<InkShape>* shapes) {
  pieces_.clear();
  if (content.axes) addAxes(static_cast<double>(content.axis_length));
  for (const Pose& T_world_cube : content.cubes) {
    const Cube cube{T_cam_world_ * fromPose(T_world_cube), static_cast<double>(content.cube_edge)};
    addShadow(cube, shapes);  // on the ground, below everything
    addCube(cube);
  }
  std::stable_sort(pieces_.begin(), pieces_.end(), [](const Piece& a, const Piece& b) {
    return a.distance > b.distance;
  });
  for (const Piece& piece : pieces_) shapes->push_back(piece.shape);
}

void ArInk::addAxes(double length) {
  const Vec3d origin_cam = T_cam_world_ * Vec3d(Vec3d::Zero());
  const std::array<Color, 3> colors{kAxisX, kAxisY, kAxisZ};
  for (int i = 0; i < 3; ++i) {
    const PackedColor color = packColor(colors[static_cast<std::size_t>(i)]);
    const Vec3d end_cam = T_cam_world_ * Vec3d(length * Vec3d::Unit(i));
    const double radius = kAxisRadius * length;
    addLine({origin_cam, end_cam, radius, 0.0, color}, kAxisParts);
    addLinePart({end_cam, end_cam, kAxisEnd * radius, 0.0, color});
  }
}

void ArInk::addLine(const Line& line, int parts) {
  const Vec3d step = (line.to_cam - line.from_cam) / parts;
  for (int i = 0; i < parts; ++i) {
    Line part = line;
    part.from_cam = line.from_cam + i * step;
    part.to_cam = part.from_cam + step;
    addLinePart(part);
  }
}

void ArInk::addLinePart(const Line& line) {
  const std::optional<PointPx> from = lens_.project(line.from_cam);
  const std::optional<PointPx> to = lens_.project(line.to_cam);
  if (!from || !to) return;
  const Vec3d middle = 0.5 * (line.from_cam + line.to_cam);
  const float radius_px = lens_.radiusAt(middle, line.radius);
  pieces_.push_back(
      {middle.norm() - line.nearer, inkLine({*from, *to, radius_px}, line.color, line.color)});
}

bool ArInk::Cube::shows(const CubeFace& face) const {
  return inCamera(face.center).dot(T_cam_cube.q * face.normal) < 0.0;
}

void ArInk::addCube(const Cube& cube) {
  const std::array<CubeFace, 6> faces = cubeFaces();
  for (const CubeFace& face : faces) {
    if (cube.shows(face)) addFace(cube, face);
  }
  const double piece = cube.edge / kFaceParts;
  for (const CubeEdge& edge : cubeEdges()) {
    if (!cube.shows(faces[edge.faces[0]]) && !cube.shows(faces[edge.faces[1]])) continue;
    addLine({cube.inCamera(edge.from),
             cube.inCamera(edge.to),
             kEdgeRadius * cube.edge,
             piece,
             packColor(kEdgeColor)},
            kEdgeParts);
  }
}

void ArInk::addFace(const Cube& cube, const CubeFace& face) {
  Net net(kFaceParts);
  for (int row = 0; row <= kFaceParts; ++row) {
    for (int column = 0; column <= kFaceParts; ++column) {
      const Vec3d point = face.at(grid(column, kFaceParts), grid(row, kFaceParts));
      const Vec3d p_cam = cube.inCamera(point);
      net.add({lens_.project(p_cam), packColor(cubeColor(point, face.normal)), p_cam.norm()});
    }
  }
  net.forEachMesh([this](const InkShape& quad, double distance) {
    pieces_.push_back({distance, quad});
  });
}

void ArInk::addShadow(const Cube& cube, std::vector<InkShape>* shapes) const {
  const bool from_below = cube.T_cam_cube.inverse().t.y() >= 0.0;
  if (from_below) return;
  const double side = 1.0 + 2.0 * kShadowReach;
  Net net(kShadowParts);
  for (int row = 0; row <= kShadowParts; ++row) {
    for (int column = 0; column <= kShadowParts; ++column) {
      const double x = side * (grid(column, kShadowParts) - 0.5);
      const double z = side * (grid(row, kShadowParts) - 0.5);
      const auto dark = static_cast<float>(cubeShadow(x, z));
      const Vec3d p_cam = cube.inCamera({x, 0.0, z});
      net.add({lens_.project(p_cam), packColor({0.0F, 0.0F, 0.0F, dark}), p_cam.norm()});
    }
  }
  net.forEachMesh([shapes](const InkShape& quad, double) { shapes->push_back(quad); });
}

}  // namespace glide
