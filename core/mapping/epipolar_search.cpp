#include "mapping/epipolar_search.h"

#include "geometry/robust.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glide {
namespace {

constexpr double kPi = 3.14159265358979323846;

// 3 mrad per bin: about the gate of a level-0 feature seen at a right angle to the baseline.
constexpr int kPlaneBins = 2048;
constexpr double kBinsPerRad = kPlaneBins / (2.0 * kPi);
// Closer to the epipole the plane is undefined and there is no parallax to gain.
constexpr double kMinEpipoleDistancePx = 12.0;
// Binary descriptors do not survive a larger change of the viewing direction.
constexpr double kMaxParallaxRad = 0.8;
// Levels by which the scale change seen by the detector may differ from the geometry's.
constexpr double kMaxLevelDifference = 2.0;
// Orientation by intensity centroid is good to some ten degrees.
constexpr double kMaxOrientationDifference = 0.6;
// The same corner is often found on neighbouring levels: not a competitor in the ratio test.
constexpr float kSameCornerPx = 4.0F;

// A feature in coordinates of the pencil of planes through the baseline.
struct PencilFeature {
  int index = 0;
  double plane = 0.0;        // angle of the half plane about the baseline, rad
  double epipole = 0.0;      // angle between bearing and direction to camera a, rad
  double sin_epipole = 0.0;  // > 0
  double level_key = 0.0;  // equal for both views of a point: level - log(sin_epipole)/log(factor)
  double sigma = 1.0;      // px
};

// Orthonormal frame in camera b whose first axis points to the centre of a.
struct Pencil {
  Vec3d axis, u, v;

  explicit Pencil(const Vec3d& center_a_b) : axis(center_a_b.normalized()) {
    // The image centre at plane angle zero; any direction when the motion is along the optical
    // axis.
    const Vec3d forward = Vec3d::UnitZ() - axis * axis.z();
    u = forward.norm() > 1e-3 ? forward.normalized() : Vec3d(axis.unitOrthogonal());
    v = axis.cross(u);
  }
};

std::vector<PencilFeature> toPencil(const EpipolarView& view,
                                    const Mat3d& R_b_view,
                                    const Pencil& pencil,
                                    const ScaleLevels& levels) {
  std::vector<PencilFeature> result;
  result.reserve(view.features->size());
  const double log_factor = std::log(levels.factor());
  for (std::size_t i = 0; i < view.features->size(); ++i) {
    if (view.landmarks[i] != kNoLandmark || view.bearings[i].isZero()) continue;
    const Vec3d ray = R_b_view * view.bearings[i];
    const double x = ray.dot(pencil.u);
    const double y = ray.dot(pencil.v);
    const int level = view.features->feature(i).level;
    PencilFeature feature;
    feature.index = static_cast<int>(i);
    feature.plane = std::atan2(y, x);
    feature.sin_epipole = std::hypot(x, y);
    feature.epipole = std::atan2(feature.sin_epipole, ray.dot(pencil.axis));
    feature.sigma = levels.scale(level);
    feature.level_key = level - std::log(std::max(feature.sin_epipole, 1e-9)) / log_factor;
    result.push_back(feature);
  }
  return result;
}

int binOf(double plane) {
  const int bin = static_cast<int>(std::floor((plane + kPi) * kBinsPerRad));
  return ((bin % kPlaneBins) + kPlaneBins) % kPlaneBins;
}

// Features of b by plane angle; each is listed in all bins that its gate touches.
class PlaneIndex {
 public:
  // `sigma_ratio`: of a's features over b's at most.
  PlaneIndex(const std::vector<PencilFeature>& features, double sigma_ratio, double focal_px) {
    const double gate = std::sqrt(kChi2_1 * (1.0 + sigma_ratio * sigma_ratio)) / focal_px;
    forEachBin(features, gate, focal_px, [this](std::size_t bin, int) { ++start_[bin + 1]; });
    for (std::size_t bin = 0; bin < kPlaneBins; ++bin) start_[bin + 1] += start_[bin];
    items_.resize(static_cast<std::size_t>(start_[kPlaneBins]));
    std::vector<int> next(start_.begin(), start_.end() - 1);
    forEachBin(features, gate, focal_px, [&](std::size_t bin, int i) {
      items_[static_cast<std::size_t>(next[bin]++)] = i;
    });
  }

  std::span<const int> at(double plane) const {
    const auto bin = static_cast<std::size_t>(binOf(plane));
    const auto begin = static_cast<std::size_t>(start_[bin]);
    return {items_.data() + begin, static_cast<std::size_t>(start_[bin + 1]) - begin};
  }

 private:
  template <class Visit>
  static void forEachBin(const std::vector<PencilFeature>& features,
                         double gate_rad,
                         double focal_px,
                         Visit visit) {
    for (std::size_t i = 0; i < features.size(); ++i) {
      const PencilFeature& f = features[i];
      if (f.sin_epipole * focal_px < kMinEpipoleDistancePx) continue;
      const double half = std::asin(std::min(1.0, gate_rad * f.sigma / f.sin_epipole));
      const int first = static_cast<int>(std::floor((f.plane - half) * kBinsPerRad));
      const int last = static_cast<int>(std::floor((f.plane + half) * kBinsPerRad));
      for (int bin = first; bin <= last; ++bin) {
        const int wrapped = (bin + kPlaneBins / 2 + 2 * kPlaneBins) % kPlaneBins;
        visit(static_cast<std::size_t>(wrapped), static_cast<int>(i));
      }
    }
  }

