#include "gpu/align_loop.h"

namespace glide {
namespace {

// Uniform locations of the kernels.
constexpr GLint kPointCount = 0;
constexpr GLint kLevel = 1;
constexpr GLint kAllPoints = 2;
constexpr GLint kMaxIterations = 3;

/// Tells the kernel in use about its level; a program keeps that until the next level.
void setLevel(const PointOrder& order, int level) {
  glUniform1i(kPointCount, order.count(level));
  glUniform1i(kLevel, level);
}

void setAllPoints(const PointOrder& order) {
  glUniform1i(kAllPoints, static_cast<GLint>(order.points().size()));
}

}  // namespace

Result<AlignLoop> AlignLoop::create(const GpuAlignSpec& spec) {
  const ShaderDefines defines = alignDefines(spec);
  const auto build = [&](const char* name) {
    return ComputeProgram::create(name, defines, spec.programs);
  };
  Result<ComputeProgram> residual = build("align_residual.comp");
  if (!residual) return residual.error();
  Result<ComputeProgram> solve = build("align_solve.comp");
  if (!solve) return solve.error();
  Result<ComputeProgram> coarse = build("align_coarse.comp");
  if (!coarse) return coarse.error();
  return AlignLoop({std::move(*residual), std::move(*solve), std::move(*coarse)}, spec);
}

AlignLoop::AlignLoop(Programs programs, const GpuAlignSpec& spec)
    : programs_(std::move(programs)),
      group_size_(spec.tuning.group_size),
      max_iterations_(spec.direct.max_iterations),
      min_points_(spec.direct.min_points),
      single_group_pixels_(spec.tuning.single_group_pixels),
      sums_(GlBuffer::allocate(
          spec.direct.max_points * static_cast<std::int64_t>(sizeof(GpuPointSums)),
          GL_DYNAMIC_COPY)) {}

void AlignLoop::run(const TrackInput& input,
                    const GpuReference& reference,
                    GpuCommands& commands) const {
  bind(input, reference);
  for (int level = static_cast<int>(input.frame.levels.size()) - 1; level >= 0; --level) {
    // Level 0 says that there are too few points.
    if (level > 0 && reference.order().count(level) < min_points_) continue;
    commands.beginLevel(level);
    const GlTexture& image = input.frame.levels[static_cast<std::size_t>(level)];
    glBindTexture(GL_TEXTURE_2D, image.get());
    if (image.width() * image.height() <= single_group_pixels_) {
      iterateCoarse(reference, level, commands);
    } else {
      iterateFine(reference, level, commands);
    }
  }
}

void AlignLoop::bind(const TrackInput& input, const GpuReference& reference) const {
  glActiveTexture(GL_TEXTURE0);
  bindStorage(0, reference.records());
  bindStorage(1, reference.pixels());
  bindStorage(2, sums_);
  bindStorage(3, input.state.buffer());
}

void AlignLoop::iterateCoarse(const GpuReference& reference,
                              int level,
                              GpuCommands& commands) const {
  programs_.coarse.use();
  setLevel(reference.order(), level);
  setAllPoints(reference.order());
  glUniform1i(kMaxIterations, max_iterations_);
  commands.dispatch(1, 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the next level reads pose and weights
}

void AlignLoop::iterateFine(const GpuReference& reference, int level, GpuCommands& commands) const {
  programs_.residual.use();
  setLevel(reference.order(), level);
  programs_.solve.use();
  setLevel(reference.order(), level);
  setAllPoints(reference.order());
  for (int k = 0; k < max_iterations_; ++k) {
    issueResidual(reference.order().count(level), commands);
    issueSolve(commands);
  }
}

void AlignLoop::issueResidual(int point_count, GpuCommands& commands) const {
  programs_.residual.use();
  commands.dispatch(groupCount(point_count, group_size_), 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the solve reads the sums
}

void AlignLoop::issueSolve(GpuCommands& commands) const {
  programs_.solve.use();
  commands.dispatch(1, 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the next iteration reads the pose
}

void AlignLoop::residual(const TrackInput& input,
                         const GpuReference& reference,
                         int level,
                         GpuCommands& commands) const {
  bind(input, reference);
  glBindTexture(GL_TEXTURE_2D, input.frame.levels[static_cast<std::size_t>(level)].get());
  programs_.residual.use();
  setLevel(reference.order(), level);
  issueResidual(reference.order().count(level), commands);
}

void AlignLoop::solve(const TrackInput& input,
                      const GpuReference& reference,
                      int level,
                      GpuCommands& commands) const {
  bind(input, reference);
  programs_.solve.use();
  setLevel(reference.order(), level);
  setAllPoints(reference.order());
  issueSolve(commands);
}

}  // namespace glide
