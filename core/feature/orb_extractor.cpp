#include "feature/orb_extractor.h"

#include "feature/corner.h"
#include "feature/corner_orientation.h"
#include "feature/descriptor.h"
#include "feature/fast_corners.h"
#include "feature/level_quota.h"
#include "feature/scale_pyramid.h"

#include <opencv2/core.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace glide {
namespace {

/// Corners keep this distance to the borders of their level, px: the patch and the sub-pixel step.
constexpr int kBorder = kPatchRadius + 1;
static_assert(kBorder >= kFastReach);
/// A level needs room for at least one corner.
constexpr int kMinLevelSize = 2 * kBorder + 1;
static_assert(kBorder >= FeaturePatch::kSize / 2);

FeaturePatch patchAround(const ImageViewU8& level, const Corner& corner, const Vec2f& uv_level) {
  FeaturePatch patch;
  constexpr int kHalf = FeaturePatch::kSize / 2;
  for (int y = 0; y < FeaturePatch::kSize; ++y) {
    const std::uint8_t* row = level.row(corner.y - kHalf + y) + corner.x - kHalf;
    std::copy_n(row, FeaturePatch::kSize, patch.pixels.data() + y * FeaturePatch::kSize);
  }
  patch.offset = uv_level - Vec2f(static_cast<float>(corner.x), static_cast<float>(corner.y));
  return patch;
}

}  // namespace

struct OrbExtractor::Impl {
  explicit Impl(const Config::Features& config_in)
      : config(config_in),
        pyramid({config_in.levels, config_in.scale_factor, kMinLevelSize}),
        corners(static_cast<std::size_t>(config_in.levels)) {}

  FeatureSet extract(const ImageViewU8& luma, int count);
  void detect();
  void distribute(int count);
  void describeLevel(int level);

  Config::Features config;
  ScalePyramid pyramid;
  SteeredPattern pattern;
  std::vector<std::vector<Corner>> corners;  ///< by level
  std::vector<Vec2f> uv_level;               ///< of one level
  std::vector<float> angles;                 ///< of one level
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;
  std::vector<FeaturePatch> patches;
};

OrbExtractor::OrbExtractor(const Config::Features& config)
    : impl_(std::make_unique<Impl>(config)) {}
OrbExtractor::~OrbExtractor() = default;
OrbExtractor::OrbExtractor(OrbExtractor&&) noexcept = default;
OrbExtractor& OrbExtractor::operator=(OrbExtractor&&) noexcept = default;

FeatureSet OrbExtractor::extract(const ImageViewU8& luma, int count) {
  if (std::min(luma.width, luma.height) < kMinLevelSize || count <= 0) return {};
  try {
    return impl_->extract(luma, count);
  } catch (const cv::Exception&) {
    return {};  // out of memory inside OpenCV: a frame without features
  }
}

FeatureSet OrbExtractor::Impl::extract(const ImageViewU8& luma, int count) {
  pyramid.build(luma);
  detect();
  distribute(count);
  features.clear();
  descriptors.clear();
  patches.clear();
  for (int level = 0; level < pyramid.levels(); ++level) describeLevel(level);
  return FeatureSet(features, descriptors, luma.width, luma.height).withPatches(patches);
}

void OrbExtractor::Impl::detect() {
  for (int level = 0; level < pyramid.levels(); ++level) {
    detectCorners(pyramid.level(level),
                  kBorder,
                  {config.fast_threshold, config.fast_threshold_low},
                  &corners[static_cast<std::size_t>(level)]);
  }
}

void OrbExtractor::Impl::distribute(int count) {
  std::vector<int> found;
  for (int level = 0; level < pyramid.levels(); ++level) {
    found.push_back(static_cast<int>(corners[static_cast<std::size_t>(level)].size()));
  }
  const std::vector<int> quotas = levelQuotas(count, config.scale_factor, found);
  for (int level = 0; level < pyramid.levels(); ++level) {
    const ImageViewU8& image = pyramid.level(level);
    const std::size_t l = static_cast<std::size_t>(level);
    keepSpread(image.width, image.height, quotas[l], &corners[l]);
  }
}

void OrbExtractor::Impl::describeLevel(int level) {
  const std::vector<Corner>& kept = corners[static_cast<std::size_t>(level)];
  if (kept.empty()) return;
  const ImageViewU8& sharp = pyramid.level(level);
  const ImageViewU8 smooth = pyramid.smoothed(level);
  uv_level.resize(kept.size());
  angles.resize(kept.size());
  refineCorners(sharp, kept, uv_level);
  cornerAngles(smooth, kept, angles);
  for (std::size_t i = 0; i < kept.size(); ++i) {
    const Corner& c = kept[i];
    Feature feature;
    feature.uv = pyramid.toLevel0(level, uv_level[i]);
    feature.angle = angles[i];
    feature.response = static_cast<float>(c.score);
    feature.level = static_cast<std::uint8_t>(level);
    descriptors.push_back(pattern.describe(smooth, c.x, c.y, feature.angle));
    features.push_back(feature);
    patches.push_back(patchAround(sharp, c, uv_level[i]));
  }
}

}  // namespace glide
