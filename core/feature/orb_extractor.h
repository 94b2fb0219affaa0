#pragma once

#include "feature/feature_set.h"

#include "image/image.h"

#include "glide/config.h"

#include <memory>

namespace glide {

/// FAST corners on a scale pyramid, distributed over the image, with steered binary descriptors
/// (Rublee et al., "ORB", ICCV 2011). Keeps scratch buffers: one thread per instance.
class OrbExtractor {
 public:
  explicit OrbExtractor(const Config::Features& config);
  ~OrbExtractor();
  OrbExtractor(OrbExtractor&&) noexcept;
  OrbExtractor& operator=(OrbExtractor&&) noexcept;

  /// About `count` features, fewer where the image has fewer corners.
  FeatureSet extract(const ImageViewU8& luma, int count);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
