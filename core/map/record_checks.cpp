#include "map/record_checks.h"

#include <cmath>

namespace glide {
namespace {

// Lengths up to here can be squared and multiplied without overflow; no scene comes near.
constexpr double kMaxLength = 1e100;
// Far more than rounding leaves, far less than an error.
constexpr double kUnitTolerance = 1e-6;
// Half of all ids: new ones can be given for ever.
constexpr std::uint64_t kMaxId = ~std::uint64_t{0} / 2;
// A corner lies inside of its patch.
constexpr float kMaxPatchOffset = FeaturePatch::kSize / 2.0F;

// All of them are false for NaN.
bool isCoordinate(double value) { return std::abs(value) <= kMaxLength; }
bool isDistance(double value) { return value >= 0.0 && value <= kMaxLength; }
bool isScale(double value) { return value >= 1.0 / kMaxLength && value <= kMaxLength; }
bool isPoint(const Vec3d& p) {
  return isCoordinate(p.x()) && isCoordinate(p.y()) && isCoordinate(p.z());
}
bool isCount(std::int32_t count) { return count >= 0 && count <= LandmarkRecord::kMaxCount; }

MapFault checkPlacement(std::uint64_t id, const SE3d& pose, double scale) {
  if (id > kMaxId) return "the id is too large";
  if (!isPoint(pose.t)) return "the position is not finite";
  if (!(std::abs(pose.q.squaredNorm() - 1.0) <= kUnitTolerance)) {
    return "the rotation is not a unit quaternion";
  }
  if (!isScale(scale)) return "the scale is not positive and finite";
  return std::nullopt;
}

}  // namespace

MapFault checkKeyframe(const KeyframeRecord& record) {
  if (record.has_patches > 1 || (record.has_patches == 1 && record.features == 0)) {
    return "the mark of patches is neither 0 nor 1, or there is no feature to have one";
  }
  return checkPlacement(record.id, record.T_cam_world, record.scale);
}

MapFault checkRetired(const RetiredRecord& record) {
  return checkPlacement(record.id, record.T_cam_parent, record.scale);
}

MapFault checkLandmark(const LandmarkRecord& record) {
  if (record.id > kMaxId) return "the id is too large";
  if (!isPoint(record.p_world)) return "the position is not finite";
  if (!(record.normal.squaredNorm() <= 1.0 + kUnitTolerance)) {
    return "the normal is longer than one";
  }
  if (!isDistance(record.min_distance) || !isDistance(record.max_distance) ||
      record.min_distance > record.max_distance) {
    return "the range of distances is impossible";
  }
  if (!isCount(record.visible_count) || !isCount(record.found_count)) {
    return "a count is out of range";
  }
  return std::nullopt;
}

MapFault checkFeature(const FeatureRecord& record, const MapHeader& header) {
  const Feature& feature = record.feature;
  // Pixels are centred on whole numbers.
  const float right = static_cast<float>(header.camera.width) - 0.5F;
  const float bottom = static_cast<float>(header.camera.height) - 0.5F;
  const bool is_inside = feature.uv.x() >= -0.5F && feature.uv.y() >= -0.5F &&
                         feature.uv.x() <= right && feature.uv.y() <= bottom;
  if (!is_inside) return "the corner lies outside of the image";
  if (!std::isfinite(feature.angle) || !std::isfinite(feature.response)) {
    return "the angle or the response is not finite";
  }
  if (feature.level >= header.level_count) return "there is no such scale level";
  if (record.landmark != FeatureRecord::kNone &&
      record.landmark >= header.count(MapSection::landmarks)) {
    return "landmark index " + std::to_string(record.landmark) + " is out of range";
  }
  return std::nullopt;
}

MapFault checkPatch(const PatchRecord& record) {
  const Vec2f& offset = record.patch.offset;
  if (std::abs(offset.x()) <= kMaxPatchOffset && std::abs(offset.y()) <= kMaxPatchOffset) {
    return std::nullopt;
  }
  return "the corner lies outside of its patch";
}

}  // namespace glide
