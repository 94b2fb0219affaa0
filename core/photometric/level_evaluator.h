#pragma once

#include "photometric/normal_equations.h"
#include "photometric/reference_cache.h"

#include "geometry/camera_model.h"
#include "image/image.h"

#include "glide/config.h"

#include <optional>
#include <span>
#include <vector>

namespace glide {

/// What an alignment carries from iteration to iteration and from level to level.
struct AlignState {
  SE3d T_cam_ref;
  double gain = 1.0, bias = 0.0;
  std::vector<double> weights;  ///< of each reference point, from the iteration before
};

/// One level of the frame and of the reference.
struct LevelPair {
  const ImageF& image;
  const CameraModel& camera;  ///< of this level
  const ReferenceCache& reference;
  const ReferenceLevel& level;  ///< of `reference`
};

/// What one evaluation at a pose found.
struct Evaluation {
  NormalEquations normals;
  double rms = 0.0;       ///< sum w rho / sum w, grey levels
  double contrast = 0.0;  ///< mean over visible points of sqrt(E / n), grey levels
  int visible = 0;
  int inliers = 0;
};

/// Steps 1 to 5 of an iteration (docs/algorithms/photometric-alignment.md): projects, samples,
/// estimates gain and bias, weighs and builds the normal equations. Keeps its work arrays between
/// calls.
class LevelEvaluator {
 public:
  explicit LevelEvaluator(const Config::Direct& config);

  /// Evaluates at the state's pose and updates the state's gain, bias and weights. Nothing, and the
  /// state as it was, when fewer than min_points points are visible.
  std::optional<Evaluation> evaluate(const LevelPair& pair, AlignState* state);

  /// A visible point of the level.
  struct Sample {
    std::size_t slot = 0;   ///< in the level
    std::size_t point = 0;  ///< in the reference
    double rho = 0.0;       ///< patch error, grey levels
    double gx_r = 0.0, gy_r = 0.0;
  };
  /// The visible points at the state's pose, gain and bias, compared with the frame; valid until
  /// the next call.
  std::span<const Sample> compare(const LevelPair& pair, const AlignState& state);

 private:
  void findVisible(const LevelPair& pair, const SE3d& T_cam_ref);
  void estimateExposure(const ReferenceLevel& level, AlignState* state) const;
  void computeResiduals(const ReferenceLevel& level, const AlignState& state);
  double huberThreshold(const std::vector<double>& weights) const;
  Evaluation weigh(const ReferenceLevel& level, AlignState* state);

  Config::Direct config_;
  PatchLayout layout_;
  std::vector<Sample> samples_;
  std::vector<PatchProbe> probes_;
  std::vector<PatchSums> sums_;
  std::vector<NormalTerm> terms_;
};

}  // namespace glide
