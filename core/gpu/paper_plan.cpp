#include "gpu/paper_plan.h"

#include <optional>

namespace glide {
namespace {

// Uniform locations of the kernels.
constexpr GLint kPointCount = 0;
constexpr GLint kLevel = 1;

// Bytes of the structs of shaders/paper_types.glsl.
constexpr std::int64_t kLevelPointBytes = 4 * sizeof(float);
constexpr std::int64_t kHessianBytes = 24 * sizeof(float);
constexpr std::int64_t kTermBytes = 8 * sizeof(float);
constexpr std::int64_t kTotalBytes = 12 * sizeof(float);

GlBuffer gpuOnly(std::int64_t bytes) { return GlBuffer::allocate(bytes, GL_DYNAMIC_COPY); }

}  // namespace

Result<std::unique_ptr<AlignPlan>> PaperPlan::create(const GpuAlignSpec& spec) {
  Result<Programs> programs = createPrograms(spec);
  if (!programs) return programs.error();
  return std::unique_ptr<AlignPlan>(new PaperPlan(std::move(*programs), spec));
}

Result<PaperPlan::Programs> PaperPlan::createPrograms(const GpuAlignSpec& spec) {
  const ShaderDefines defines = alignDefines(spec);
  Result<ComputeProgram> precompute =
      ComputeProgram::create("paper_precompute.comp", defines, spec.programs);
  if (!precompute) return precompute.error();
  Result<ComputeProgram> hessian =
      ComputeProgram::create("paper_hessian.comp", defines, spec.programs);
  if (!hessian) return hessian.error();
  Result<ComputeProgram> residual =
      ComputeProgram::create("paper_residual.comp", defines, spec.programs);
  if (!residual) return residual.error();
  Result<ComputeProgram> reduce =
      ComputeProgram::create("paper_reduce.comp", defines, spec.programs);
  if (!reduce) return reduce.error();
  Result<ComputeProgram> solve = ComputeProgram::create("paper_solve.comp", defines, spec.programs);
  if (!solve) return solve.error();
  return Programs{std::move(*precompute),
                  std::move(*hessian),
                  std::move(*residual),
                  std::move(*reduce),
                  std::move(*solve)};
}

PaperPlan::PaperPlan(Programs programs, const GpuAlignSpec& spec)
    : programs_(std::move(programs)),
      group_size_(spec.tuning.group_size),
      max_iterations_(spec.direct.max_iterations),
      points_(ReferencePoints::allocate(spec.direct.max_points)) {
  const std::int64_t points = spec.direct.max_points;
  level_points_ = gpuOnly(points * spec.levels * kLevelPointBytes);
  pixels_ = gpuOnly(cacheBytes(spec));
  point_hessians_ = gpuOnly(points * kHessianBytes);
  level_hessians_ = gpuOnly(spec.levels * kHessianBytes);
  terms_ = gpuOnly(points * kTermBytes);
  total_ = gpuOnly(kTotalBytes);
}

bool PaperPlan::isComplete() const {
  return allComplete(
      points_, level_points_, pixels_, point_hessians_, level_hessians_, terms_, total_);
}

void PaperPlan::abandon() {
  Programs& p = programs_;
  abandonAll(p.precompute, p.hessian, p.residual, p.reduce, p.solve);
  abandonAll(points_, level_points_, pixels_, point_hessians_, level_hessians_, terms_, total_);
}

void PaperPlan::precompute(const GpuPyramid& pyramid,
                           std::span<const AlignPoint> points_ref,
                           GpuCommands& commands) {
  points_.set(points_ref);
  glActiveTexture(GL_TEXTURE0);
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    const int level = static_cast<int>(l);
    if (points_.count() > 0) describePoints(pyramid.levels[l], level, commands);
    sumHessian(level, commands);
  }
}

void PaperPlan::describePoints(const GlTexture& image, int level, GpuCommands& commands) const {
  programs_.precompute.use();
  glUniform1i(kPointCount, points_.count());
  glUniform1i(kLevel, level);
  glBindTexture(GL_TEXTURE_2D, image.get());
  bindStorage(0, points_.buffer());
  bindStorage(1, level_points_);
  bindStorage(2, pixels_);
  bindStorage(3, point_hessians_);
  commands.dispatch(groupCount(points_.count(), group_size_), 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the sum reads the points' H
}

void PaperPlan::sumHessian(int level, GpuCommands& commands) const {
  programs_.hessian.use();
  glUniform1i(kPointCount, points_.count());
  glUniform1i(kLevel, level);
  bindStorage(0, point_hessians_);
  bindStorage(1, level_hessians_);
  commands.dispatch(1, 1);
  // The next level overwrites the points' H; the iterations read the level's.
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

void PaperPlan::track(const GpuPyramid& frame,
                      const AlignStateBuffer& state,
                      GpuCommands& commands) const {
  glActiveTexture(GL_TEXTURE0);
  for (int level = static_cast<int>(frame.levels.size()) - 1; level >= 0; --level) {
    commands.beginLevel(level);
    for (int k = 0; k < max_iterations_; ++k) {
      if (points_.count() > 0) {
        residual(frame.levels[static_cast<std::size_t>(level)], state, level, commands);
      }
      reduce(state, commands);
      solve(state, level, commands);
    }
  }
}

void PaperPlan::residual(const GlTexture& image,
                         const AlignStateBuffer& state,
                         int level,
                         GpuCommands& commands) const {
  programs_.residual.use();
  glUniform1i(kPointCount, points_.count());
  glUniform1i(kLevel, level);
  glBindTexture(GL_TEXTURE_2D, image.get());
  bindStorage(0, level_points_);
  bindStorage(1, pixels_);
  bindStorage(2, terms_);
  bindStorage(3, state.buffer());
  commands.dispatch(groupCount(points_.count(), group_size_), 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the reduction reads the terms
}

void PaperPlan::reduce(const AlignStateBuffer& state, GpuCommands& commands) const {
  programs_.reduce.use();
  glUniform1i(kPointCount, points_.count());
  bindStorage(0, terms_);
  bindStorage(1, total_);
  bindStorage(2, state.buffer());
  commands.dispatch(1, 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the solve reads the total
}

void PaperPlan::solve(const AlignStateBuffer& state, int level, GpuCommands& commands) const {
  programs_.solve.use();
  glUniform1i(kLevel, level);
  bindStorage(0, level_hessians_);
  bindStorage(1, total_);
  bindStorage(2, state.buffer());
  commands.dispatch(1, 1);
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);  // the next iteration reads the pose
}

}  // namespace glide
