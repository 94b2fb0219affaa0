#include "report/samples/sample_room.h"

#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <random>

namespace glide::replay {
namespace {

constexpr double kTurn = 6.283185307179586;
constexpr double kRounds = 1.06;                 // the end sees what the start saw
constexpr double kRadius = 1.7, kBob = 0.12;     // m, of the path
constexpr double kFloor = 0.9, kCeiling = -1.3;  // m, y points down
constexpr double kHalfRoom = 3.1, kHalfBlock = 0.45;
constexpr int kFloorPoints = 700, kWallPoints = 350, kBlockPoints = 500;
const Vec3d kMiddle(0.0, 0.25, kRadius);

/// Numbers from -1 to 1, the same with every standard library.
class Dice {
 public:
  double operator()() { return 2.0 * static_cast<double>(engine_()) / 4294967295.0 - 1.0; }

 private:
  std::mt19937 engine_{7};
};

SE3d lookingAt(const Vec3d& target, const Vec3d& from) {
  const Vec3d forward = (target - from).normalized();
  const Vec3d right = Vec3d(0, 1, 0).cross(forward).normalized();
  Mat3d R_world_cam;
  R_world_cam << right, forward.cross(right), forward;
  return {Eigen::Quaterniond(R_world_cam), from};
}

void addWalls(Dice& dice, std::vector<Vec3d>* points) {
  for (int wall = 0; wall < 4; ++wall) {
    for (int i = 0; i < kWallPoints; ++i) {
      const double along = kHalfRoom * dice(), side = wall % 2 == 0 ? kHalfRoom : -kHalfRoom;
      const double y = 0.5 * (kFloor + kCeiling) + 0.5 * (kFloor - kCeiling) * dice();
      const Vec3d corner = wall < 2 ? Vec3d(along, y, side) : Vec3d(side, y, along);
      points->push_back(corner + Vec3d(0, 0, kRadius));
    }
  }
}

cv::Scalar colorAt(const Vec3d& p_world) {
  const double hue = std::atan2(p_world.x(), p_world.z() - kRadius);
  return {150 + 70 * std::cos(hue), 140 + 60 * std::cos(hue + 2), 130 + 60 * std::cos(hue + 4)};
}

}  // namespace

std::vector<SE3d> sampleTourPoses(int count) {
  std::vector<SE3d> poses;
  for (int i = 0; i < count; ++i) {
    const double angle = kRounds * kTurn * i / count;
    const Vec3d from(
        -kRadius * std::sin(angle), kBob * std::sin(3 * angle), kRadius * (1.0 - std::cos(angle)));
    poses.push_back(lookingAt(kMiddle, from));
  }
  return poses;
}

std::vector<MapView::Landmark> sampleRoom() {
  Dice dice;
  std::vector<Vec3d> points;
  for (int i = 0; i < kFloorPoints; ++i) {
    points.emplace_back(kHalfRoom * dice(), kFloor, kRadius + kHalfRoom * dice());
  }
  addWalls(dice, &points);
  for (int i = 0; i < kBlockPoints; ++i) {
    Vec3d p(dice(), dice(), dice());
    p /= p.cwiseAbs().maxCoeff();
    points.push_back(kMiddle + Vec3d(kHalfBlock * p.x(), 0.65 * p.y(), kHalfBlock * p.z()));
  }
  std::vector<MapView::Landmark> landmarks;
  for (const Vec3d& p : points) {
    MapView::Landmark landmark;
    landmark.id = landmarks.size();
    landmark.p_world = {p.x(), p.y(), p.z()};
    landmark.observations = 2 + static_cast<int>(landmarks.size() % 9);
    landmarks.push_back(landmark);
  }
  return landmarks;
}

CameraIntrinsics sampleCamera() {
  return {480, 300, 330.0, 330.0, 239.5, 149.5, DistortionModel::none, {}};
}

SampleView sampleView(const std::vector<MapView::Landmark>& landmarks, const SE3d& T_world_cam) {
  const CameraIntrinsics camera = sampleCamera();
  const SE3d T_cam_world = T_world_cam.inverse();
  cv::Mat rgb(camera.height, camera.width, CV_8UC3, cv::Scalar(46, 52, 64));
  SampleView view;
  for (const MapView::Landmark& landmark : landmarks) {
    const Vec3d p_world(landmark.p_world.data());
    const Vec3d p_cam = T_cam_world * p_world;
    if (p_cam.z() < 0.2) continue;
    const double u = camera.fx * p_cam.x() / p_cam.z() + camera.cx;
    const double v = camera.fy * p_cam.y() / p_cam.z() + camera.cy;
    if (u < 0 || v < 0 || u > camera.width - 1 || v > camera.height - 1) continue;
    const int size = std::clamp(static_cast<int>(9.0 / p_cam.z()), 2, 9);
    cv::circle(rgb, cv::Point2d(u, v), size, colorAt(p_world), cv::FILLED, cv::LINE_AA);
    view.points.push_back({landmark.id, static_cast<float>(u), static_cast<float>(v), 0.0F, true});
  }
  view.frame.image.resize(camera.width, camera.height);  // looked at for its size only
  view.frame.color = {camera.width, camera.height, {}};
  view.frame.color.rgb.assign(rgb.datastart, rgb.dataend);
  return view;
}

}  // namespace glide::replay
