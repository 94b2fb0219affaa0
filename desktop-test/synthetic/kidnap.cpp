#include "synthetic/kidnap.h"

#include "synthetic/random.h"

namespace glide::synthetic {

namespace {

// Shares of the time before the loss: the beginning may not be mapped yet, the end is where the
// camera was last seen.
constexpr float kEarliest = 0.2F, kLatest = 0.7F;
constexpr float kBeside = 0.06F;  // of the depth, per axis
constexpr float kTurn = 0.08F;    // radians, per axis

}  // namespace

Return returnAfter(double begin_s, double depth, std::uint64_t seed) {
  Random random(mixBits(seed) ^ 0x1D);
  const auto symmetric = [&random](float size) { return random.uniform(-size, size); };
  Return back;
  back.t_s = begin_s * random.uniform(kEarliest, kLatest);
  const double x = symmetric(kBeside), y = symmetric(kBeside), z = symmetric(kBeside);
  const double yaw = symmetric(kTurn), pitch = symmetric(kTurn), roll = symmetric(kTurn);
  back.T_path_cam.q = so3Exp(Vec3d(pitch, yaw, roll));
  back.T_path_cam.t = depth * Vec3d(x, y, z);
  return back;
}

}  // namespace glide::synthetic
