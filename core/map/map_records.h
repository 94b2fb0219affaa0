#pragma once

#include "feature/feature_set.h"

#include "geometry/lie.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

namespace glide {

// The records of a map file (docs/map-format.md). Each has one function fields(), which names its
// numbers in the file's order: ByteWriter, ByteReader and ByteCounter go through the same list, so
// that what is written and what is read cannot differ.

/// Counts the bytes of a record.
class ByteCounter {
 public:
  template <class Number>
  void operator()(const Number&) {
    bytes_ += sizeof(Number);
  }
  void operator()(std::span<std::uint8_t> block) { bytes_ += block.size(); }
  std::size_t bytes() const { return bytes_; }

 private:
  std::size_t bytes_ = 0;
};

template <class Stream, class Vector>
void vectorFields(Stream& stream, Vector& vector) {
  for (Eigen::Index i = 0; i < vector.size(); ++i) stream(vector[i]);
}

template <class Stream>
void poseFields(Stream& stream, SE3d& pose) {
  vectorFields(stream, pose.q.coeffs());  // x, y, z, w
  vectorFields(stream, pose.t);
}

struct KeyframeRecord {
  std::uint64_t id = 0;
  std::int64_t t_ns = 0;
  SE3d T_cam_world;
  double scale = 1.0;
  std::uint32_t features = 0;     ///< that many records of the feature section are its own
  std::uint32_t has_patches = 0;  ///< 0 or 1

  template <class Stream>
  void fields(Stream& stream) {
    stream(id);
    stream(t_ns);
    poseFields(stream, T_cam_world);
    stream(scale);
    stream(features);
    stream(has_patches);
  }
};

struct FeatureRecord {
  /// FeatureRecord::landmark of a feature that observes none.
  static constexpr std::uint32_t kNone = 0xFFFFFFFF;

  Feature feature;
  std::uint32_t landmark = kNone;  ///< index into the landmark section
  Descriptor descriptor{};

  template <class Stream>
  void fields(Stream& stream) {
    vectorFields(stream, feature.uv);
    stream(feature.angle);
    stream(feature.response);
    stream(feature.level);
    stream(landmark);
    for (std::uint64_t& word : descriptor) stream(word);
  }
};

struct PatchRecord {
  FeaturePatch patch;

  template <class Stream>
  void fields(Stream& stream) {
    vectorFields(stream, patch.offset);
    stream(std::span<std::uint8_t>(patch.pixels));
  }
};

struct LandmarkRecord {
  /// Of frames. Seven months at 30 Hz, and two of them fused do not overflow.
  static constexpr std::int32_t kMaxCount = 1 << 29;

  std::uint64_t id = 0;
  Vec3d p_world = Vec3d::Zero(), normal = Vec3d::Zero();
  double min_distance = 0.0, max_distance = 0.0;
  Descriptor descriptor{};
  std::uint64_t first_keyframe = 0;
  std::int32_t visible_count = 0, found_count = 0;

  template <class Stream>
  void fields(Stream& stream) {
    stream(id);
    vectorFields(stream, p_world);
    vectorFields(stream, normal);
    stream(min_distance);
    stream(max_distance);
    for (std::uint64_t& word : descriptor) stream(word);
    stream(first_keyframe);
    stream(visible_count);
    stream(found_count);
  }
};

struct RetiredRecord {
  std::uint64_t id = 0;
  std::int64_t t_ns = 0;
  SE3d T_cam_parent;
  double scale = 1.0;
  std::uint32_t parent = 0;  ///< index into the keyframe section

  template <class Stream>
  void fields(Stream& stream) {
    stream(id);
    stream(t_ns);
    poseFields(stream, T_cam_parent);
    stream(scale);
    stream(parent);
  }
};

struct LoopRecord {
  std::uint32_t newer = 0, older = 0;  ///< indices into the keyframe section

  template <class Stream>
  void fields(Stream& stream) {
    stream(newer);
    stream(older);
  }
};

template <class Record>
std::size_t bytesOf() {
  Record record;
  ByteCounter counter;
  record.fields(counter);
  return counter.bytes();
}

}  // namespace glide
