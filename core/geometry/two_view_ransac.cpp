#include "geometry/two_view_ransac.h"

#include "geometry/essential.h"
#include "geometry/five_point.h"
#include "geometry/homography.h"
#include "geometry/robust.h"
#include "geometry/sampling.h"

#include <Eigen/LU>

#include <algorithm>
#include <array>
#include <cstddef>
#include <optional>
#include <random>
#include <vector>

namespace glide {
namespace {

/// Samples before the early stop may end the search: below that the best model's noise, not the
/// outliers, decides how good it is.
constexpr int kMinIterations = 50;

/// Rounds of inlier selection and refit of the homography, and the widening of the gate in each.
constexpr std::array<double, 4> kPolishGates{4.0, 2.0, 1.0, 1.0};

constexpr std::size_t kHomographyPairs = 4;

void tryHomography(const FivePairs& sample,
                   std::span<const RayPair> pairs,
                   double sigma_px,
                   TwoViewModels* best) {
  constexpr std::array<double, kHomographyPairs> kWeights{1.0, 1.0, 1.0, 1.0};
  const std::optional<Mat3d> H = fitHomography(std::span(sample).first(kHomographyPairs), kWeights);
  if (!H) return;
  const ModelScore score = scoreHomography(*H, pairs, sigma_px);
  if (score.score <= best->score_H) return;
  best->H = *H;
  best->score_H = score.score;
  best->inliers_H = score.inliers;
}

void tryEssentials(const FivePairs& sample,
                   std::span<const RayPair> pairs,
                   double sigma_px,
                   TwoViewModels* best) {
  for (const Mat3d& E : essentialsFromFivePairs(sample)) {
    const ModelScore score = scoreEssential(E, pairs, sigma_px);
    if (score.score <= best->score_E) continue;
    best->E = E;
    best->score_E = score.score;
    best->inliers_E = score.inliers;
  }
}

/// Least squares over the inliers of H; a weight of 1 / depth^2 makes the linear error the pixel's.
std::optional<Mat3d> refitHomography(const Mat3d& H, std::span<const RayPair> pairs, double gate) {
  const Mat3d H_inverse = H.inverse();
  std::vector<const RayPair*> inliers;
  std::vector<double> weights;
  for (const RayPair& pair : pairs) {
    if (!(transferSquared(H, H_inverse, pair) < gate)) continue;
    const double depth = pair.b.f.dot(H * pair.a.f);
    inliers.push_back(&pair);
    weights.push_back(1.0 / (depth * depth));
  }
  if (inliers.size() < kHomographyPairs) return std::nullopt;
  return fitHomography(inliers, weights);
}

void polishHomography(std::span<const RayPair> pairs, double sigma_px, TwoViewModels* models) {
  if (models->inliers_H == 0) return;
  Mat3d H = models->H;
  for (const double widening : kPolishGates) {
    const std::optional<Mat3d> refit =
        refitHomography(H, pairs, widening * widening * kChi2_2 * sigma_px * sigma_px);
    if (!refit) return;
    H = *refit;
    const ModelScore score = scoreHomography(H, pairs, sigma_px);
    if (score.score <= models->score_H) continue;
    models->H = H;
    models->score_H = score.score;
    models->inliers_H = score.inliers;
  }
}

}  // namespace

ModelScore scoreEssential(const Mat3d& E, std::span<const RayPair> pairs, double sigma_px) {
  const double inverse_variance = 1.0 / (sigma_px * sigma_px);
  ModelScore out;
  for (const RayPair& pair : pairs) {
    const double margin = kChi2_1 - sampsonSquared(E, pair) * inverse_variance;
    if (!(margin > 0.0)) continue;
    out.score += margin;
    ++out.inliers;
  }
  return out;
}

ModelScore scoreHomography(const Mat3d& H, std::span<const RayPair> pairs, double sigma_px) {
  const double inverse_variance = 1.0 / (sigma_px * sigma_px);
  const Mat3d H_inverse = H.inverse();
  ModelScore out;
  for (const RayPair& pair : pairs) {
    const double margin = kChi2_2 - transferSquared(H, H_inverse, pair) * inverse_variance;
    if (!(margin > 0.0)) continue;
    out.score += margin;
    ++out.inliers;
  }
  return out;
}

TwoViewModels ransacTwoView(std::span<const RayPair> pairs, const TwoViewRansacOptions& options) {
  TwoViewModels best;
  if (pairs.size() < kFivePoints) return best;
  std::mt19937_64 rng(options.seed);
  for (int i = 0; i < options.max_iterations; ++i) {
    const std::array<std::size_t, kFivePoints> picked =
        sampleDistinct<kFivePoints>(pairs.size(), rng);
    FivePairs sample{};
    std::transform(
        picked.begin(), picked.end(), sample.begin(), [&](std::size_t p) { return &pairs[p]; });
    tryHomography(sample, pairs, options.sigma_px, &best);
    tryEssentials(sample, pairs, options.sigma_px, &best);
    const double share = static_cast<double>(best.inliers_E) / static_cast<double>(pairs.size());
    if (i + 1 >= std::max(kMinIterations, samplesNeeded(share, kFivePoints))) break;
  }
  polishHomography(pairs, options.sigma_px, &best);
  return best;
}

}  // namespace glide
