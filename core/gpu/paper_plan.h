#pragma once

#include "gpu/align_plan.h"
#include "gpu/compute_program.h"
#include "gpu/reference_points.h"

namespace glide {

/// GpuPlan::paper: the structure of the paper's section III-C, written from its text, as the
/// yardstick of FusedPlan (shaders/paper_*.comp). The cache holds I0 and J of every pixel; each
/// iteration of each level is three dispatches with a barrier after each (residual, tree reduction,
/// solve and update); all iterations are done. Whatever the config says, H is constant and there
/// are neither weights nor gain and bias (HessianMode::constant, PhotometricModel::none).
/// Inliers are counted with the mean patch error of the evaluation before.
class PaperPlan final : public AlignPlan {
 public:
  static Result<std::unique_ptr<AlignPlan>> create(const GpuAlignSpec& spec);

  void precompute(const GpuPyramid& pyramid,
                  std::span<const AlignPoint> points_ref,
                  GpuCommands& commands) override;
  void track(const GpuPyramid& frame,
             const AlignStateBuffer& state,
             GpuCommands& commands) const override;
  bool isComplete() const override;
  void abandon() override;

 private:
  struct Programs {
    ComputeProgram precompute, hessian, residual, reduce, solve;
  };
  static Result<Programs> createPrograms(const GpuAlignSpec& spec);
  PaperPlan(Programs programs, const GpuAlignSpec& spec);

  void describePoints(const GlTexture& image, int level, GpuCommands& commands) const;
  void sumHessian(int level, GpuCommands& commands) const;
  void residual(const GlTexture& image,
                const AlignStateBuffer& state,
                int level,
                GpuCommands& commands) const;
  void reduce(const AlignStateBuffer& state, GpuCommands& commands) const;
  void solve(const AlignStateBuffer& state, int level, GpuCommands& commands) const;

  Programs programs_;
  int group_size_, max_iterations_;
  ReferencePoints points_;
  GlBuffer level_points_;    ///< vec4 [level][max_points]
  GlBuffer pixels_;          ///< I0, J [level][max_points][pixel]
  GlBuffer point_hessians_;  ///< of one level
  GlBuffer level_hessians_;
  GlBuffer terms_;  ///< PaperTerm per point
  GlBuffer total_;  ///< PaperTotal
};

}  // namespace glide
