#include "track/indirect_tracker.h"

#include "track/match_refinement.h"

#include "base/median.h"
#include "base/stopwatch.h"
#include "geometry/pnp.h"

#include <algorithm>
#include <unordered_set>
#include <utility>

namespace glide {
namespace {

// Search windows in multiples of Config::Indirect::search_radius_px. A pose by direct alignment is
// good to a few pixels; a constant-velocity guess on a hand-held camera is off by tens.
constexpr double kAlignedWindow = 1.0;
constexpr double kPredictedWindow = 2.5;
constexpr double kRetryWindow = 6.0;
// Once the pose is refined the remaining landmarks project to within the noise of features and map.
constexpr double kRefinedWindow = 0.7;
// Matches that make a first pose worth refining with the whole local map.
constexpr int kMinFirstMatches = 15;
constexpr LocalMapLimits kLocal{20, 2500};
constexpr MatchOptions kRecoveryMatch{60, 0.8, true};

double windowOf(GuessQuality quality) {
  return quality == GuessQuality::aligned ? kAlignedWindow : kPredictedWindow;
}

}  // namespace

IndirectTracker::IndirectTracker(const Config& config, const CameraModel& camera)
    : config_(config),
      camera_(camera),
      extractor_(config.features),
      levels_(config.features.scale_factor, config.features.levels),
      search_(config, camera) {}

std::shared_ptr<const FeatureSet> IndirectTracker::extract(const ImageViewU8& luma, int count) {
  return std::make_shared<const FeatureSet>(extractor_.extract(luma, count));
}

TrackedFrame IndirectTracker::track(const Frame& frame, const IndirectGuess& guess) {
  TrackedFrame tracked;
  tracked.T_cam_world = guess.T_cam_world;
  Stopwatch watch;
  tracked.features = extract(frame.luma, config_.features.count);
  tracked.stats.features_ms = watch.lapMs();

  search_.beginFrame();
  Attempt attempt = searchAround(frame, *tracked.features, guess);
  if (attempt.matches.count < kMinFirstMatches) attempt = recover(frame, *tracked.features, guess);
  tracked.stats.pose_ms = watch.lapMs();
  if (attempt.matches.count < kMinFirstMatches || !attempt.pose.valid) return tracked;

  const LocalMap local = widen(frame, *tracked.features, &attempt);
  tracked.stats.match_ms = watch.lapMs();
  attempt.pose = search_.refine(attempt.pose.T_cam_world, *tracked.features, &attempt.matches);
  if (attempt.pose.valid) tracked.features = alignCorners(frame, tracked.features, &attempt);
  tracked.stats.pose_ms += watch.lapMs();
  if (!attempt.pose.valid) return tracked;
  report(frame, attempt, local, &tracked);
  if (tracked.ok) recent_ = tracked.landmarks;
  return tracked;
}

LocalMap IndirectTracker::widen(const Frame& frame, const FeatureSet& features, Attempt* attempt) {
  std::vector<LandmarkId> seen;
  for (const MapSnapshot::LandmarkEntry* landmark : attempt->matches.of_feature)
    if (landmark != nullptr) seen.push_back(landmark->id);
  LocalMapLimits limits = kLocal;
  limits.max_landmarks = config_.indirect.max_local_landmarks;
  LocalMap local = collectLocalMap(*frame.map, seen, limits);
  search_.beginFrame();
  search_.extend(local.landmarks,
                 features,
                 {attempt->pose.T_cam_world,
                  kRefinedWindow * config_.indirect.search_radius_px,
                  config_.indirect.max_descriptor_distance},
                 &attempt->matches);
  return local;
}

std::shared_ptr<const FeatureSet> IndirectTracker::alignCorners(
    const Frame& frame, const std::shared_ptr<const FeatureSet>& features, Attempt* attempt) const {
  const std::vector<FeatureMove> moves = refineMatches(
      {&camera_, &levels_}, *frame.map, attempt->pose.T_cam_world, *features, attempt->matches);
  auto aligned = std::make_shared<const FeatureSet>(features->withMoved(moves));
  attempt->pose = search_.refine(attempt->pose.T_cam_world, *aligned, &attempt->matches);
  return aligned;
}

IndirectTracker::Attempt IndirectTracker::searchAround(const Frame& frame,
                                                       const FeatureSet& features,
                                                       const IndirectGuess& guess) {
  std::vector<const MapSnapshot::LandmarkEntry*> seeds = landmarksOf(*frame.map, recent_);
  const MapSnapshot::KeyframeEntry* reference = frame.map->keyframe(guess.reference);
  if (static_cast<int>(seeds.size()) < 2 * config_.indirect.min_inliers && reference != nullptr)
    seeds = landmarksOf(*frame.map, reference->landmarks);

  Attempt attempt;
  for (const double window : {windowOf(guess.quality), kRetryWindow}) {
    attempt = Attempt();
    search_.extend(seeds,
                   features,
                   {guess.T_cam_world,
                    window * config_.indirect.search_radius_px,
                    config_.indirect.max_descriptor_distance},
                   &attempt.matches);
    if (attempt.matches.count < kMinFirstMatches) continue;
    attempt.pose = search_.refine(guess.T_cam_world, features, &attempt.matches);
    if (attempt.pose.valid && attempt.matches.count >= config_.indirect.min_inliers) break;
  }
  if (!attempt.pose.valid) attempt.matches.count = 0;
  return attempt;
}

IndirectTracker::Attempt IndirectTracker::recover(const Frame& frame,
                                                  const FeatureSet& features,
                                                  const IndirectGuess& guess) {
  Attempt attempt;
  const MapSnapshot::KeyframeEntry* reference = frame.map->keyframe(guess.reference);
  if (reference == nullptr) return attempt;
  std::vector<int> subset;
  for (std::size_t i = 0; i < reference->landmarks.size(); ++i)
    if (frame.map->landmark(reference->landmarks[i]) != nullptr)
      subset.push_back(static_cast<int>(i));
  if (subset.empty()) return attempt;

  const std::vector<Match> matches =
      matchBruteForce(*reference->features, subset, features, kRecoveryMatch);
  std::vector<PointPixel> points;
  for (const Match& match : matches) {
    const LandmarkId id = reference->landmarks[static_cast<std::size_t>(match.a)];
    points.push_back({frame.map->landmark(id)->p_world,
                      features.feature(static_cast<std::size_t>(match.b)).uv.cast<double>()});
  }
  const std::optional<PnpResult> pnp = solvePnp(camera_, points, PnpOptions{});
  if (!pnp) return attempt;
  attempt.matches.of_feature.resize(features.size(), nullptr);
  for (std::size_t k = 0; k < matches.size(); ++k) {
    if (!pnp->inlier[k]) continue;
    const LandmarkId id = reference->landmarks[static_cast<std::size_t>(matches[k].a)];
    attempt.matches.of_feature[static_cast<std::size_t>(matches[k].b)] = frame.map->landmark(id);
    ++attempt.matches.count;
  }
  attempt.pose = search_.refine(pnp->T_cam_world, features, &attempt.matches);
  return attempt;
}

void IndirectTracker::report(const Frame& frame,
                             const Attempt& attempt,
                             const LocalMap& local,
                             TrackedFrame* tracked) const {
  tracked->tracker = TrackerKind::indirect;
  tracked->T_cam_world = attempt.pose.T_cam_world;
  tracked->pose = anchorTo(local.reference, attempt.pose.T_cam_world, *frame.map);
  tracked->ok = attempt.matches.count >= config_.indirect.min_inliers;
  tracked->tracked_landmarks = attempt.matches.count;
  tracked->reference_landmarks = local.reference_landmarks;
  tracked->stats.inliers = attempt.matches.count;
  tracked->stats.rms = attempt.pose.rms_px;
  std::vector<double> depths;
  for (const MapSnapshot::LandmarkEntry* landmark : attempt.matches.of_feature) {
    tracked->landmarks.push_back(landmark != nullptr ? landmark->id : kNoLandmark);
    if (landmark == nullptr) continue;
    tracked->sightings.push_back({landmark->id, 1, 1});
    depths.push_back((tracked->T_cam_world * landmark->p_world).z());
  }
  tracked->median_depth = median(std::move(depths), 1.0);
  const std::unordered_set<const MapSnapshot::LandmarkEntry*> found(
      attempt.matches.of_feature.begin(), attempt.matches.of_feature.end());
  for (const MapSnapshot::LandmarkEntry* landmark : search_.visible())
    if (found.count(landmark) == 0) tracked->sightings.push_back({landmark->id, 1, 0});
  tracked->stats.visible = static_cast<int>(tracked->sightings.size());
  tracked->confidence =
      static_cast<double>(attempt.matches.count) / std::max(tracked->stats.visible, 1);
}

}  // namespace glide
