#pragma once

#include "geometry/eigen_types.h"
#include "image/image.h"

#include <vector>

namespace glide {

/// Images of one frame at geometrically falling sizes, each with a smoothed copy. Keeps its buffers
/// between frames.
class ScalePyramid {
 public:
  struct Shape {
    int levels = 8;             ///< at most; levels below min_size_px are left out
    double scale_factor = 1.2;  ///< between levels
    int min_size_px = 1;        ///< smallest side
  };

  explicit ScalePyramid(const Shape& shape) : shape_(shape) {}

  /// Level 0 is the image, denoised by a Gaussian of 1 px (10 % more correct matches on EuRoC MH01,
  /// KITTI 07 and a fisheye sequence); each next one is interpolated from the level before. OpenCV
  /// may throw.
  void build(const ImageViewU8& luma);

  /// A level under a Gaussian of 1.5 px, for the descriptors; OpenCV may throw.
  ImageViewU8 smoothed(int level);

  int levels() const { return static_cast<int>(views_.size()); }
  const ImageViewU8& level(int level) const { return views_[static_cast<std::size_t>(level)]; }

  /// Level-0 pixel of a position in a level. Pixel centres are at whole numbers, so a level of
  /// 1/s the size maps by (x + 0.5) * s - 0.5.
  Vec2f toLevel0(int level, const Vec2f& uv_level) const;

 private:
  Shape shape_;
  std::vector<ImageViewU8> views_;
  std::vector<ImageU8> images_;
  ImageU8 smooth_;
};

}  // namespace glide
