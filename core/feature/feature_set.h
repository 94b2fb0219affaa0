#pragma once

#include "geometry/eigen_types.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace glide {

/// 256-bit binary descriptor.
using Descriptor = std::array<std::uint64_t, 4>;

/// Number of differing bits, 0..256.
int descriptorDistance(const Descriptor& a, const Descriptor& b);

/// A corner in level-0 pixels of the distorted image.
struct Feature {
  Vec2f uv;
  float angle = 0.0F;      ///< radians, orientation by intensity centroid
  float response = 0.0F;   ///< corner score
  std::uint8_t level = 0;  ///< scale level of the extractor
};

/// The pixels around a corner on its own scale level: what sub-pixel alignment between frames
/// needs.
struct FeaturePatch {
  static constexpr int kSize = 16;
  std::array<std::uint8_t, kSize * kSize> pixels{};
  Vec2f offset = Vec2f::Zero();  ///< of the corner from the pixel centre(), level px

  static Vec2f centre() { return {kSize / 2.0F, kSize / 2.0F}; }
  /// The corner in patch pixels.
  Vec2f corner() const { return centre() + offset; }
};

/// A corner that was located better.
struct FeatureMove {
  int feature = 0;
  Vec2f uv;            ///< level-0 px
  Vec2f patch_offset;  ///< FeaturePatch::offset, level px
};

/// The features of one frame with a grid for radius queries. Immutable once built; shared between
/// threads as shared_ptr<const FeatureSet>.
class FeatureSet {
 public:
  FeatureSet() = default;
  /// `features` and `descriptors` have the same length; width and height are the image's, px.
  FeatureSet(std::vector<Feature> features,
             std::vector<Descriptor> descriptors,
             int width,
             int height);

  /// The same features with patches, one each.
  FeatureSet withPatches(std::vector<FeaturePatch> patches) &&;
  /// A copy in which some corners lie elsewhere. Needs patches.
  FeatureSet withMoved(std::span<const FeatureMove> moves) const;

  std::size_t size() const { return features_.size(); }
  const std::vector<Feature>& features() const { return features_; }
  const std::vector<Descriptor>& descriptors() const { return descriptors_; }
  const Feature& feature(std::size_t i) const { return features_[i]; }
  const Descriptor& descriptor(std::size_t i) const { return descriptors_[i]; }

  bool hasPatches() const { return !patches_.empty(); }
  const FeaturePatch& patch(std::size_t i) const { return patches_[i]; }

  /// Appends to `out` (cleared first) the indices of features within `radius_px` of `uv` (a square
  /// window) whose level is in [min_level, max_level], in ascending index order.
  struct Query {
    Vec2f uv;
    float radius_px = 0.0F;
    int min_level = 0;
    int max_level = 255;
  };
  void query(const Query& query, std::vector<int>* out) const;

 private:
  std::vector<Feature> features_;
  std::vector<Descriptor> descriptors_;
  std::vector<FeaturePatch> patches_;  ///< empty or one per feature
  int width_ = 0, height_ = 0;         ///< px
  float cell_size_ = 1.0F;             ///< px
  int columns_ = 0, rows_ = 0;
  std::vector<int> cell_start_;  ///< prefix sums, columns_ * rows_ + 1
  std::vector<int> cell_items_;  ///< feature indices by cell
};

}  // namespace glide
