#include "track/motion_model.h"

namespace glide {
namespace {

constexpr double kSecondsPerNanosecond = 1e-9;
// A prediction further ahead than this is worse than "it stays where it is".
constexpr double kMaxPrediction_s = 0.5;

}  // namespace

std::optional<SE3d> MotionModel::predict(std::int64_t t_ns, const MapSnapshot& map) const {
  if (!last_) return std::nullopt;
  const double dt_s = static_cast<double>(t_ns - last_t_ns_) * kSecondsPerNanosecond;
  const SE3d T_last_world = last_->T_cam_world(map);
  if (dt_s > kMaxPrediction_s) return T_last_world;
  Vec6d velocity = velocity_;
  velocity.head<3>() *= last_->growth(map) / velocity_growth_;
  return SE3d::exp(velocity * dt_s) * T_last_world;
}

void MotionModel::update(std::int64_t t_ns, const AnchoredPose& pose, const MapSnapshot& map) {
  const double dt_s = static_cast<double>(t_ns - last_t_ns_) * kSecondsPerNanosecond;
  const bool has_velocity = last_.has_value() && dt_s > 0.0 && dt_s <= kMaxPrediction_s;
  if (has_velocity) {
    const SE3d T_now_last = pose.T_cam_world(map) * last_->T_cam_world(map).inverse();
    velocity_ = T_now_last.log() / dt_s;
  } else {
    velocity_.setZero();
  }
  last_ = pose;
  velocity_growth_ = pose.growth(map);
  last_t_ns_ = t_ns;
}

}  // namespace glide
