#pragma once

#include "photometric/aligner.h"
#include "photometric/level_evaluator.h"
#include "photometric/reference_cache.h"

#include "geometry/camera_model.h"
#include "image/pyramid.h"

#include "glide/config.h"
#include "glide/result.h"

#include <memory>
#include <span>
#include <vector>

namespace glide {

/// The direct tracker's engine on the CPU (docs/algorithms/photometric-alignment.md): vector code
/// chosen at run time, no allocation per frame. Used without ES 3.1 and as the oracle of the GPU.
/// One owner, one thread.
class CpuAligner final : public Aligner {
 public:
  /// invalid_argument naming the field when patch_size, levels or max_points is out of its range.
  static Result<std::unique_ptr<CpuAligner>> create(const Config::Direct& config,
                                                    const CameraModel& camera);

  /// unsupported for a texture.
  Status loadFrame(const FrameImage& image) override;

  /// Points beyond Config::Direct::max_points are left out. The frame stays loaded: it can still be
  /// aligned, now to itself.
  void promoteReference(std::span<const AlignPoint> points_ref) override;

  bool hasReference() const override { return has_reference_; }

  /// Not valid when there is no reference or no frame yet.
  AlignResult align(const SE3d& T_cam_ref_guess) override;

  bool isUsable() const override { return true; }
  void abandon() override {}
  AlignTimes times() const override { return times_; }
  StageTimer timer() const override { return StageTimer::cpu; }

 private:
  CpuAligner(const Config::Direct& config, const CameraModel& camera);

  bool alignLevel(int level, AlignState* state, AlignResult* result);

  Config::Direct config_;
  PatchLayout layout_;
  std::vector<CameraModel> cameras_;  ///< one per level
  Pyramid frame_;
  ReferenceCache reference_;
  bool has_reference_ = false;
  LevelEvaluator evaluator_;
  AlignState state_;
  AlignTimes times_;
};

}  // namespace glide