  std::array<int, kPlaneBins + 1> start_{};
  std::vector<int> items_;
};

double wrappedAngle(double angle) { return std::remainder(angle, 2.0 * kPi); }

class Search {
 public:
  Search(const EpipolarView& a,
         const EpipolarView& b,
         const SE3d& T_b_a,
         const EpipolarOptions& options,
         const ScaleLevels& levels)
      : a_(a), b_(b), options_(options), R_b_a_(T_b_a.rotation()), pencil_(T_b_a.t) {
    features_a_ = toPencil(a, R_b_a_, pencil_, levels);
    features_b_ = toPencil(b, Mat3d::Identity(), pencil_, levels);
    sigma_ratio_ = std::pow(levels.factor(), kMaxLevelDifference);
    roll_ = std::atan2(R_b_a_(1, 0) - R_b_a_(0, 1), R_b_a_(0, 0) + R_b_a_(1, 1));
  }

  std::vector<Match> run() const {
    const PlaneIndex index(features_b_, sigma_ratio_, options_.focal_px);
    std::vector<int> owner(b_.features->size(), -1);  // position in `matches`
    std::vector<Match> matches;
    for (const PencilFeature& feature : features_a_) {
      const Match match = best(feature, index.at(feature.plane));
      if (match.b < 0) continue;
      int& rival = owner[static_cast<std::size_t>(match.b)];
      if (rival >= 0 && matches[static_cast<std::size_t>(rival)].distance <= match.distance)
        continue;
      if (rival >= 0) matches[static_cast<std::size_t>(rival)].b = -1;
      rival = static_cast<int>(matches.size());
      matches.push_back(match);
    }
    matches.erase(
        std::remove_if(matches.begin(), matches.end(), [](const Match& m) { return m.b < 0; }),
        matches.end());
    return matches;
  }

 private:
  // `b` < 0 when there is none, or when two corners fit almost equally well.
  Match best(const PencilFeature& feature, std::span<const int> candidates) const {
    const Descriptor& descriptor = a_.features->descriptor(static_cast<std::size_t>(feature.index));
    Match match{feature.index, -1, options_.max_distance + 1};
    int second_distance = 257;  // more than all bits
    for (const int i : candidates) {
      const PencilFeature& candidate = features_b_[static_cast<std::size_t>(i)];
      if (!isPossible(feature, candidate)) continue;
      const int distance = descriptorDistance(
          descriptor, b_.features->descriptor(static_cast<std::size_t>(candidate.index)));
      if (match.b >= 0 && isSameCorner(match.b, candidate.index)) {
        if (distance < match.distance) match = {feature.index, candidate.index, distance};
      } else if (distance < match.distance) {
        if (match.b >= 0) second_distance = match.distance;
        match = {feature.index, candidate.index, distance};
      } else {
        second_distance = std::min(second_distance, distance);
      }
    }
    if (match.distance >= options_.ratio * second_distance) match.b = -1;
    return match;
  }

  bool isPossible(const PencilFeature& a, const PencilFeature& b) const {
    const double parallax = a.epipole - b.epipole;  // the rays diverge when negative
    if (parallax < options_.min_parallax_rad || parallax > kMaxParallaxRad) return false;
    if (std::abs(a.level_key - b.level_key) > kMaxLevelDifference) return false;
    const double off_plane_px = options_.focal_px * b.sin_epipole * std::sin(a.plane - b.plane);
    if (off_plane_px * off_plane_px > kChi2_1 * (a.sigma * a.sigma + b.sigma * b.sigma))
      return false;
    const double turn = b_.features->feature(static_cast<std::size_t>(b.index)).angle -
                        a_.features->feature(static_cast<std::size_t>(a.index)).angle;
    return std::abs(wrappedAngle(turn - roll_)) < kMaxOrientationDifference;
  }

  bool isSameCorner(int i, int j) const {
    const Feature& one = b_.features->feature(static_cast<std::size_t>(i));
    const Feature& two = b_.features->feature(static_cast<std::size_t>(j));
    return (one.uv - two.uv).squaredNorm() < kSameCornerPx * kSameCornerPx;
  }

  EpipolarView a_, b_;
  EpipolarOptions options_;
  Mat3d R_b_a_;
  Pencil pencil_;
  std::vector<PencilFeature> features_a_, features_b_;
  double sigma_ratio_ = 1.0;
  double roll_ = 0.0;
};

}  // namespace

std::vector<Match> matchAlongEpipolarPlanes(const EpipolarView& a,
                                            const EpipolarView& b,
                                            const SE3d& T_b_a,
                                            const EpipolarOptions& options,
                                            const ScaleLevels& levels) {
  if (T_b_a.t.isZero()) return {};
  return Search(a, b, T_b_a, options, levels).run();
}

}  // namespace glide
