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
constexpr double kBlurSigma = 1.5;
/// Smoothing of the whole pyramid against sensor noise.
constexpr int kDenoiseSize = 5;
constexpr double kDenoiseSigma = 1.0;

/// cv::Mat has no read-only form: the caller promises not to write to it.
cv::Mat borrow(const ImageViewU8& view) {
  return {view.height,
          view.width,
          CV_8UC1,
          const_cast<std::uint8_t*>(view.data),
          static_cast<std::size_t>(view.stride)};
}

void blur(const cv::Mat& image, int size, double sigma, cv::Mat& target) {
  cv::GaussianBlur(image, target, cv::Size(size, size), sigma, sigma, cv::BORDER_REFLECT_101);
}

}  // namespace

void ScalePyramid::build(const ImageViewU8& luma) {
  views_.clear();
  images_.resize(static_cast<std::size_t>(std::max(1, shape_.levels)));
  double scale = 1.0;
  for (ImageU8& image : images_) {
    const int width = static_cast<int>(std::lround(luma.width / scale));
    const int height = static_cast<int>(std::lround(luma.height / scale));
    if (std::min(width, height) < shape_.min_size_px) break;
    image.resize(width, height);
    cv::Mat target = borrow(image.view());
    if (views_.empty()) {
      blur(borrow(luma), kDenoiseSize, kDenoiseSigma, target);
    } else {
      cv::resize(borrow(views_.back()), target, target.size(), 0.0, 0.0, cv::INTER_LINEAR);
    }
    views_.push_back(image.view());
    scale *= shape_.scale_factor;
  }
}

ImageViewU8 ScalePyramid::smoothed(int level) {
  const ImageViewU8& sharp = this->level(level);
  smooth_.resize(sharp.width, sharp.height);
  cv::Mat target = borrow(smooth_.view());
  blur(borrow(sharp), kBlurSize, kBlurSigma, target);
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
