#include "render/camera_trails.h"

#include <algorithm>

namespace glide {
namespace {

constexpr std::int64_t kFirstPicture = 1;

std::size_t slotOf(std::int64_t picture) {
  return static_cast<std::size_t>(picture) % (PointTrails::kLength + 1);
}

bool isSamePlace(const TrackedPoint& a, const TrackedPoint& b) {
  return a.landmark == b.landmark && a.u == b.u && a.v == b.v;
}

}  // namespace

bool PointTrails::isLastPicture(std::span<const TrackedPoint> points) const {
  return std::equal(points.begin(), points.end(), last_.begin(), last_.end(), isSamePlace);
}

void PointTrails::add(std::span<const TrackedPoint> points) {
  // Without points it is not known whether it is the same picture: while lost, pictures go on.
  if (!points.empty() && isLastPicture(points)) return;
  last_.assign(points.begin(), points.end());
  ++picture_;
  for (const TrackedPoint& point : points)
    landmarks_[point.landmark][slotOf(picture_)] = {{point.u, point.v}, picture_};
  forgetOld();
}

void PointTrails::forgetOld() {
  const std::int64_t oldest = picture_ - static_cast<std::int64_t>(kLength);
  for (auto it = landmarks_.begin(); it != landmarks_.end();) {
    const Samples& samples = it->second;
    const bool is_gone = std::all_of(samples.begin(), samples.end(), [&](const Sample& sample) {
      return sample.picture < oldest;
    });
    it = is_gone ? landmarks_.erase(it) : std::next(it);
  }
}

PointTrails::Trail PointTrails::of(std::uint64_t landmark) const {
  Trail trail;
  const auto found = landmarks_.find(landmark);
  if (found == landmarks_.end()) return trail;
  for (std::size_t back = 0; back <= kLength; ++back) {
    const std::int64_t picture = picture_ - static_cast<std::int64_t>(back);
    if (picture < kFirstPicture) break;
    const Sample& sample = found->second[slotOf(picture)];
    if (sample.picture == picture) trail.uv[trail.count++] = sample.uv;
  }
  return trail;
}

}  // namespace glide
