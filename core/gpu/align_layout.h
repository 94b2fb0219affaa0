#pragma once

#include "gpu/gl_objects.h"
#include "gpu/gpu_tuning.h"
#include "gpu/program_cache.h"
#include "gpu/shader_source.h"

#include "geometry/camera_model.h"

#include "glide/config.h"

#include <cstddef>
#include <cstdint>

namespace glide {

/// What one GpuAligner is made for.
struct GpuAlignSpec {
  Config::Direct direct;
  CameraModel camera;
  int levels = 0;  ///< that the image size allows, at most direct.levels
  GpuTuning tuning;
  ProgramCache programs{};  ///< where the kernels are taken from and left
};

/// std140 block AlignConstants of shaders/align_types.glsl.
struct GpuAlignConstants {
  float focal_center[4];
  float distortion[4];
  float lens[4];
  float robust[4];
  std::int32_t limits[4];
};
static_assert(sizeof(GpuAlignConstants) == 80);
static_assert(offsetof(GpuAlignConstants, limits) == 64);

/// std430 struct PointRecord.
struct GpuPointRecord {
  float p_ref[4];
  float jx_jy[12];
  float moments[4];    ///< m0, E, Ex, Ey
  float gradients[4];  ///< Gx, Gy, Gxx, Gxy
  float rest[4];       ///< Gyy
};
static_assert(sizeof(GpuPointRecord) == 112);
static_assert(offsetof(GpuPointRecord, moments) == 64);

/// std430 struct PointSums.
struct GpuPointSums {
  float intensity[4];  ///< S1, S2, Sc, Sx
  float rest[4];       ///< Sy, visible, weight, patch error
};
static_assert(sizeof(GpuPointSums) == 32);

/// std430 struct AlignState: what one alignment starts from, and all that is read back.
struct GpuAlignState {
  float q_cam_ref[4];
  float t_cam_ref[4];
  float photometric[4];    ///< gain, bias, rms, contrast
  std::int32_t counts[4];  ///< points, visible, inliers, failed
  std::int32_t flow[4];    ///< level that has ended last, weights hold values
  std::int32_t iterations[8];
  float hessian[24];  ///< 21 used
};
static_assert(sizeof(GpuAlignState) == 208);
static_assert(offsetof(GpuAlignState, iterations) == 80);
static_assert(offsetof(GpuAlignState, hessian) == 112);

/// Floats per pixel of a patch in the cache of GpuPlan::fused: e, gx, gy.
inline constexpr int kPixelFloats = 3;
/// In that of GpuPlan::paper: I0 and the row of J.
inline constexpr int kPaperPixelFloats = 7;

/// Bytes of the buffer of the patches' pixels over all levels, in the spec's plan: the largest of
/// all.
std::int64_t cacheBytes(const GpuAlignSpec& spec);

GpuAlignConstants alignConstants(const GpuAlignSpec& spec);

/// GROUP_SIZE, PATCH_SIZE and CAMERA_MODEL.
ShaderDefines alignDefines(const GpuAlignSpec& spec);

/// Binds `buffer` to shader storage binding `index`.
void bindStorage(GLuint index, const GlBuffer& buffer);

}  // namespace glide
