#include "gpu/gpu_reference.h"

namespace glide {
namespace {

// Uniform locations of the kernel.
constexpr GLint kPointCount = 0;
constexpr GLint kLevel = 1;

}  // namespace

Result<GpuReference> GpuReference::create(const GpuAlignSpec& spec) {
  Result<ComputeProgram> kernel =
      ComputeProgram::create("align_precompute.comp", alignDefines(spec));
  if (!kernel) return kernel.error();
  return GpuReference(std::move(*kernel), spec);
}

GpuReference::GpuReference(ComputeProgram kernel, const GpuAlignSpec& spec)
    : kernel_(std::move(kernel)),
      group_size_(spec.tuning.group_size),
      points_(ReferencePoints::allocate(spec.direct.max_points)) {
  const std::int64_t records = std::int64_t{spec.direct.max_points} * spec.levels;
  records_ = GlBuffer::allocate(records * static_cast<std::int64_t>(sizeof(GpuPointRecord)),
                                GL_DYNAMIC_COPY);
  pixels_ = GlBuffer::allocate(cacheBytes(spec), GL_DYNAMIC_COPY);
}

void GpuReference::precompute(const GpuPyramid& pyramid,
                              std::span<const AlignPoint> points_ref,
                              GpuCommands& commands) {
  points_.set(points_ref);
  if (points_ref.empty()) return;
  kernel_.use();
  glUniform1i(kPointCount, points_.count());
  bindStorage(0, points_.buffer());
  bindStorage(1, records_);
  bindStorage(2, pixels_);
  glActiveTexture(GL_TEXTURE0);
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    glBindTexture(GL_TEXTURE_2D, pyramid.levels[l].get());
    glUniform1i(kLevel, static_cast<GLint>(l));
    commands.dispatch(groupCount(points_.count(), group_size_), 1);
  }
  // The iterations read records and pixels. Levels write disjoint parts: no barrier between them.
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace glide
