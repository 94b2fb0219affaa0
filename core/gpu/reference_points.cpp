#include "gpu/reference_points.h"

#include <algorithm>

namespace glide {
namespace {

constexpr std::size_t kPointFloats = 4;  // xyz and padding

}  // namespace

ReferencePoints ReferencePoints::allocate(int max_points) {
  ReferencePoints points;
  points.staging_.resize(static_cast<std::size_t>(max_points) * kPointFloats);
  points.buffer_ = GlBuffer::allocate(
      static_cast<std::int64_t>(points.staging_.size() * sizeof(float)), GL_DYNAMIC_DRAW);
  return points;
}

void ReferencePoints::set(std::span<const AlignPoint> points_ref) {
  points_ref = points_ref.first(std::min(points_ref.size(), staging_.size() / kPointFloats));
  count_ = static_cast<int>(points_ref.size());
  if (points_ref.empty()) return;
  for (std::size_t i = 0; i < points_ref.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) {
      staging_[i * kPointFloats + c] =
          static_cast<float>(points_ref[i].p_ref[static_cast<Eigen::Index>(c)]);
    }
  }
  buffer_.write(staging_.data(),
                static_cast<std::int64_t>(points_ref.size() * kPointFloats * sizeof(float)));
}

}  // namespace glide
