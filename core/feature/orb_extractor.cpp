#include "feature/orb_extractor.h"

#include "feature/corner.h"
#include "feature/descriptor.h"
#include "feature/level_quota.h"
#include "feature/refine_corner.h"
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
static_assert(kBorder >= kRefineReach);
/// A level needs room for at least one corner.
constexpr int kMinLevelSize = 2 * kBorder + 1;

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
  std::vector<Feature> features;
  std::vector<Descriptor> descriptors;
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
  for (int level = 0; level < pyramid.levels(); ++level) describeLevel(level);
  return FeatureSet(features, descriptors, luma.width, luma.height);
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
  for (const Corner& c : kept) {
    const Vec2f uv_level = refineCorner(sharp, c.x, c.y);
    Feature feature;
    feature.uv = pyramid.toLevel0(level, uv_level);
    feature.angle = centroidAngle(sharp, c.x, c.y);
    feature.response = c.score;
    feature.level = static_cast<std::uint8_t>(level);
    descriptors.push_back(pattern.describe(smooth, c.x, c.y, feature.angle));
    features.push_back(feature);
  }
}

}  // namespace glide
