#include "gpu/gpu_aligner.h"

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
  auto aligner = createWith(caps, direct, camera, tuning, GpuRunOptions{});
  if (!aligner) return aligner.error();
  return std::unique_ptr<Aligner>(std::move(*aligner));
}

Result<std::unique_ptr<GpuAligner>> GpuAligner::createWith(const GlCaps& caps,
                                                           const Config::Direct& direct,
                                                           const CameraModel& camera,
                                                           const GpuTuning& tuning,
                                                           const GpuRunOptions& options) {
  const int levels = pyramidLevels(camera.width(), camera.height(), direct.levels);
  const GpuAlignSpec spec{direct, camera, levels, tuning, options.programs};
  if (std::optional<Error> error = checkLimits(caps, spec)) return *std::move(error);
  Result<GlHome> home = GlHome::create();
  if (!home) return home.error();
  const ScopedGlState state(options.state);
  Result<Stages> stages = createStages(caps, spec);
  if (!stages) return stages.error();
  GpuTimer timer = GpuTimer::create(caps, options.timing);
  home->publish();
  return std::unique_ptr<GpuAligner>(
      new GpuAligner(std::move(*stages), std::move(timer), std::move(*home), options.state));
}

Result<GpuAligner::Stages> GpuAligner::createStages(const GlCaps& caps, const GpuAlignSpec& spec) {
  const int width = spec.camera.width();
  const int height = spec.camera.height();
  Result<LumaUpload> upload =
      LumaUpload::create(width, height, spec.tuning.group_size, spec.programs);
  if (!upload) return upload.error();
  GpuPyramid frame = GpuPyramid::allocate(width, height, spec.levels);
  Result<PyramidPass> pyramid = PyramidPass::create(spec.tuning, frame, spec.programs);
  if (!pyramid) return pyramid.error();
  Result<std::unique_ptr<AlignPlan>> plan = createAlignPlan(spec);
  if (!plan) return plan.error();

  GlBuffer constants = GlBuffer::allocate(sizeof(GpuAlignConstants), GL_STATIC_DRAW);
  AlignStateBuffer alignment = AlignStateBuffer::allocate();
  if (!allComplete(constants, *upload, frame, *pyramid, **plan, alignment)) {
    return outOfMemory("the aligner's buffers and textures");
  }
  const GpuAlignConstants values = alignConstants(spec);
  constants.write(&values, sizeof(values));
  return Stages{std::move(constants),
                std::move(*upload),
                TextureUpload(caps, {width, height}, spec.tuning.group_size, spec.programs),
                std::move(frame),
                std::move(*pyramid),
                std::move(*plan),
                std::move(alignment)};
}

GpuAligner::~GpuAligner() {
  if (!home_.isHere()) {
    abandon();
  } else if (!home_.isCreator()) {
    timer_.abandon();  // its queries are not of the current context
  }
}

void GpuAligner::abandon() {
  abandonAll(stages_.constants,
             stages_.upload,
             stages_.texture_upload,
             stages_.frame,
             stages_.pyramid,
             *stages_.plan,
             stages_.alignment,
             timer_,
             home_);
  is_lost_ = true;
}

void GpuAligner::bindConstants() const {
  glBindBufferBase(GL_UNIFORM_BUFFER, 0, stages_.constants.get());
}

Status GpuAligner::upload(const FrameImage& image) {
  const GlTexture& level0 = stages_.frame.levels.front();
  if (const auto* texture = std::get_if<Texture>(&image))
    return stages_.texture_upload.run(*texture, level0, state_policy_, commands_);
  stages_.upload.run(*std::get_if<ImageViewU8>(&image), level0, commands_);
  return Unit{};
}

Status GpuAligner::loadFrame(const FrameImage& image) {
  const GlVisit visit(&home_, state_policy_);
  commands_.beginStage(GpuStage::upload);
  Status uploaded = upload(image);
  commands_.endStage();
  if (!uploaded) return uploaded;
  commands_.beginStage(GpuStage::pyramid);
  stages_.pyramid.run(stages_.frame, commands_);
  commands_.endStage();
  has_frame_ = true;
  return Unit{};
}

void GpuAligner::promoteReference(std::span<const AlignPoint> points_ref) {
  assert(has_frame_);
  if (is_lost_) return;
  const GlVisit visit(&home_, state_policy_);
  commands_.beginStage(GpuStage::precompute);
  bindConstants();
  stages_.plan->precompute(stages_.frame, points_ref, commands_);
  commands_.endStage();
  home_.publish();
  has_reference_ = true;
}

AlignResult GpuAligner::align(const SE3d& T_cam_ref_guess) {
  AlignResult refused;
  refused.T_cam_ref = T_cam_ref_guess;
  if (!has_frame_ || !has_reference_) return refused;
  const GlVisit visit(&home_, state_policy_);
  commands_.beginStage(GpuStage::track);
  bindConstants();
  stages_.alignment.start(T_cam_ref_guess);
  stages_.plan->track(stages_.frame, stages_.alignment, commands_);
  commands_.endStage();
  commands_.beginStage(GpuStage::readback);
  const std::optional<GpuAlignState> finished = stages_.alignment.finish(commands_);
  commands_.endStage();
  timer_.collect();
  is_lost_ = !finished.has_value();
  return finished ? toResult(*finished) : refused;
}

}  // namespace glide
