#include "bench/gpu/plan_run.h"

namespace glide::gpubench {
namespace {

/// Patch errors stay below: every weight is one.
constexpr double kNoWeights = 100.0;  // grey levels

}  // namespace

Config::Direct directOf(const Workload& workload, GpuPlan plan, Maths maths) {
  Config::Direct direct;
  direct.patch_size = workload.patch;
  direct.levels = workload.levels;
  direct.max_points = workload.points;
  if (maths == Maths::unweighted || plan == GpuPlan::paper) {
    direct.hessian = HessianMode::constant;
    direct.photometric = PhotometricModel::none;
    direct.huber_floor = kNoWeights;
  }
  return direct;
}

Result<PlanRun> PlanRun::create(const GlCaps& caps,
                                const Workload& workload,
                                const BenchScene& scene,
                                const Spec& spec) {
  auto aligner = GpuAligner::createWith(caps,
                                        directOf(workload, spec.tuning.plan, spec.maths),
                                        scene.camera,
                                        spec.tuning,
                                        {spec.timing, GlStatePolicy::preserve});
  if (!aligner) return aligner.error();
  return PlanRun(std::move(*aligner), workload, scene, spec);
}

PlanRun::PlanRun(std::unique_ptr<GpuAligner> aligner,
                 const Workload& workload,
                 const BenchScene& scene,
                 const Spec& spec)
    : aligner_(std::move(aligner)), workload_(workload), scene_(&scene), spec_(spec) {}

void PlanRun::frame(int index) {
  const std::size_t view = static_cast<std::size_t>(index) % scene_->frames.size();
  is_valid_ = aligner_->loadFrame(scene_->reference.view()).ok() && is_valid_;
  aligner_->promoteReference(scene_->points_ref);
  is_valid_ = aligner_->loadFrame(scene_->frames[view].view()).ok() && is_valid_;
  result_ = aligner_->align(SE3d{});
  is_valid_ = result_.valid && is_valid_;
  const GpuTimer& timer = aligner_->stageTimes();
  double frame_ms = 0.0;
  for (std::size_t s = 0; s < kGpuStages; ++s) {
    const auto stage = static_cast<GpuStage>(s);
    stage_ms_[s].push_back(timer.stageMs(stage));
    if (stage != GpuStage::precompute) frame_ms += timer.stageMs(stage);
  }
  frame_ms_.push_back(frame_ms);
  for (std::size_t level = 0; level < level_ms_.size(); ++level) {
    level_ms_[level].push_back(timer.levelMs(static_cast<int>(level)));
    iterations_[level] += result_.iterations[level];
  }
}

Status PlanRun::check() const {
  if (is_valid_) return Unit{};
  return Error{ErrorCode::gl,
               "an alignment has found no pose: the GPU does not answer, or the images are too "
               "small for points on them"};
}

void PlanRun::restart() {
  for (std::vector<double>& times : stage_ms_) times.clear();
  for (std::vector<double>& times : level_ms_) times.clear();
  frame_ms_.clear();
  iterations_ = {};
}

PerLevel PlanRun::iterations() const {
  PerLevel mean = iterations_;
  for (double& sum : mean) sum /= static_cast<double>(frame_ms_.size());
  return mean;
}

std::array<Traffic, kGpuStages> PlanRun::traffic() const {
  return countTraffic(workload_, {plan(), pointsOfLevels(*scene_, workload_), iterations()});
}

}  // namespace glide::gpubench
