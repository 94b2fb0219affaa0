#include "gpu/align_loop.h"

#include <algorithm>

namespace glide {
namespace {

/// A frame takes milliseconds on a phone and a second on the slowest software driver; after this
/// the GPU hangs.
constexpr std::uint64_t kTimeoutNs = 20'000'000'000;

constexpr std::int32_t kNoLevelEnded = -1;

// Uniform locations of both kernels.
constexpr GLint kPointCount = 0;
constexpr GLint kLevel = 1;

Mat6d unpackHessian(const float* lower) {
  Mat6d H;
  for (Eigen::Index r = 0; r < 6; ++r) {
    for (Eigen::Index c = 0; c <= r; ++c) H(r, c) = H(c, r) = static_cast<double>(*lower++);
  }
  return H;
}

}  // namespace

Result<AlignLoop> AlignLoop::create(const GpuAlignSpec& spec) {
  const ShaderDefines defines = alignDefines(spec);
  Result<ComputeProgram> residual = ComputeProgram::create("align_residual.comp", defines);
  if (!residual) return residual.error();
  Result<ComputeProgram> solve = ComputeProgram::create("align_solve.comp", defines);
  if (!solve) return solve.error();
  return AlignLoop(std::move(*residual), std::move(*solve), spec);
}

AlignLoop::AlignLoop(ComputeProgram residual, ComputeProgram solve, const GpuAlignSpec& spec)
    : residual_(std::move(residual)),
      solve_(std::move(solve)),
      group_size_(spec.tuning.group_size),
      max_iterations_(spec.direct.max_iterations) {
  const std::int64_t points = spec.direct.max_points;
  const auto bytes = [&](std::size_t each) { return points * static_cast<std::int64_t>(each); };
  sums_ = GlBuffer::allocate(bytes(sizeof(GpuPointSums)), GL_DYNAMIC_COPY);
  weights_ = GlBuffer::allocate(bytes(sizeof(GpuPointWeight)), GL_DYNAMIC_COPY);
  state_ = GlBuffer::allocate(sizeof(GpuAlignState), GL_DYNAMIC_READ);
}

void AlignLoop::start(const SE3d& T_cam_ref_guess) const {
  const GpuAlignState state = initialState(T_cam_ref_guess);
  state_.write(&state, sizeof(state));
}

void AlignLoop::run(const GpuPyramid& frame,
                    const GpuReference& reference,
                    GpuCommands& commands) const {
  for (int level = static_cast<int>(frame.levels.size()) - 1; level >= 0; --level) {
    commands.beginLevel(level);
    for (int k = 0; k < max_iterations_; ++k) {
      residual(frame, reference, level, commands);
      solve(reference, level, commands);
    }
  }
}

void AlignLoop::residual(const GpuPyramid& frame,
                         const GpuReference& reference,
                         int level,
                         GpuCommands& commands) const {
  if (reference.pointCount() == 0) return;
  residual_.use();
  glUniform1i(kPointCount, reference.pointCount());
  glUniform1i(kLevel, level);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, frame.levels[static_cast<std::size_t>(level)].get());
  bindStorage(0, reference.records());
  bindStorage(1, reference.pixels());
  bindStorage(2, sums_);
  bindStorage(3, state_);
  commands.dispatch(groupCount(reference.pointCount(), group_size_), 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the solve reads the sums
}

void AlignLoop::solve(const GpuReference& reference, int level, GpuCommands& commands) const {
  solve_.use();
  glUniform1i(kPointCount, reference.pointCount());
  glUniform1i(kLevel, level);
  bindStorage(0, reference.records());
  bindStorage(1, weights_);
  bindStorage(2, sums_);
  bindStorage(3, state_);
  commands.dispatch(1, 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the next iteration reads the pose
}

std::optional<GpuAlignState> AlignLoop::finish(GpuCommands& commands) const {
  commands.barrier(GL_BUFFER_UPDATE_BARRIER_BIT);  // the state is mapped
  const GlSync fence = GlSync::insert();
  if (!fence.wait(kTimeoutNs)) return std::nullopt;
  GpuAlignState state;
  if (!state_.read(&state, sizeof(state))) return std::nullopt;
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
