#include "gpu/align_loop.h"

namespace glide {
namespace {

// Uniform locations of both kernels.
constexpr GLint kPointCount = 0;
constexpr GLint kLevel = 1;

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
}

void AlignLoop::run(const TrackInput& input,
                    const GpuReference& reference,
                    GpuCommands& commands) const {
  for (int level = static_cast<int>(input.frame.levels.size()) - 1; level >= 0; --level) {
    commands.beginLevel(level);
    for (int k = 0; k < max_iterations_; ++k) {
      residual(input, reference, level, commands);
      solve(input, reference, level, commands);
    }
  }
}

void AlignLoop::residual(const TrackInput& input,
                         const GpuReference& reference,
                         int level,
                         GpuCommands& commands) const {
  if (reference.pointCount() == 0) return;
  residual_.use();
  glUniform1i(kPointCount, reference.pointCount());
  glUniform1i(kLevel, level);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_2D, input.frame.levels[static_cast<std::size_t>(level)].get());
  bindStorage(0, reference.records());
  bindStorage(1, reference.pixels());
  bindStorage(2, sums_);
  bindStorage(3, input.state.buffer());
  commands.dispatch(groupCount(reference.pointCount(), group_size_), 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the solve reads the sums
}

void AlignLoop::solve(const TrackInput& input,
                      const GpuReference& reference,
                      int level,
                      GpuCommands& commands) const {
  solve_.use();
  glUniform1i(kPointCount, reference.pointCount());
  glUniform1i(kLevel, level);
  bindStorage(0, reference.records());
  bindStorage(1, weights_);
  bindStorage(2, sums_);
  bindStorage(3, input.state.buffer());
  commands.dispatch(1, 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the next iteration reads the pose
}

}  // namespace glide
