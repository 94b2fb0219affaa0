#include "vit/vit_velocity.h"

namespace glide {
namespace {

constexpr double kSecondsPerNs = 1e-9;
// Gaps beyond this say nothing about velocity.
constexpr double kLongestStep_s = 0.5;

void addDifference(const vit_pose_data& before, vit_pose_data* now) {
  const double step_s = static_cast<double>(now->timestamp - before.timestamp) * kSecondsPerNs;
  if (!(step_s > 0.0) || step_s > kLongestStep_s) return;
  const auto rate = [&](float a, float b) {
    return static_cast<float>(static_cast<double>(b - a) / step_s);
  };
  now->vx = rate(before.px, now->px);
  now->vy = rate(before.py, now->py);
  now->vz = rate(before.pz, now->pz);
}

}  // namespace

void VitVelocity::add(const FrameResult& result, vit_pose_data* pose) {
  const bool is_another_world = result.correction || result.map_generation != map_generation_;
  if (is_another_world) forget();
  if (before_) addDifference(*before_, pose);
  before_ = *pose;
  map_generation_ = result.map_generation;
}

}  // namespace glide
