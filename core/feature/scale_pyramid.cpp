#include "feature/scale_pyramid.h"

#include <opencv2/core.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace glide {
namespace {

/// Smoothing that makes single-pixel tests repeatable (Calonder et al. 2010, section 3.1).
constexpr int kBlurSize = 7;
constexpr double kBlurSigma = 2.0;

/// cv::Mat has no read-only form: the caller promises not to write to it.
cv::Mat borrow(const ImageViewU8& view) {
  return {view.height,
          view.width,
          CV_8UC1,
          const_cast<std::uint8_t*>(view.data),
          static_cast<std::size_t>(view.stride)};
}

}  // namespace

void ScalePyramid::build(const ImageViewU8& luma) {
  views_.assign(1, luma);
  images_.resize(static_cast<std::size_t>(std::max(0, shape_.levels - 1)));
  double scale = 1.0;
  for (ImageU8& image : images_) {
    scale *= shape_.scale_factor;
    const int width = static_cast<int>(std::lround(luma.width / scale));
    const int height = static_cast<int>(std::lround(luma.height / scale));
    if (std::min(width, height) < shape_.min_size_px) break;
    image.resize(width, height);
    cv::Mat target = borrow(image.view());
    cv::resize(borrow(views_.back()), target, target.size(), 0.0, 0.0, cv::INTER_LINEAR);
    views_.push_back(image.view());
  }
}

ImageViewU8 ScalePyramid::smoothed(int level) {
  const ImageViewU8& sharp = this->level(level);
  smooth_.resize(sharp.width, sharp.height);
  cv::Mat target = borrow(smooth_.view());
  cv::GaussianBlur(borrow(sharp),
                   target,
                   cv::Size(kBlurSize, kBlurSize),
                   kBlurSigma,
                   kBlurSigma,
                   cv::BORDER_REFLECT_101);
  return smooth_.view();
}

Vec2f ScalePyramid::toLevel0(int level, const Vec2f& uv_level) const {
  const ImageViewU8& base = views_.front();
  const ImageViewU8& image = this->level(level);
  const Vec2f scale(static_cast<float>(base.width) / static_cast<float>(image.width),
                    static_cast<float>(base.height) / static_cast<float>(image.height));
  const Vec2f half(0.5F, 0.5F);
  return (uv_level + half).cwiseProduct(scale) - half;
}

}  // namespace glide
