#include "photometric/level_evaluator.h"

#include "geometry/robust.h"

#include <algorithm>
#include <cmath>

namespace glide {
namespace {

// A camera changes exposure by less between two frames of one reference; keeps a degenerate
// estimate from inverting or flattening the image.
constexpr double kMinGain = 0.2;
constexpr double kMaxGain = 5.0;

/// Whether a patch and the pixel that interpolation needs beside it stay inside along one axis.
bool isPatchInside(double u, int half, int size) { return u >= half && u < size - half - 1; }

}  // namespace

LevelEvaluator::LevelEvaluator(const Config::Direct& config)
    : config_(config), layout_(PatchLayout::ofSize(config.patch_size)) {
  const auto count = static_cast<std::size_t>(config.max_points);
  samples_.reserve(count);
  probes_.reserve(count);
  sums_.reserve(count);
  terms_.reserve(count);
}

std::optional<Evaluation> LevelEvaluator::evaluate(const LevelPair& pair, AlignState* state) {
  findVisible(pair, state->T_cam_ref);
  if (static_cast<int>(samples_.size()) < config_.min_points) return std::nullopt;
  sums_.resize(samples_.size());
  sumPatches(pair.image, layout_, probes_, sums_.data());
  if (config_.photometric == PhotometricModel::gain_bias) estimateExposure(pair.level, state);
  computeResiduals(pair.level, *state);
  return weigh(pair.level, state);
}

std::span<const LevelEvaluator::Sample> LevelEvaluator::compare(const LevelPair& pair,
                                                                const AlignState& state) {
  findVisible(pair, state.T_cam_ref);
  sums_.resize(samples_.size());
  sumPatches(pair.image, layout_, probes_, sums_.data());
  computeResiduals(pair.level, state);
  return samples_;
}

void LevelEvaluator::findVisible(const LevelPair& pair, const SE3d& T_cam_ref) {
  const Mat3d R_cam_ref = T_cam_ref.rotation();
  const int half = layout_.size / 2;
  samples_.clear();
  probes_.clear();
  for (std::size_t slot = 0; slot < pair.level.point.size(); ++slot) {
    const std::size_t point = pair.level.point[slot];
    const Vec3d p_cam = R_cam_ref * pair.reference.points[point].p_ref + T_cam_ref.t;
    const std::optional<Vec2d> uv = pair.camera.project(p_cam);
    if (!uv || !isPatchInside(uv->x(), half, pair.image.width()) ||
        !isPatchInside(uv->y(), half, pair.image.height())) {
      continue;
    }
    samples_.push_back({slot, point, 0.0, 0.0, 0.0});
    probes_.push_back({PatchSite::around(uv->x(), uv->y(), half),
                       pair.level.moments[slot].mean,
                       pair.level.blocks.data() + slot * layout_.blockSize()});
  }
}

void LevelEvaluator::estimateExposure(const ReferenceLevel& level, AlignState* state) const {
  const double n = layout_.pixels();
  double frame_variance = 0.0;
  double reference_variance = 0.0;
  double frame_mean = 0.0;
  double reference_mean = 0.0;
  double weights = 0.0;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    const double w = state->weights[samples_[i].point];
    const PatchMoments& moments = level.moments[samples_[i].slot];
    const double s1 = sums_[i].s1;
    frame_variance += w * (sums_[i].s2 - s1 * s1 / n);
    reference_variance += w * moments.e_e;
    frame_mean += w * (s1 / n + moments.mean);
    reference_mean += w * moments.mean;
    weights += w;
  }
  // Without any contrast every gain explains the frame; the normal equations refuse that later.
  const double ratio = reference_variance > 0.0 ? frame_variance / reference_variance : 1.0;
  state->gain = std::clamp(std::sqrt(std::max(ratio, 0.0)), kMinGain, kMaxGain);
  state->bias = (frame_mean - state->gain * reference_mean) / weights;
}

void LevelEvaluator::computeResiduals(const ReferenceLevel& level, const AlignState& state) {
  const double n = layout_.pixels();
  const double inverse_gain = 1.0 / state.gain;
  for (std::size_t i = 0; i < samples_.size(); ++i) {
    Sample& sample = samples_[i];
    const PatchMoments& m = level.moments[sample.slot];
    const PatchSums& s = sums_[i];
    const double c = m.mean - state.bias - state.gain * m.mean;
    const double frame = (s.s2 + 2.0 * c * s.s1 + n * c * c) * inverse_gain * inverse_gain;
    const double r_r = frame - 2.0 * s.sc * inverse_gain + m.e_e;
    sample.rho = std::sqrt(std::max(r_r, 0.0) / n);
    sample.gx_r = (s.sx + c * m.gx) * inverse_gain - m.gx_e;
    sample.gy_r = (s.sy + c * m.gy) * inverse_gain - m.gy_e;
  }
}

double LevelEvaluator::huberThreshold(const std::vector<double>& weights) const {
  double weighted = 0.0;
  double total = 0.0;
  for (const Sample& sample : samples_) {
    weighted += weights[sample.point] * sample.rho;
    total += weights[sample.point];
  }
  return std::max(config_.huber_factor * weighted / total, config_.huber_floor);
}

Evaluation LevelEvaluator::weigh(const ReferenceLevel& level, AlignState* state) {
  const bool robust = config_.hessian == HessianMode::robust;
  const double threshold = huberThreshold(state->weights);
  const double n = layout_.pixels();
  Evaluation out;
  double total = 0.0;
  terms_.clear();
  for (const Sample& sample : samples_) {
    const double w = robust ? huberWeight(sample.rho, threshold) : 1.0;
    state->weights[sample.point] = w;
    total += w;
    out.rms += w * sample.rho;
    out.contrast += std::sqrt(level.moments[sample.slot].e_e / n);
    out.inliers += sample.rho <= threshold ? 1 : 0;
    terms_.push_back({&level.normals[sample.slot], w, sample.gx_r, sample.gy_r});
  }
  out.visible = static_cast<int>(samples_.size());
  out.rms /= total;
  out.contrast /= out.visible;
  out.normals = accumulateNormals(terms_);
  if (!robust) out.normals.H = level.H_all;
  return out;
}

}  // namespace glide
