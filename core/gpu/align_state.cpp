#include "gpu/align_state.h"

#include <algorithm>

namespace glide {
namespace {

constexpr std::int32_t kNoLevelEnded = -1;

Mat6d unpackHessian(const float* lower) {
  Mat6d H;
  for (Eigen::Index r = 0; r < 6; ++r) {
    for (Eigen::Index c = 0; c <= r; ++c) H(r, c) = H(c, r) = static_cast<double>(*lower++);
  }
  return H;
}

}  // namespace

AlignStateBuffer AlignStateBuffer::allocate() {
  return AlignStateBuffer(GlBuffer::allocate(sizeof(GpuAlignState), GL_DYNAMIC_READ));
}

void AlignStateBuffer::start(const SE3d& T_cam_ref_guess) const {
  const GpuAlignState state = initialState(T_cam_ref_guess);
  buffer_.write(&state, sizeof(state));
}

std::optional<GpuAlignState> AlignStateBuffer::finish(GpuCommands& commands) const {
  commands.barrier(GL_BUFFER_UPDATE_BARRIER_BIT);  // the state is mapped
  const GlSync fence = GlSync::insert();
  if (!fence.wait(kGpuTimeoutNs)) return std::nullopt;
  GpuAlignState state;
  if (!buffer_.read(&state, sizeof(state))) return std::nullopt;
  return state;
}

GpuAlignState initialState(const SE3d& T_cam_ref_guess) {
  const auto f = [](double value) { return static_cast<float>(value); };
  const Eigen::Quaterniond& q = T_cam_ref_guess.q;
  const Vec3d& t = T_cam_ref_guess.t;
  GpuAlignState state{};
  const float q_xyzw[4] = {f(q.x()), f(q.y()), f(q.z()), f(q.w())};
  std::copy_n(q_xyzw, 4, state.q_cam_ref);
  for (int i = 0; i < 3; ++i) state.t_cam_ref[i] = f(t[i]);
  state.photometric[0] = 1.0F;
  state.flow[0] = kNoLevelEnded;
  return state;
}

AlignResult toResult(const GpuAlignState& state) {
  const auto d = [](float value) { return static_cast<double>(value); };
  const float* q = state.q_cam_ref;
  AlignResult result;
  result.T_cam_ref.q = Eigen::Quaterniond(d(q[3]), d(q[0]), d(q[1]), d(q[2])).normalized();
  for (int i = 0; i < 3; ++i) result.T_cam_ref.t[i] = d(state.t_cam_ref[i]);
  result.H = unpackHessian(state.hessian);
  result.gain = d(state.photometric[0]);
  result.bias = d(state.photometric[1]);
  result.rms = d(state.photometric[2]);
  result.contrast = d(state.photometric[3]);
  result.points = state.counts[0];
  result.visible = state.counts[1];
  result.inliers = state.counts[2];
  static_assert(kMaxAlignLevels == 8, "AlignState::iterations holds eight levels");
  std::copy_n(state.iterations, kMaxAlignLevels, result.iterations.begin());
  result.valid = state.counts[3] == 0;
  return result;
}

}  // namespace glide
