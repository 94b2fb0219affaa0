#include "session/pose_timeline.h"

#include "geometry/pose_conversion.h"

#include <algorithm>
#include <cstddef>

namespace glide {
namespace {

// Four seconds at 30 Hz: longer than any display or sensor lags behind.
constexpr std::size_t kMaxEntries = 120;
// Frames farther apart than this say nothing about the motion between them: 250 ms.
constexpr std::int64_t kMaxGap_ns = 250'000'000;

/// The pose at `share` of the way from a to b; below 0 and above 1 the motion goes on.
SE3d along(const SE3d& T_a_world, const SE3d& T_b_world, double share) {
  return SE3d::exp(share * (T_b_world * T_a_world.inverse()).log()) * T_a_world;
}

double shareOf(std::int64_t t_ns, std::int64_t begin_ns, std::int64_t end_ns) {
  return static_cast<double>(t_ns - begin_ns) / static_cast<double>(end_ns - begin_ns);
}

}  // namespace

PoseTimeline PoseTimeline::with(const Entry& entry) const {
  PoseTimeline next(generation_);
  const std::size_t skipped = entries_.size() < kMaxEntries ? 0 : entries_.size() - kMaxEntries + 1;
  next.entries_.reserve(entries_.size() - skipped + 1);
  next.entries_.assign(entries_.begin() + static_cast<std::ptrdiff_t>(skipped), entries_.end());
  next.entries_.push_back(entry);
  return next;
}

LocatedCamera PoseTimeline::at(std::int64_t t_ns, const MapSnapshot& map) const {
  LocatedCamera located;
  located.t_ns = t_ns;
  located.map_generation = generation_;
  if (entries_.empty()) return located;
  auto after = std::lower_bound(
      entries_.begin(), entries_.end(), t_ns, [](const Entry& entry, std::int64_t t) {
        return entry.t_ns < t;
      });
  const bool is_future = after == entries_.end();
  if (is_future) --after;
  const Entry& b = *after;
  const bool has_before = after != entries_.begin();
  const Entry& a = has_before ? *std::prev(after) : b;
  const bool knows_motion = has_before && a.tracked && b.tracked && b.t_ns - a.t_ns <= kMaxGap_ns;
  const SE3d T_b_world = b.pose.T_cam_world(map);
  SE3d T_cam_world = T_b_world;
  if (knows_motion)
    T_cam_world = along(a.pose.T_cam_world(map), T_b_world, shareOf(t_ns, a.t_ns, b.t_ns));
  const bool is_at_frame = b.t_ns == t_ns && b.tracked;
  const bool is_near = !is_future || t_ns - b.t_ns <= kMaxExtrapolation_ns;
  located.tracked = is_at_frame || (knows_motion && !is_future);
  located.valid = located.tracked || (is_future && is_near && b.tracked);
  located.T_world_cam = toPose((located.valid ? T_cam_world : T_b_world).inverse());
  return located;
}

}  // namespace glide
