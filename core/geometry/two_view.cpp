// Hypotheses come from an essential matrix and a homography, so that general and planar scenes both
// have a good start; every one is refined on all pairs by the same error (Sampson, in pixels) and
// judged by the same score, so that only one yardstick decides. What is not decisive is refused.
#include "geometry/two_view.h"

#include "geometry/epipolar_refine.h"
#include "geometry/essential.h"
#include "geometry/five_point.h"
#include "geometry/homography.h"
#include "geometry/pose_hypothesis.h"
#include "geometry/ray_pair.h"
#include "geometry/robust.h"
#include "geometry/rotation_only.h"
#include "geometry/triangulate.h"
#include "geometry/two_view_ransac.h"

#include <Eigen/LU>
#include <Eigen/SVD>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

namespace glide {
namespace {

constexpr double kDegPerRad = 57.29577951308232;

/// A second, different pose with this share of the best score makes the pair ambiguous.
constexpr double kAmbiguousShare = 0.8;

/// Poses closer than this are one answer whose precision is judged apart.
constexpr double kSamePoseRotation = 0.5 / kDegPerRad;
constexpr double kSamePoseDirection = 5.0 / kDegPerRad;

/// Largest share of the points with parallax that may lie behind a camera.
constexpr double kMaxBehindShare = 0.15;

/// Largest standard deviation of the translation's direction of a pose worth starting a map with.
constexpr double kMaxDirectionStd = 5.0 / kDegPerRad;

/// What a motion model is: dimension of the manifold that it leaves to a pair of pixels, number of
/// its parameters, and the quantile that its score counts from (TwoViewModels).
struct MotionModel {
  double dimension, parameters, quantile;
};
constexpr MotionModel kGeneral{3.0, 5.0, kChi2_1};
constexpr MotionModel kPlane{2.0, 8.0, kChi2_2};
constexpr MotionModel kRotation{2.0, 3.0, kChi2_2};
constexpr MotionModel kStill{2.0, 0.0, kChi2_2};

/// Geometric robust information criterion (Torr, "An assessment of information criteria for motion
/// model selection", CVPR 1997): -2 log-likelihood up to a constant, ln 4 for every dimension of
/// the manifold at each of the n pairs and ln 4n for every parameter. The smallest one wins.
double criterion(const MotionModel& model, double score, double n) {
  return n * model.quantile - score + n * model.dimension * std::log(4.0) +
         model.parameters * std::log(4.0 * n);
}

/// Criteria of the models that explain a pair with translation, and of those without.
struct MotionCriteria {
  double general, plane, rotation, still;
};

bool samePose(const PoseHypothesis& a, const PoseHypothesis& b) {
  const double rotation = so3Log(a.T_b_a.q * b.T_b_a.q.conjugate()).norm();
  const double direction = std::atan2(a.T_b_a.t.cross(b.T_b_a.t).norm(), a.T_b_a.t.dot(b.T_b_a.t));
  return rotation < kSamePoseRotation && direction < kSamePoseDirection;
}

/// Adds a pose unless it is one of those that are there.
void addDistinct(const PoseHypothesis& pose, std::vector<PoseHypothesis>* poses) {
  const auto same = [&](const PoseHypothesis& other) { return samePose(other, pose); };
  if (std::none_of(poses->begin(), poses->end(), same)) poses->push_back(pose);
}

/// All distinct poses that the models suggest, refined, best score first.
std::vector<PoseHypothesis> makeHypotheses(const TwoViewModels& models,
                                           std::span<const RayPair> rays,
                                           double sigma_px) {
  std::vector<SE3d> starts;
  if (models.inliers_E > 0) starts.push_back(posesOfEssential(models.E)[0]);
  if (models.inliers_H > 0) {
    for (const SE3d& T_b_a : posesOfHomography(models.H)) starts.push_back(T_b_a);
  }
  std::vector<PoseHypothesis> hypotheses;
  for (const SE3d& start : starts) {
    const RefinedPose refined = refineEpipolar(start, rays, sigma_px);
    addDistinct(bestOfFourPoses(refined, rays, sigma_px), &hypotheses);
  }
  std::stable_sort(hypotheses.begin(), hypotheses.end(), [](const auto& a, const auto& b) {
    return a.score > b.score;
  });
  return hypotheses;
}

/// Parallax in degrees that `count` pairs, or half of them if that is fewer, reach or exceed.
double robustParallaxDeg(const Eigen::Quaterniond& R_b_a,
                         const Mat3d& E,
                         std::span<const RayPair> rays,
                         const TwoViewOptions& options) {
  std::vector<double> angles;
  for (const RayPair& pair : rays) {
    const double limit = kChi2_1 * options.sigma_px * options.sigma_px;
    if (sampsonSquared(E, pair) < limit) angles.push_back(rayParallax(R_b_a, pair));
  }
  if (angles.empty()) return 0.0;
  const std::size_t rank =
      std::min(static_cast<std::size_t>(options.min_points), angles.size() / 2);
  const auto at = angles.begin() + static_cast<std::ptrdiff_t>(rank);
  std::nth_element(angles.begin(), at, angles.end(), std::greater<>());
  return *at * kDegPerRad;
}

void triangulateInliers(const PoseHypothesis& best,
                        std::span<const RayPair> rays,
                        double sigma_px,
                        TwoViewResult* result) {
  const Mat3d E = essentialOf(best.T_b_a);
  for (const RayPair& pair : rays) {
    if (!(sampsonSquared(E, pair) < kChi2_1 * sigma_px * sigma_px)) continue;
    if (!hasParallax(best.T_b_a.q, pair, sigma_px)) continue;
    const std::optional<Vec3d> p_a = triangulate(best.T_b_a, pair.a.f, pair.b.f);
    if (!p_a) continue;
    result->points_a[pair.index] = *p_a;
    result->triangulated[pair.index] = true;
    ++result->landmarks;
  }
}

/// Too many points with parallax lie behind a camera for the pose to be true.
bool isImpossible(const PoseHypothesis& pose) {
  return pose.behind > kMaxBehindShare * (pose.front + pose.behind);
}

/// The best pose is impossible, or a possible rival explains nearly as much.
bool isAmbiguous(const std::vector<PoseHypothesis>& hypotheses) {
  const PoseHypothesis& best = hypotheses.front();
  if (isImpossible(best)) return true;
  return std::any_of(hypotheses.begin() + 1, hypotheses.end(), [&](const PoseHypothesis& rival) {
    return !isImpossible(rival) && rival.score > kAmbiguousShare * best.score;
  });
}

/// Nearest rotation to a homography (up to scale), the start of the search for one.
Eigen::Quaterniond rotationOf(const Mat3d& H) {
  const Eigen::JacobiSVD<Mat3d> svd(H, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3d R = svd.matrixU() * svd.matrixV().transpose();
  return Eigen::Quaterniond(R.determinant() < 0.0 ? Mat3d(-R) : R).normalized();
}

/// All ways to see the pairs: poses, best first, and the rotation that fits best.
struct Explanations {
  TwoViewModels models;
  std::vector<PoseHypothesis> poses;
  Eigen::Quaterniond rotation;
  MotionCriteria criteria;

  bool isRotation() const { return criteria.rotation < std::min(criteria.general, criteria.plane); }
};

MotionCriteria compareMotions(const Explanations& explanations,
                              std::span<const RayPair> rays,
                              double sigma_px) {
  const Mat3d E = essentialOf(explanations.poses.front().T_b_a);
  const Mat3d R_b_a = explanations.rotation.toRotationMatrix();
  const ModelScore general = scoreEssential(E, rays, sigma_px);
  const ModelScore rotation = scoreHomography(R_b_a, rays, sigma_px);
  const ModelScore still = scoreHomography(Mat3d::Identity(), rays, sigma_px);
  const TwoViewModels& models = explanations.models;
  const double n = std::max({general.inliers, models.inliers_H, rotation.inliers, 1});
  return {criterion(kGeneral, general.score, n),
          criterion(kPlane, models.score_H, n),
          criterion(kRotation, rotation.score, n),
          criterion(kStill, still.score, n)};
}

/// Nothing when no model fits any pair.
std::optional<Explanations> explain(std::span<const RayPair> rays, const TwoViewOptions& options) {
  Explanations out;
  const double sigma_px = options.sigma_px;
  out.models = ransacTwoView(rays, {sigma_px, options.ransac_iterations, options.seed});
  out.poses = makeHypotheses(out.models, rays, sigma_px);
  if (out.poses.empty()) return std::nullopt;
  out.rotation = fitRotation(rotationOf(out.models.H), rays, sigma_px);
  out.criteria = compareMotions(out, rays, sigma_px);
  return out;
}

/// A plane has two explanations, which the refinement may merge into one between them: both compete
/// as they were, too.
void addPlaneRivals(std::span<const RayPair> rays, double sigma_px, Explanations* explanations) {
  for (const SE3d& T_b_a : posesOfHomography(explanations->models.H)) {
    addDistinct(bestOfFourPoses({T_b_a, 0.0}, rays, sigma_px), &explanations->poses);
  }
}

InitializationStatus judge(const Explanations& explanations,
                           const TwoViewResult& result,
                           const TwoViewOptions& options) {
  using Status = InitializationStatus;
  if (result.inliers < options.min_points) return Status::too_few_matches;
  const MotionCriteria& criteria = explanations.criteria;
  const bool still = criteria.still < criteria.rotation;
  if (explanations.isRotation()) return still ? Status::too_little_motion : Status::pure_rotation;
  if (result.parallax_deg < options.min_parallax_deg) return Status::too_little_motion;
  if (isAmbiguous(explanations.poses)) return Status::ambiguous;
  const bool vague = explanations.poses.front().direction_std > kMaxDirectionStd;
  const bool flat = result.landmarks < options.min_points;
  return vague || flat ? Status::too_little_motion : Status::done;
}

}  // namespace

TwoViewResult solveTwoView(const CameraModel& camera,
                           std::span<const PixelPair> pairs,
                           const TwoViewOptions& options) {
  TwoViewResult result;
  result.points_a.assign(pairs.size(), Vec3d::Zero());
  result.triangulated.assign(pairs.size(), false);
  const std::vector<RayPair> rays = makeRayPairs(camera, pairs);
  const int enough = std::max(static_cast<int>(kFivePoints), options.min_points);
  if (static_cast<int>(rays.size()) < enough) return result;
  std::optional<Explanations> explanations = explain(rays, options);
  if (!explanations) return result;

  const PoseHypothesis best = explanations->poses.front();
  const bool turned = explanations->isRotation();
  result.T_b_a = best.T_b_a;
  result.inliers = best.inliers;
  result.from_homography = explanations->criteria.plane < explanations->criteria.general;
  result.parallax_deg = robustParallaxDeg(
      turned ? explanations->rotation : best.T_b_a.q, essentialOf(best.T_b_a), rays, options);
  if (!turned) triangulateInliers(best, rays, options.sigma_px, &result);
  if (result.from_homography) addPlaneRivals(rays, options.sigma_px, &*explanations);
  result.status = judge(*explanations, result, options);
  return result;
}

}  // namespace glide
