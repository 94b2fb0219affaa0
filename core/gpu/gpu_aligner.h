#pragma once

#include "gpu/align_layout.h"
#include "gpu/align_plan.h"
#include "gpu/align_state.h"
#include "gpu/gl_caps.h"
#include "gpu/gl_home.h"
#include "gpu/gpu_commands.h"
#include "gpu/gpu_pyramid.h"
#include "gpu/gpu_timer.h"
#include "gpu/gpu_tuning.h"
#include "gpu/luma_upload.h"
#include "gpu/texture_upload.h"
#include "photometric/aligner.h"

#include <memory>

namespace glide {

/// How an aligner runs, apart from what it computes.
struct GpuRunOptions {
  GpuTiming timing = GpuTiming::passive;
  GlStatePolicy state = GlStatePolicy::preserve;
  ProgramCache programs{};
};

/// Aligner on OpenGL ES 3.1 compute: the contract of docs/algorithms/photometric-alignment.md in
/// float. Lives on the GL thread: the context of create(), or one that shares objects with it, is
/// current in every call but abandon(). Destroyed elsewhere it forgets its names, which go with
/// their context. Each call leaves the app's GL state as the policy says (docs/gl-contract.md);
/// only align() waits, once, and reads back once. The reference keeps no pyramid of its own:
/// promoteReference reads the frame's.
class GpuAligner final : public Aligner {
 public:
  /// unsupported when a limit of the context is too small for the configuration, gl when a shader
  /// does not build or memory runs out.
  static Result<std::unique_ptr<Aligner>> create(const GlCaps& caps,
                                                 const Config::Direct& direct,
                                                 const CameraModel& camera);
  /// The same with a group size of the caller's choice.
  static Result<std::unique_ptr<Aligner>> createTuned(const GlCaps& caps,
                                                      const Config::Direct& direct,
                                                      const CameraModel& camera,
                                                      const GpuTuning& tuning);
  /// The same with all options.
  static Result<std::unique_ptr<GpuAligner>> createWith(const GlCaps& caps,
                                                        const Config::Direct& direct,
                                                        const CameraModel& camera,
                                                        const GpuTuning& tuning,
                                                        const GpuRunOptions& options);
  ~GpuAligner() override;

  Status loadFrame(const FrameImage& image) override;
  void promoteReference(std::span<const AlignPoint> points_ref) override;
  bool hasReference() const override { return has_reference_; }
  /// Not valid, with the guess as its pose, before a frame and a reference are there and when the
  /// GPU does not answer; it is not usable any more then.
  AlignResult align(const SE3d& T_cam_ref_guess) override;
  bool isUsable() const override { return !is_lost_ && home_.isHere(); }
  void abandon() override;
  /// What the last loadFrame, promoteReference and align have issued.
  const GpuCommands& commands() const { return commands_; }
  /// See GpuTimer for what the numbers mean.
  AlignTimes times() const override { return timer_.times(); }
  const GpuTimer& stageTimes() const { return timer_; }
  StageTimer timer() const override {
    return timer_.usesQueries() ? StageTimer::query : StageTimer::sync;
  }

 private:
  /// Everything that lives on the GPU.
  struct Stages {
    GlBuffer constants;
    LumaUpload upload;
    TextureUpload texture_upload;
    GpuPyramid frame;
    PyramidPass pyramid;
    std::unique_ptr<AlignPlan> plan;
    AlignStateBuffer alignment;
  };
  static Result<Stages> createStages(const GlCaps& caps, const GpuAlignSpec& spec);
  GpuAligner(Stages stages, GpuTimer timer, GlHome home, GlStatePolicy state)
      : home_(std::move(home)),
        state_policy_(state),
        stages_(std::move(stages)),
        timer_(std::move(timer)) {}
  Status upload(const FrameImage& image);
  void bindConstants() const;

  GlHome home_;
  GlStatePolicy state_policy_;
  Stages stages_;
  GpuTimer timer_;
  GpuCommands commands_{&timer_};
  bool has_frame_ = false;
  bool has_reference_ = false;
  bool is_lost_ = false;  ///< the GPU did not answer
};

}  // namespace glide
