#include "loop/drift.h"

#include "base/median.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace glide {
namespace {

// A path of which every metre is measured a few percent wrong, and bends, ends this far off.
constexpr double kMaxGapShare = 0.2;
// What short paths may be off, as share of the depth seen: poses are never better than this.
constexpr double kMaxGapDepths = 0.05;
constexpr double kMaxScale = 2.0;
constexpr double kMaxRotation = 0.7;  // radians

double medianDepth(const MapSnapshot::KeyframeEntry& keyframe, const MapSnapshot& map) {
  std::vector<double> depths;
  for (const LandmarkId id : keyframe.landmarks) {
    const MapSnapshot::LandmarkEntry* landmark = map.landmark(id);
    if (landmark != nullptr) depths.push_back((keyframe.T_cam_world * landmark->p_world).norm());
  }
  return median(std::move(depths), 0.0);
}

}  // namespace

bool isPlausibleDrift(const MeasuredLink& link,
                      const MapSnapshot& map,
                      const KeyframeGraph& graph) {
  const MapSnapshot::KeyframeEntry* from = map.keyframe(link.from);
  const MapSnapshot::KeyframeEntry* to = map.keyframe(link.to);
  if (from == nullptr || to == nullptr) return false;
  const SE3d T_from_to = from->T_cam_world * to->T_cam_world.inverse();
  const double growth = std::max(link.S_from_to.s, 1.0 / link.S_from_to.s);
  const double rotation = so3Log(link.S_from_to.q * T_from_to.q.conjugate()).norm();
  if (growth > kMaxScale || rotation > kMaxRotation) return false;
  const double gap = (link.S_from_to.t - T_from_to.t).norm();
  const double path = graph.pathLength(link.from, link.to);
  return gap <= kMaxGapShare * path + kMaxGapDepths * medianDepth(*from, map);
}

}  // namespace glide
