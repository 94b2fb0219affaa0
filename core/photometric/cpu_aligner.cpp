#include "photometric/cpu_aligner.h"

#include "base/stopwatch.h"

#include <algorithm>
#include <cassert>
#include <string>

namespace glide {
namespace {

constexpr int kMinPatchSize = 3;  // the smallest patch that has a gradient of its own

Error invalid(const std::string& message) { return {ErrorCode::invalid_argument, message}; }

/// Copies what the last evaluation at the finest level says about the pose.
void report(const Evaluation& evaluation, const AlignState& state, AlignResult* result) {
  result->H = evaluation.normals.H;
  result->rms = evaluation.rms;
  result->contrast = evaluation.contrast;
  result->visible = evaluation.visible;
  result->inliers = evaluation.inliers;
  result->gain = state.gain;
  result->bias = state.bias;
}

}  // namespace

Result<std::unique_ptr<CpuAligner>> CpuAligner::create(const Config::Direct& config,
                                                       const CameraModel& camera) {
  if (config.patch_size < kMinPatchSize || config.patch_size > kMaxPatchSize ||
      config.patch_size % 2 == 0) {
    return invalid("direct.patch_size: must be odd and at most " + std::to_string(kMaxPatchSize));
  }
  if (config.levels < 1 || config.levels > kMaxAlignLevels) {
    return invalid("direct.levels: must be 1.." + std::to_string(kMaxAlignLevels));
  }
  if (config.max_points < 1) return invalid("direct.max_points: must be positive");
  return std::unique_ptr<CpuAligner>(new CpuAligner(config, camera));
}

CpuAligner::CpuAligner(const Config::Direct& config, const CameraModel& camera)
    : config_(config), layout_(PatchLayout::ofSize(config.patch_size)), evaluator_(config) {
  const int levels = pyramidLevels(camera.width(), camera.height(), config.levels);
  for (int l = 0; l < levels; ++l) cameras_.push_back(camera.atLevel(l));
  reference_.reserve(levels, config.max_points, layout_);
  state_.weights.reserve(static_cast<std::size_t>(config.max_points));
}

Status CpuAligner::loadFrame(const FrameImage& image) {
  const auto* luma = std::get_if<ImageViewU8>(&image);
  if (luma == nullptr) return Error{ErrorCode::unsupported, "the CPU aligner reads no textures"};
  assert(luma->width == cameras_.front().width() && luma->height == cameras_.front().height());
  Stopwatch watch;
  buildPyramid(*luma, config_.levels, &frame_);
  times_.pyramid_ms = watch.lapMs();
  return Unit{};
}

void CpuAligner::promoteReference(std::span<const AlignPoint> points_ref) {
  assert(!frame_.levels.empty());
  Stopwatch watch;
  const auto max_points = static_cast<std::size_t>(config_.max_points);
  const std::span<const AlignPoint> points =
      points_ref.first(std::min(points_ref.size(), max_points));
  buildReferenceCache(frame_, cameras_.front(), layout_, points, &reference_);
  has_reference_ = true;
  times_.precompute_ms = watch.lapMs();
}

AlignResult CpuAligner::align(const SE3d& T_cam_ref_guess) {
  AlignResult result;
  result.T_cam_ref = T_cam_ref_guess;
  if (!has_reference_) return result;
  Stopwatch watch;
  state_.T_cam_ref = T_cam_ref_guess;
  state_.gain = 1.0;
  state_.bias = 0.0;
  state_.weights.assign(reference_.points.size(), 1.0);
  result.points = reference_.levels.front().size();
  result.valid = true;
  for (int l = static_cast<int>(cameras_.size()) - 1; l >= 0 && result.valid; --l) {
    const bool enough = reference_.levels[static_cast<std::size_t>(l)].size() >= config_.min_points;
    if (enough) {
      result.valid = alignLevel(l, &state_, &result);
    } else if (l == 0) {
      result.valid = false;
    }
  }
  result.T_cam_ref = state_.T_cam_ref;
  times_.align_ms = watch.lapMs();
  return result;
}

/// Iterates on one level; false when the alignment is invalid.
bool CpuAligner::alignLevel(int level, AlignState* state, AlignResult* result) {
  const auto l = static_cast<std::size_t>(level);
  const LevelPair pair{frame_.levels[l], cameras_[l], reference_, reference_.levels[l]};
  for (int k = 0; k < config_.max_iterations; ++k) {
    const std::optional<Evaluation> evaluation = evaluator_.evaluate(pair, state);
    if (!evaluation) return level > 0;
    ++result->iterations[l];
    if (level == 0) report(*evaluation, *state, result);
    const std::optional<Vec6d> delta = solveNormals(evaluation->normals);
    if (!delta) return false;
    state->T_cam_ref = state->T_cam_ref * SE3d::exp(-*delta);
    if (delta->norm() < config_.convergence) break;
  }
  return true;
}

}  // namespace glide
