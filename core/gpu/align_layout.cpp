#include "gpu/align_layout.h"

#include <algorithm>
#include <limits>

namespace glide {

std::int64_t cacheBytes(const GpuAlignSpec& spec) {
  const std::int64_t patch = spec.direct.patch_size;
  const std::int64_t floats = spec.tuning.plan == GpuPlan::paper
                                  ? patch * patch * kPaperPixelFloats
                                  : patch * (patch + 1) * kPixelFloats;  // rows of whole pairs
  return floats * spec.levels * spec.direct.max_points * static_cast<std::int64_t>(sizeof(float));
}

GpuAlignConstants alignConstants(const GpuAlignSpec& spec) {
  const CameraModel& camera = spec.camera;
  const auto f = [](double value) { return static_cast<float>(value); };
  const auto& k = camera.coefficients();
  // No limit is an infinity, which GLSL need not compare right.
  const double max_radius =
      std::min(camera.maxRadius(), static_cast<double>(std::numeric_limits<float>::max()));
  return {
      {f(camera.fx()), f(camera.fy()), f(camera.cx()), f(camera.cy())},
      {f(k[0]), f(k[1]), f(k[2]), f(k[3])},
      {f(k[4]), f(max_radius), 0.0F, 0.0F},
      {f(spec.direct.huber_factor), f(spec.direct.huber_floor), f(spec.direct.convergence), 0.0F},
      {spec.direct.max_points,
       spec.direct.min_points,
       spec.direct.photometric == PhotometricModel::gain_bias ? 1 : 0,
       spec.direct.hessian == HessianMode::constant ? 1 : 0}};
}

ShaderDefines alignDefines(const GpuAlignSpec& spec) {
  int camera_model = 0;
  switch (spec.camera.distortion()) {
    case DistortionModel::none:
      break;
    case DistortionModel::radial_tangential:
      camera_model = 1;
      break;
    case DistortionModel::kannala_brandt4:
      camera_model = 2;
      break;
  }
  return {{"GROUP_SIZE", spec.tuning.group_size},
          {"PATCH_SIZE", spec.direct.patch_size},
          {"CAMERA_MODEL", camera_model}};
}

void bindStorage(GLuint index, const GlBuffer& buffer) {
  glBindBufferBase(GL_SHADER_STORAGE_BUFFER, index, buffer.get());
}

}  // namespace glide
