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
// After a loss any place is possible: twice the evidence, and much of what should be in view.
constexpr int kLostInlierFactor = 2;
constexpr double kMinLostConfidence = 0.25;
constexpr LocalMapLimits kLocal{20, 2500};
constexpr MatchOptions kRecoveryMatch{60, 0.8, true};

double windowOf(GuessQuality quality) {
  return quality == GuessQuality::aligned ? kAlignedWindow : kPredictedWindow;
}

}  // namespace

IndirectTracker::IndirectTracker(const Config& config, const CameraModel& camera)
    : config_(config),
      given_camera_(camera),
      camera_(camera),
      extractor_(config.features),
      levels_(config.features.scale_factor, config.features.levels),
      search_(config, camera) {}

std::shared_ptr<const FeatureSet> IndirectTracker::extract(const ImageViewU8& luma, int count) {
  return std::make_shared<const FeatureSet>(extractor_.extract(luma, count));
}

TrackedFrame IndirectTracker::track(const Frame& frame,
                                    const ImageViewU8& luma,
                                    const IndirectGuess& guess) {
  Stopwatch watch;
  const auto features = extract(luma, config_.features.count);
  const double features_ms = watch.lapMs();
  TrackedFrame tracked = track(frame, features, guess);
  tracked.stats.features_ms = features_ms;
  return tracked;
}

TrackedFrame IndirectTracker::track(const Frame& frame,
                                    const std::shared_ptr<const FeatureSet>& features,
                                    const IndirectGuess& guess) {
  TrackedFrame tracked;
  tracked.T_cam_world = guess.T_cam_world;
  tracked.features = features;
  Stopwatch watch;
  useCameraOf(*frame.map);
  search_.beginFrame();
  Attempt attempt = searchAround(frame, *features, guess);
  if (attempt.matches.count < kMinFirstMatches) attempt = recover(frame, *features, guess);
  tracked.stats.pose_ms = watch.lapMs();
  if (attempt.matches.count < kMinFirstMatches || !attempt.pose.valid) return tracked;

  const LocalMap local = widen(frame, *features, &attempt);
  tracked.stats.match_ms = watch.lapMs();
  attempt.pose = search_.refine(attempt.pose.T_cam_world, *features, &attempt.matches);
  if (attempt.pose.valid) tracked.features = alignCorners(frame, features, &attempt);
  tracked.stats.pose_ms += watch.lapMs();
  if (!attempt.pose.valid) return tracked;
  report(frame, attempt, local, &tracked);
  tracked.ok = isEnough(tracked, guess.quality);
  if (tracked.ok) {
    recent_ = tracked.landmarks;
  } else {
    tracked.features = features;  // not moved towards landmarks that may be the wrong ones
  }
  return tracked;
}

bool IndirectTracker::isEnough(const TrackedFrame& tracked, GuessQuality quality) const {
  const int needed = config_.indirect.min_inliers;
  if (quality != GuessQuality::lost) return tracked.tracked_landmarks >= needed;
  return tracked.tracked_landmarks >= kLostInlierFactor * needed &&
         tracked.confidence >= kMinLostConfidence;
}

void IndirectTracker::useCameraOf(const MapSnapshot& map) {
  camera_ = map.cameraOr(given_camera_);
  search_.useCamera(camera_);
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

std::vector<const MapSnapshot::LandmarkEntry*> IndirectTracker::seeds(
    const MapSnapshot& map, const IndirectGuess& guess) const {
  const MapSnapshot::KeyframeEntry* reference = map.keyframe(guess.reference);
  if (guess.quality == GuessQuality::lost && reference != nullptr)
    return collectLocalMap(map, reference->landmarks, kLocal).landmarks;
  std::vector<const MapSnapshot::LandmarkEntry*> recent = landmarksOf(map, recent_);
  if (static_cast<int>(recent.size()) >= 2 * config_.indirect.min_inliers || reference == nullptr)
    return recent;
  return landmarksOf(map, reference->landmarks);
}

IndirectTracker::Attempt IndirectTracker::searchAround(const Frame& frame,
                                                       const FeatureSet& features,
                                                       const IndirectGuess& guess) {
  const std::vector<const MapSnapshot::LandmarkEntry*> first = seeds(*frame.map, guess);
  Attempt attempt;
  for (const double window : {windowOf(guess.quality), kRetryWindow}) {
    attempt = Attempt();
    search_.extend(first,
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
