#include "loop/loop_closer.h"

#include "loop/drift.h"
#include "loop/keyframe_graph.h"
#include "loop/loop_correction.h"
#include "loop/loop_detector.h"
#include "loop/loop_fusion.h"
#include "loop/loop_verifier.h"

#include "base/cancel.h"

#include <cstddef>
#include <utility>
#include <vector>

namespace glide {
namespace {

// Keyframes after a loop in which none is looked for: its correction is on the way, or those that
// follow see the old landmarks by now.
constexpr int kRestKeyframes = 10;
// A rival with this share of the best place's matches makes the place ambiguous.
constexpr double kRivalShare = 0.5;

/// Where the rival's older keyframe lies for the best one's, if both are right.
MeasuredLink between(const LoopGeometry& best, const LoopGeometry& rival) {
  return {best.older, rival.older, best.S_newer_older.inverse() * rival.S_newer_older};
}

}  // namespace

struct LoopCloser::Impl {
  CameraModel camera;
  ScaleLevels levels;
  LoopDetector detector;
  int rest = 0;  ///< keyframes until loops are looked for again

  Impl(const Config& config, const CameraModel& camera_in)
      : camera(camera_in), levels(config.features.scale_factor, config.features.levels) {}

  std::vector<LoopGeometry> measure(const MapSnapshot::KeyframeEntry& keyframe,
                                    const std::vector<KeyframeId>& places,
                                    const MapSnapshot& map) const {
    const LoopVerifier verifier(map.cameraOr(camera), levels);
    std::vector<LoopGeometry> measured;
    for (const KeyframeId place : places) {
      auto geometry = verifier.verify(keyframe, *map.keyframe(place), map);
      if (geometry) measured.push_back(std::move(*geometry));
    }
    return measured;
  }
};

namespace {

/// The place with the most matches; nothing when it is not beyond doubt, asks for more than drift,
/// or when another one fits nearly as well that cannot be right too.
const LoopGeometry* chooseLoop(const std::vector<LoopGeometry>& measured,
                               const MapSnapshot& map,
                               const KeyframeGraph& graph) {
  const LoopGeometry* best = nullptr;
  for (const LoopGeometry& geometry : measured) {
    if (best == nullptr || geometry.matches.size() > best->matches.size()) best = &geometry;
  }
  if (best == nullptr || !isBeyondDoubt(*best)) return nullptr;
  if (!isPlausibleDrift({best->newer, best->older, best->S_newer_older}, map, graph)) {
    return nullptr;
  }
  const double rival_matches = kRivalShare * static_cast<double>(best->matches.size());
  for (const LoopGeometry& rival : measured) {
    if (&rival == best || static_cast<double>(rival.matches.size()) < rival_matches) continue;
    if (!isPlausibleDrift(between(*best, rival), map, graph)) return nullptr;
  }
  return best;
}

}  // namespace

LoopCloser::LoopCloser(const Config& config, const CameraModel& camera)
    : impl_(std::make_unique<Impl>(config, camera)) {}

LoopCloser::~LoopCloser() = default;

std::optional<LoopCorrection> LoopCloser::close(KeyframeId keyframe,
                                                const MapSnapshot& map,
                                                const PlaceIndex& index,
                                                const std::atomic<bool>* cancel) {
  const MapSnapshot::KeyframeEntry* newer = map.keyframe(keyframe);
  if (newer == nullptr) return std::nullopt;
  if (impl_->rest > 0) {
    --impl_->rest;
    return std::nullopt;
  }
  const KeyframeGraph graph(map);
  const std::vector<KeyframeId> places = impl_->detector.detect(*newer, map, graph, index);
  if (places.empty() || isCancelled(cancel)) return std::nullopt;
  const std::vector<LoopGeometry> measured = impl_->measure(*newer, places, map);
  const LoopGeometry* loop = chooseLoop(measured, map, graph);
  if (loop == nullptr || isCancelled(cancel)) return std::nullopt;
  std::optional<std::vector<KeyframeMove>> moves = bendMap(*loop, map, graph, cancel);
  if (!moves) return std::nullopt;

  LoopCorrection correction;
  correction.snapshot = {map.generation(), map.corrections()};
  correction.edge = {loop->newer, loop->older};
  correction.keyframes = std::move(*moves);
  correction.same = findSamePoints(map.cameraOr(impl_->camera), impl_->levels, *loop, map);
  impl_->detector.reset();
  impl_->rest = kRestKeyframes;
  return correction;
}

void LoopCloser::reset() {
  impl_->detector.reset();
  impl_->rest = 0;
}

}  // namespace glide
