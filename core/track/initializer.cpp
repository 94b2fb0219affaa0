#include "track/initializer.h"

#include "feature/patch_alignment.h"

#include "base/median.h"

#include <cmath>
#include <numbers>
#include <utility>

namespace glide {
namespace {

/// Turn of the image from the first set to the other: the median over the matches.
Eigen::Matrix2f rotationBetween(const FeatureSet& first,
                                const FeatureSet& now,
                                const std::vector<Match>& matches) {
  std::vector<double> turns;
  for (const Match& match : matches) {
    const float turn = now.feature(static_cast<std::size_t>(match.b)).angle -
                       first.feature(static_cast<std::size_t>(match.a)).angle;
    turns.push_back(std::remainder(static_cast<double>(turn), 2.0 * std::numbers::pi));
  }
  const double turn = median(std::move(turns), 0.0);
  return Eigen::Rotation2Df(static_cast<float>(turn)).toRotationMatrix();
}

/// Gives the points' median depth in the first view its unit.
void normaliseDepth(double median_depth, InitialMap* map) {
  std::vector<double> depths;
  for (const InitialMap::Point& point : map->points) depths.push_back(point.p_world.z());
  const double scale = median_depth / median(std::move(depths), median_depth);
  for (InitialMap::Point& point : map->points) point.p_world *= scale;
  map->b.T_cam_world.t *= scale;
}

}  // namespace

Initializer::Initializer(const Config& config, const CameraModel& camera)
    : config_(config),
      camera_(camera),
      levels_(config.features.scale_factor, config.features.levels),
      tracks_(camera) {}

void Initializer::reset() {
  first_ = InitialMap::View();
  tracks_.reset();
  progress_ = InitializationProgress();
}

void Initializer::start(std::int64_t t_ns, std::shared_ptr<const FeatureSet> features) {
  first_ = InitialMap::View();
  first_.t_ns = t_ns;
  first_.features = features;
  tracks_.start(std::move(features));
  age_frames_ = 0;
}

std::vector<FeatureMove> Initializer::alignMatches(const FeatureSet& features,
                                                   const std::vector<Match>& matches) const {
  const Eigen::Matrix2f R_now_first = rotationBetween(*first_.features, features, matches);
  std::vector<FeatureMove> moves;
  for (const Match& match : matches) {
    const auto i = static_cast<std::size_t>(match.a);
    const auto j = static_cast<std::size_t>(match.b);
    const double scale_first = levels_.scale(first_.features->feature(i).level);
    const double scale_now = levels_.scale(features.feature(j).level);
    const Eigen::Matrix2f A_now_first = R_now_first * static_cast<float>(scale_first / scale_now);
    const std::optional<Vec2f> offset =
        alignPatch(first_.features->patch(i), features.patch(j), A_now_first);
    if (!offset) continue;
    const Vec2f moved = (*offset - features.patch(j).offset) * static_cast<float>(scale_now);
    moves.push_back({match.b, features.feature(j).uv + moved, *offset});
  }
  return moves;
}

std::optional<InitialMap> Initializer::update(std::int64_t t_ns,
                                              std::shared_ptr<const FeatureSet> features) {
  progress_ = InitializationProgress();
  const auto& options = config_.initialization;
  if (static_cast<int>(features->size()) < options.min_matches) {
    first_ = InitialMap::View();
    return std::nullopt;
  }
  if (!first_.features || ++age_frames_ > options.max_reference_age) {
    start(t_ns, std::move(features));
    progress_.status = InitializationStatus::too_little_motion;
    return std::nullopt;
  }
  const std::vector<Match> matches = tracks_.follow(*features);
  progress_.matches = static_cast<int>(matches.size());
  if (progress_.matches < options.min_matches) {
    start(t_ns, std::move(features));
    progress_.status = InitializationStatus::too_few_matches;
    return std::nullopt;
  }
  features =
      std::make_shared<const FeatureSet>(features->withMoved(alignMatches(*features, matches)));
  std::vector<PixelPair> pairs;
  for (const Match& match : matches)
    pairs.push_back({first_.features->feature(static_cast<std::size_t>(match.a)).uv.cast<double>(),
                     features->feature(static_cast<std::size_t>(match.b)).uv.cast<double>()});
  TwoViewOptions two_view;
  two_view.sigma_px = options.sigma_px;
  two_view.min_points = options.min_landmarks;
  two_view.min_parallax_deg = options.min_parallax_deg;
  const TwoViewResult result = solveTwoView(camera_, pairs, two_view);
  report(result);
  if (result.status != InitializationStatus::done) return std::nullopt;
  InitialMap::View second;
  second.t_ns = t_ns;
  second.features = std::move(features);
  second.T_cam_world = result.T_b_a;
  return makeMap(result, matches, second);
}

void Initializer::report(const TwoViewResult& result) {
  progress_.status = result.status;
  progress_.parallax_deg = result.parallax_deg;
  progress_.landmarks = result.landmarks;
}

InitialMap Initializer::makeMap(const TwoViewResult& result,
                                const std::vector<Match>& matches,
                                const InitialMap::View& second) const {
  InitialMap map;
  map.a = first_;
  map.b = second;
  for (std::size_t i = 0; i < matches.size(); ++i)
    if (result.triangulated[i])
      map.points.push_back({result.points_a[i], matches[i].a, matches[i].b});
  normaliseDepth(config_.initialization.median_depth, &map);
  return map;
}

}  // namespace glide
