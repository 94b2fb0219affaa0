#include "gpu/gpu_reference.h"

#include <algorithm>

namespace glide {
namespace {

constexpr int kPointFloats = 4;  // xyz and padding

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
    : kernel_(std::move(kernel)), group_size_(spec.tuning.group_size) {
  const std::int64_t points = spec.direct.max_points;
  staging_.resize(static_cast<std::size_t>(points * kPointFloats));
  points_ = GlBuffer::allocate(static_cast<std::int64_t>(staging_.size() * sizeof(float)),
                               GL_DYNAMIC_DRAW);
  records_ = GlBuffer::allocate(
      points * spec.levels * static_cast<std::int64_t>(sizeof(GpuPointRecord)), GL_DYNAMIC_COPY);
  pixels_ = GlBuffer::allocate(pixelCacheBytes(spec), GL_DYNAMIC_COPY);
}

void GpuReference::precompute(const GpuPyramid& pyramid,
                              std::span<const AlignPoint> points_ref,
                              GpuCommands& commands) {
  points_ref = points_ref.first(std::min(points_ref.size(), staging_.size() / kPointFloats));
  point_count_ = static_cast<int>(points_ref.size());
  if (points_ref.empty()) return;
  for (std::size_t i = 0; i < points_ref.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      staging_[i * kPointFloats + c] =
          static_cast<float>(points_ref[i].p_ref[static_cast<Eigen::Index>(c)]);
    }
  }
  points_.write(staging_.data(),
                static_cast<std::int64_t>(points_ref.size() * kPointFloats * sizeof(float)));

  kernel_.use();
  glUniform1i(kPointCount, point_count_);
  bindStorage(0, points_);
  bindStorage(1, records_);
  bindStorage(2, pixels_);
  glActiveTexture(GL_TEXTURE0);
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    glBindTexture(GL_TEXTURE_2D, pyramid.levels[l].get());
    glUniform1i(kLevel, static_cast<GLint>(l));
    commands.dispatch(groupCount(point_count_, group_size_), 1);
  }
  // The iterations read records and pixels. Levels write disjoint parts: no barrier between them.
  commands.barrier(GL_SHADER_STORAGE_BARRIER_BIT);
}

}  // namespace glide
