#pragma once

#include "render/camera_cube.h"
#include "render/camera_ink.h"

#include "geometry/camera_model.h"
#include "geometry/lie.h"

#include "glide/camera_renderer.h"

#include <optional>
#include <vector>

namespace glide {

/// A camera's lens over a rectangle of the framebuffer.
struct ArLens {
  const CameraModel& camera;
  PictureLayout layout;

  /// Nothing where the lens does not see the point, or far outside of the picture.
  std::optional<PointPx> project(const Vec3d& p_cam) const;
  /// Radius, px, of a thing of that radius, scene units, at a point.
  float radiusAt(const Vec3d& p_cam, double radius) const;
};

/// AR content as shapes over a picture: lines and faces are cut into pieces, each of whose corners
/// goes through the lens, and the pieces are put in order, the farthest first. Pieces that the lens
/// does not see are left out.
class ArInk {
 public:
  ArInk(const ArLens& lens, const SE3d& T_cam_world) : lens_(lens), T_cam_world_(T_cam_world) {}

  /// Appends what is seen of the content.
  void append(const ArContent& content, std::vector<InkShape>* shapes);

 private:
  /// A shape and how far it is from the camera, scene units.
  struct Piece {
    double distance = 0.0;
    InkShape shape;
  };
  /// In the camera's axes, scene units.
  struct Line {
    Vec3d from_cam, to_cam;
    double radius = 0.0;
    double nearer = 0.0;  ///< by how much it lies in front of the faces that it bounds
    PackedColor color{};
  };
  /// A cube in the camera's axes.
  struct Cube {
    SE3d T_cam_cube;
    double edge = 0.0;  ///< scene units
    /// Of a point in units of the edge.
    Vec3d inCamera(const Vec3d& p_cube) const { return T_cam_cube * Vec3d(edge * p_cube); }
    bool shows(const CubeFace& face) const;
  };

  void addAxes(double length);
  void addLine(const Line& line, int parts);
  void addLinePart(const Line& line);
  void addCube(const Cube& cube);
  void addFace(const Cube& cube, const CubeFace& face);
  void addShadow(const Cube& cube, std::vector<InkShape>* shapes) const;

  const ArLens& lens_;
  SE3d T_cam_world_;
  std::vector<Piece> pieces_;
};

}  // namespace glide
