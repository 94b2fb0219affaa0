#include "replay/outputs/report_thumbnails.h"

#include "replay/outputs/base64.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <utility>

namespace glide::replay {
namespace {

constexpr int kJpegQuality = 60;  // 4 to 6 kB at this width; blocks are not yet seen

cv::Mat viewOf(const SourceFrame& frame) {
  if (!frame.color.rgb.empty()) {
    const cv::Mat rgb(frame.color.height,
                      frame.color.width,
                      CV_8UC3,
                      const_cast<std::uint8_t*>(frame.color.rgb.data()));
    cv::Mat bgr;
    cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
    return bgr;
  }
  return {frame.image.height(),
          frame.image.width(),
          CV_8UC1,
          const_cast<std::uint8_t*>(frame.image.row(0)),
          static_cast<std::size_t>(frame.image.stride())};
}

}  // namespace

std::vector<std::uint8_t> thumbnailJpeg(const SourceFrame& frame) {
  cv::Mat picture = viewOf(frame);
  if (picture.cols > kThumbnailWidth) {
    const int height = std::max(1, picture.rows * kThumbnailWidth / picture.cols);
    cv::Mat small;
    cv::resize(picture, small, {kThumbnailWidth, height}, 0.0, 0.0, cv::INTER_AREA);
    picture = small;
  }
  std::vector<std::uint8_t> jpeg;
  cv::imencode(".jpg",
               picture,
               jpeg,
               {cv::IMWRITE_JPEG_QUALITY, kJpegQuality, cv::IMWRITE_JPEG_OPTIMIZE, 1});
  return jpeg;
}

bool ThumbnailStrip::wantsNext(bool is_keyframe) {
  ++next_frame_;
  is_keyframe_ = is_keyframe;
  Kind& kind = kindOf(is_keyframe);
  return kind.seen++ % kind.stride == 0;
}

void ThumbnailStrip::add(std::vector<std::uint8_t> jpeg) {
  Kind& kind = kindOf(is_keyframe_);
  kind.bytes += base64Size(jpeg.size());
  ++kind.pictures;
  pictures_.push_back({next_frame_ - 1, is_keyframe_, std::move(jpeg)});
  while (keyframes_.bytes + others_.bytes > budget_) thin();
}

void ThumbnailStrip::thin() {
  const bool of_keyframes = keyframes_.bytes > others_.bytes;
  Kind& kind = kindOf(of_keyframes);
  const bool is_last = kind.pictures == 1;
  kind = {kind.seen, 2 * kind.stride, 0, 0};
  std::size_t place = 0;
  std::vector<Thumbnail> left;
  for (Thumbnail& picture : pictures_) {
    const bool is_of_kind = picture.is_keyframe == of_keyframes;
    if (is_of_kind && (is_last || place++ % 2 != 0)) continue;
    if (is_of_kind) {
      kind.bytes += base64Size(picture.jpeg.size());
      ++kind.pictures;
    }
    left.push_back(std::move(picture));
  }
  pictures_ = std::move(left);
}

}  // namespace glide::replay
