#include "gpu/gpu_reference.h"

namespace glide {
namespace {

// Uniform locations of the kernel.
constexpr GLint kPointCount = 0;
constexpr GLint kLevel = 1;

}  // namespace

Result<GpuReference> GpuReference::create(const GpuAlignSpec& spec) {
  Result<ComputeProgram> kernel =
      ComputeProgram::create("align_precompute.comp", alignDefines(spec), spec.programs);
  if (!kernel) return kernel.error();
  return GpuReference(std::move(*kernel), spec);
}

GpuReference::GpuReference(ComputeProgram kernel, const GpuAlignSpec& spec)
    : kernel_(std::move(kernel)),
      group_size_(spec.tuning.group_size),
      order_(spec),
      points_(ReferencePoints::allocate(spec.direct.max_points)) {
  const std::int64_t records = std::int64_t{spec.direct.max_points} * spec.levels;
  records_ = GlBuffer::allocate(records * static_cast<std::int64_t>(sizeof(GpuPointRecord)),
                                GL_DYNAMIC_COPY);
  pixels_ = GlBuffer::allocate(cacheBytes(spec), GL_DYNAMIC_COPY);
}

void GpuReference::precompute(const GpuPyramid& pyramid,
                              std::span<const AlignPoint> points_ref,
                              GpuCommands& commands) {
  order_.sort(points_ref);
  points_.set(order_.points());
  kernel_.use();
  bindStorage(0, points_.buffer());
  bindStorage(1, records_);
  bindStorage(2, pixels_);
  glActiveTexture(GL_TEXTURE0);
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    const int level = static_cast<int>(l);
    const int count = order_.count(level);
    if (count == 0) break;  // nor is there a point at a coarser level
    glBindTexture(GL_TEXTURE_2D, pyramid.levels[l].get());
    glUniform1i(kPointCount, count);
    glUniform1i(kLevel, level);
    commands.dispatch(groupCount(count, group_size_), 1);
  }
  // The iterations read records and pixels. Levels write disjoint parts: no barrier between them.
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace glide
