#include "gpu/gpu_aligner.h"

#include "gpu/gl_state.h"

#include "image/pyramid.h"

#include <string>

namespace glide {
namespace {

std::optional<Error> checkLimits(const GlCaps& caps, const GpuAlignSpec& spec) {
  const int group_size = spec.tuning.group_size;
  if (group_size != 32 && group_size != 64 && group_size != 128) {
    return Error{ErrorCode::invalid_argument, "group_size must be 32, 64 or 128"};
  }
  const int longest = std::max(spec.camera.width(), spec.camera.height());
  if (longest > caps.max_texture_size) {
    return Error{ErrorCode::unsupported,
                 "images of " + std::to_string(longest) + " px exceed GL_MAX_TEXTURE_SIZE " +
                     std::to_string(caps.max_texture_size)};
  }
  const std::int64_t cache_bytes = cacheBytes(spec);
  if (cache_bytes > caps.max_storage_bytes) {
    return Error{ErrorCode::unsupported,
                 "direct.max_points x patch_size^2 x levels needs " + std::to_string(cache_bytes) +
                     " bytes, more than GL_MAX_SHADER_STORAGE_BLOCK_SIZE " +
                     std::to_string(caps.max_storage_bytes)};
  }
  return std::nullopt;
}

}  // namespace

Result<std::unique_ptr<Aligner>> GpuAligner::create(const GlCaps& caps,
                                                    const Config::Direct& direct,
                                                    const CameraModel& camera) {
  return createTuned(caps, direct, camera, GpuTuning{});
}

Result<std::unique_ptr<Aligner>> GpuAligner::createTuned(const GlCaps& caps,
                                                         const Config::Direct& direct,
                                                         const CameraModel& camera,
                                                         const GpuTuning& tuning) {
  auto aligner = createTimed(caps, direct, camera, tuning, GpuTiming::passive);
  if (!aligner) return aligner.error();
  return std::unique_ptr<Aligner>(std::move(*aligner));
}

Result<std::unique_ptr<GpuAligner>> GpuAligner::createTimed(const GlCaps& caps,
                                                            const Config::Direct& direct,
                                                            const CameraModel& camera,
                                                            const GpuTuning& tuning,
                                                            GpuTiming timing) {
  const int levels = pyramidLevels(camera.width(), camera.height(), direct.levels);
  const GpuAlignSpec spec{direct, camera, levels, tuning};
  if (std::optional<Error> error = checkLimits(caps, spec)) return *std::move(error);
  const ScopedGlState state(GlStatePolicy::preserve);
  Result<Stages> stages = createStages(spec);
  if (!stages) return stages.error();
  GpuTimer timer = GpuTimer::create(caps, timing);
  return std::unique_ptr<GpuAligner>(new GpuAligner(std::move(*stages), std::move(timer)));
}

Result<GpuAligner::Stages> GpuAligner::createStages(const GpuAlignSpec& spec) {
  const int width = spec.camera.width();
  const int height = spec.camera.height();
  Result<LumaUpload> upload = LumaUpload::create(width, height, spec.tuning.group_size);
  if (!upload) return upload.error();
  Result<PyramidPass> pyramid = PyramidPass::create(spec.tuning.group_size);
  if (!pyramid) return pyramid.error();
  Result<std::unique_ptr<AlignPlan>> plan = createAlignPlan(spec);
  if (!plan) return plan.error();

  GlBuffer constants = GlBuffer::allocate(sizeof(GpuAlignConstants), GL_STATIC_DRAW);
  const GpuAlignConstants values = alignConstants(spec);
  constants.write(&values, sizeof(values));
  return Stages{std::move(constants),
                std::move(*upload),
                GpuPyramid::allocate(width, height, spec.levels),
                std::move(*pyramid),
                std::move(*plan),
                AlignStateBuffer::allocate()};
}

void GpuAligner::bindConstants() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, stages_.constants.get());
}

Status GpuAligner::loadFrame(const FrameImage& image) {
  const auto* luma = std::get_if<ImageViewU8>(&image);
  if (luma == nullptr) return Error{ErrorCode::unsupported, "textures are not read yet"};
  const ScopedGlState state(GlStatePolicy::preserve);
  commands_.beginStage(GpuStage::upload);
  stages_.upload.run(*luma, stages_.frame.levels.front(), commands_);
  commands_.endStage();
  commands_.beginStage(GpuStage::pyramid);
  stages_.pyramid.run(stages_.frame, commands_);
  commands_.endStage();
  has_frame_ = true;
  return Unit{};
}

void GpuAligner::promoteReference(std::span<const AlignPoint> points_ref) {
  assert(has_frame_);
  const ScopedGlState state(GlStatePolicy::preserve);
  commands_.beginStage(GpuStage::precompute);
  bindConstants();
  stages_.plan->precompute(stages_.frame, points_ref, commands_);
  commands_.endStage();
  has_reference_ = true;
}

AlignResult GpuAligner::align(const SE3d& T_cam_ref_guess) {
  AlignResult refused;
  refused.T_cam_ref = T_cam_ref_guess;
  if (!has_frame_ || !has_reference_) return refused;
  const ScopedGlState state(GlStatePolicy::preserve);
  commands_.beginStage(GpuStage::track);
  bindConstants();
  stages_.alignment.start(T_cam_ref_guess);
  stages_.plan->track(stages_.frame, stages_.alignment, commands_);
  commands_.endStage();
  commands_.beginStage(GpuStage::readback);
  const std::optional<GpuAlignState> finished = stages_.alignment.finish(commands_);
  commands_.endStage();
  timer_.collect();
  return finished ? toResult(*finished) : refused;
}

}  // namespace glide
