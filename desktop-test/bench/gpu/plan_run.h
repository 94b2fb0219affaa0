#pragma once

#include "bench/gpu/bench_scene.h"

#include "gpu/gl_caps.h"
#include "gpu/gpu_aligner.h"

#include <array>
#include <memory>
#include <vector>

namespace glide::gpubench {

/// Whose mathematics a plan does.
enum class Maths {
  own,        ///< Each plan its own: the paper's without weights and with a constant H.
  unweighted  ///< Both without weights, gain and bias: they must agree.
};

/// What a plan is given of the direct tracker's configuration.
Config::Direct directOf(const Workload& workload, GpuPlan plan, Maths maths);

/// One plan on its own aligner, and what was measured of it.
class PlanRun {
 public:
  struct Spec {
    GpuTuning tuning;
    Maths maths = Maths::own;
    GpuTiming timing = GpuTiming::stages;
  };
  /// As GpuAligner::createWith. `scene` outlives this.
  static Result<PlanRun> create(const GlCaps& caps,
                                const Workload& workload,
                                const BenchScene& scene,
                                const Spec& spec);

  /// Reference, its cache, then frame `index` of the scene (they repeat) aligned from the
  /// reference's pose; remembers the times.
  void frame(int index);
  /// Forgets the times so far: they were a warm-up.
  void restart();

  GpuPlan plan() const { return spec_.tuning.plan; }
  /// Of the last frame.
  const AlignResult& result() const { return result_; }
  /// gl when any alignment so far has found no pose: its times are of something else.
  Status check() const;
  bool usesQueries() const { return aligner_->stageTimes().usesQueries(); }
  const GpuCommands& commands() const { return aligner_->commands(); }
  /// Milliseconds, one per frame.
  const std::vector<double>& times(GpuStage stage) const {
    return stage_ms_[static_cast<std::size_t>(stage)];
  }
  const std::vector<double>& levelTimes(int level) const {
    return level_ms_[static_cast<std::size_t>(level)];
  }
  /// Upload, pyramid, track and readback together.
  const std::vector<double>& frameTimes() const { return frame_ms_; }
  /// Iterations of each level: the mean over the frames so far.
  PerLevel iterations() const;
  /// What the stages have moved, as countTraffic.
  std::array<Traffic, kGpuStages> traffic() const;

 private:
  PlanRun(std::unique_ptr<GpuAligner> aligner,
          const Workload& workload,
          const BenchScene& scene,
          const Spec& spec);

  std::unique_ptr<GpuAligner> aligner_;
  Workload workload_;
  const BenchScene* scene_;
  Spec spec_;
  AlignResult result_;
  bool is_valid_ = true;  ///< all alignments so far
  std::array<std::vector<double>, kGpuStages> stage_ms_;
  std::array<std::vector<double>, kMaxAlignLevels> level_ms_;
  std::vector<double> frame_ms_;
  PerLevel iterations_{};  ///< sums over the frames
};

}  // namespace glide::gpubench
