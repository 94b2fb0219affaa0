#include "render/camera_ar.h"

#include "geometry/pose_conversion.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glide::test {
namespace {

constexpr int kWidth = 400, kHeight = 300;

CameraModel makeCamera(DistortionModel distortion, std::vector<double> coefficients) {
  CameraIntrinsics camera;
  camera.width = kWidth;
  camera.height = kHeight;
  camera.fx = camera.fy = distortion == DistortionModel::kannala_brandt4 ? 120.0 : 300.0;
  camera.cx = 199.5;
  camera.cy = 149.5;
  camera.distortion = distortion;
  camera.coefficients = std::move(coefficients);
  return *CameraModel::create(camera);
}

CameraModel pinhole() { return makeCamera(DistortionModel::none, {}); }

PictureLayout layoutAtOneToOne() { return PictureLayout::fit({kWidth, kHeight}, {0, 0, 400, 300}); }

std::vector<InkShape> shapesOf(const CameraModel& camera,
                               const ArContent& content,
                               const SE3d& T_cam_world) {
  std::vector<InkShape> shapes;
  const ArLens lens{camera, layoutAtOneToOne()};
  ArInk(lens, T_cam_world).append(content, &shapes);
  return shapes;
}

SE3d ahead(double distance) { return {Eigen::Quaterniond::Identity(), Vec3d(0.0, 0.0, distance)}; }

/// Quads that are opaque: faces; shadows are not.
std::vector<InkShape> facesIn(const std::vector<InkShape>& shapes) {
  std::vector<InkShape> faces;
  for (const InkShape& shape : shapes) {
    if (shape.kind == InkShape::Kind::quad && shape.colors[0][3] == 255) faces.push_back(shape);
  }
  return faces;
}

TEST(ArLens, PlacesPointsWhereTheCameraSeesThem) {
  const CameraModel camera = makeCamera(DistortionModel::radial_tangential, {-0.2, 0.05, 0.0, 0.0});
  const ArLens lens{camera, PictureLayout::fit({kWidth, kHeight}, {0, 0, 800, 600})};
  const Vec3d p_cam(0.2, -0.1, 1.0);
  const std::optional<Vec2d> uv = camera.project(p_cam);
  const std::optional<PointPx> at = lens.project(p_cam);
  ASSERT_TRUE(uv && at);
  EXPECT_NEAR((*at)[0], 2.0 * uv->x() + 1.0, 1e-3);
  EXPECT_NEAR((*at)[1], 2.0 * uv->y() + 1.0, 1e-3);
}

TEST(ArLens, SeesNothingBehindThePinhole) {
  const CameraModel camera = pinhole();
  const ArLens lens{camera, layoutAtOneToOne()};
  EXPECT_FALSE(lens.project({0.1, 0.0, -1.0}));
  EXPECT_FALSE(lens.project({1.0, 0.0, 1e-4})) << "so far outside that lines there mean nothing";
}

TEST(ArLens, DrawsNearThingsThickerWithinLimits) {
  const CameraModel camera = pinhole();
  const ArLens lens{camera, layoutAtOneToOne()};
  EXPECT_FLOAT_EQ(lens.radiusAt({0.0, 0.0, 1.0}, 0.02), 6.0F);
  EXPECT_FLOAT_EQ(lens.radiusAt({0.0, 0.0, 2.0}, 0.02), 3.0F);
  EXPECT_LT(lens.radiusAt({0.0, 0.0, 1e-3}, 0.02), 20.0F);
  EXPECT_GT(lens.radiusAt({0.0, 0.0, 1e3}, 0.02), 0.5F);
}

TEST(CubeFaces, LookOutwardsAndSurroundTheCube) {
  for (const CubeFace& face : cubeFaces()) {
    EXPECT_GT(face.normal.dot(face.center - Vec3d(0.0, -0.5, 0.0)), 0.0);
    EXPECT_NEAR(face.right.dot(face.normal), 0.0, 1e-12);
    EXPECT_NEAR(face.down.dot(face.normal), 0.0, 1e-12);
    EXPECT_LE(face.at(0.0, 1.0).y(), 1e-12) << "below the ground";
  }
}

TEST(CubeEdges, AreTwelveSidesOfTheirFaces) {
  const std::vector<CubeEdge> edges = cubeEdges();
  EXPECT_EQ(edges.size(), 12U);
  const std::array<CubeFace, 6> faces = cubeFaces();
  for (const CubeEdge& edge : edges) {
    EXPECT_NEAR((edge.to - edge.from).norm(), 1.0, 1e-12);
    for (const std::size_t i : edge.faces) {
      const CubeFace& face = faces[i];
      EXPECT_NEAR(face.normal.dot(edge.from - face.center), 0.0, 1e-12);
      EXPECT_NEAR(face.normal.dot(edge.to - face.center), 0.0, 1e-12);
    }
  }
}

TEST(CubeShadow, IsSoftAndEnds) {
  EXPECT_GT(cubeShadow(0.0, 0.0), 0.4);
  EXPECT_LT(cubeShadow(0.6, 0.0), cubeShadow(0.5, 0.0));
  EXPECT_NEAR(cubeShadow(0.5 + kShadowReach, 0.0), 0.0, 1e-9);
  EXPECT_EQ(cubeShadow(0.0, -2.0), 0.0);
}

TEST(ArInk, PutsFartherPiecesFirst) {
  const std::vector<Pose> cubes{{{0.0, 0.1, 0.0}}, {{0.0, 0.1, 1.0}}};
  ArContent content;
  content.axes = false;
  content.cubes = cubes;
  const std::vector<InkShape> faces = facesIn(shapesOf(pinhole(), content, ahead(1.0)));
  ASSERT_GT(faces.size(), 20U);
  // The front face of the far cube is half as large as that of the near one.
  const auto size = [](const InkShape& quad) {
    return std::hypot(quad.cd[2] - quad.ab[0], quad.cd[3] - quad.ab[1]);
  };
  EXPECT_LT(size(faces.front()), 0.7F * size(faces.back()));
}

TEST(ArInk, ShowsTheFacesThatLookAtTheCamera) {
  const std::vector<Pose> cubes{{{0.0, 0.05, 0.0}}};
  ArContent content;
  content.axes = false;
  content.cubes = cubes;
  const std::size_t front = facesIn(shapesOf(pinhole(), content, ahead(1.0))).size();
  const SE3d from_above_right{Eigen::Quaterniond::Identity(), Vec3d(-0.3, 0.3, 1.0)};
  EXPECT_EQ(facesIn(shapesOf(pinhole(), content, from_above_right)).size(), 3 * front);
}

TEST(ArInk, BendsLinesAsTheLensDoes) {
  ArContent content;
  content.axis_length = 1.0F;
  const SE3d T_cam_world{Eigen::Quaterniond::Identity(), Vec3d(-0.5, 0.3, 0.8)};
  const auto bend = [&](const CameraModel& camera) {
    double most = 0.0;
    for (const InkShape& shape : shapesOf(camera, content, T_cam_world)) {
      const bool is_x_axis = shape.colors[0][0] > 200;
      if (is_x_axis)
        most = std::max(most, std::abs(static_cast<double>(shape.ab[3] - shape.ab[1])));
    }
    return most;
  };
  EXPECT_LT(bend(pinhole()), 1e-3);
  EXPECT_GT(bend(makeCamera(DistortionModel::kannala_brandt4, {0.0, 0.0, 0.0, 0.0})), 0.5);
}

TEST(ArInk, CutsOffWhatIsBehindTheCamera) {
  ArContent content;
  content.axis_length = 2.0F;
  // The z axis begins in front of the camera; the camera stands on it and looks along x.
  const SE3d T_cam_world = SE3d{Eigen::Quaterniond::Identity(), Vec3d(0.0, 0.1, -1.0)};
  const std::vector<InkShape> shapes = shapesOf(pinhole(), content, T_cam_world);
  ASSERT_FALSE(shapes.empty());
  for (const InkShape& shape : shapes) {
    for (const float value : shape.ab) EXPECT_TRUE(std::isfinite(value));
    EXPECT_GT(shape.colors[0][2], 200) << "not of the z axis";
  }
}

TEST(ArInk, ShowsNoShadowFromBelowTheGround) {
  const std::vector<Pose> cubes{{}};
  ArContent content;
  content.axes = false;
  content.cubes = cubes;
  const auto shadows = [&](double ground_y) {
    const SE3d T_cam_world{Eigen::Quaterniond::Identity(), Vec3d(0.0, ground_y, 1.0)};
    const std::vector<InkShape> shapes = shapesOf(pinhole(), content, T_cam_world);
    std::size_t quads = 0;
    for (const InkShape& shape : shapes) quads += shape.kind == InkShape::Kind::quad ? 1 : 0;
    return quads - facesIn(shapes).size();
  };
  EXPECT_GT(shadows(0.2), 100U);
  EXPECT_EQ(shadows(-0.2), 0U);
}

}  // namespace
}  // namespace glide::test
