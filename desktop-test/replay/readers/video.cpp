#include "replay/readers/video.h"

#include "replay/common/text.h"
#include "replay/readers/image_decoder.h"

#include <opencv2/videoio.hpp>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <string>
#include <string_view>
#include <utility>

namespace glide::replay {
namespace {

constexpr double kDefaultFps = 30.0;

class VideoSource : public FrameSource {
 public:
  VideoSource(const cv::VideoCapture& capture,
              const FrameSelection& selection,
              std::optional<double> fps)
      : capture_(capture),  // shares the open file
        selection_(selection),
        fps_(fps) {
    const double nominal = capture_.get(cv::CAP_PROP_FPS);
    frame_interval_s_ = 1.0 / fps.value_or(nominal > 0.0 ? nominal : kDefaultFps);
    info_.listed = std::max(0, static_cast<int>(capture_.get(cv::CAP_PROP_FRAME_COUNT)));
    info_.frames = expectedFrames();
    first_ = decodeNext();
    if (!first_) return;
    info_.width = first_->image.width();
    info_.height = first_->image.height();
  }

  void setOrigin(const std::filesystem::path& file) {
    info_.kind = "video";
    info_.path = file;
    info_.name = file.stem().string();
  }

  const SourceInfo& info() const override { return info_; }
  const SkipList& skips() const override { return skips_; }

  std::optional<SourceFrame> next() override {
    if (first_) return std::exchange(first_, std::nullopt);
    return decodeNext();
  }

 private:
  int expectedFrames() const {
    const double length_s = info_.listed * frame_interval_s_ - selection_.start_s;
    const double used_s = std::min(length_s, selection_.duration_s.value_or(length_s));
    const int frames = std::max(0, static_cast<int>(std::lround(used_s / frame_interval_s_)));
    const int strided = (frames + selection_.stride - 1) / selection_.stride;
    return selection_.max_frames ? std::min(strided, *selection_.max_frames) : strided;
  }

  /// Seconds of the frame that was grabbed last.
  double grabbedTime() {
    const double nominal_s = static_cast<double>(index_) * frame_interval_s_;
    if (fps_) return nominal_s;
    const double container_s = capture_.get(cv::CAP_PROP_POS_MSEC) * 1e-3;
    if (index_ == 0 || container_s > last_s_) return container_s;
    skips_.add("frames have a timestamp that does not increase and got the nominal one",
               "frame " + std::to_string(index_));
    return last_s_ + frame_interval_s_;
  }

  bool isSelected(double t_s) {
    if (t_s - origin_s_ < selection_.start_s) return false;
    return candidates_++ % selection_.stride == 0;
  }

  bool isPastEnd(double t_s) const {
    if (selection_.max_frames && delivered_ >= *selection_.max_frames) return true;
    return selection_.duration_s && t_s - origin_s_ >= selection_.start_s + *selection_.duration_s;
  }

  std::optional<SourceFrame> decodeNext() {
    while (capture_.grab()) {
      const double t_s = grabbedTime();
      if (index_ == 0) origin_s_ = t_s;
      const std::string name = "frame " + std::to_string(index_++);
      last_s_ = t_s;
      if (isPastEnd(t_s)) return std::nullopt;
      if (!isSelected(t_s)) continue;
      cv::Mat pixels;
      capture_.retrieve(pixels);
      Result<DecodedImage> image = decodedImage(pixels);
      if (!image) {
        skips_.add("frames " + image.error().message, name);
        continue;
      }
      ++delivered_;
      return SourceFrame{
          std::llround(t_s * 1e9), name, std::move(image->gray), std::move(image->color)};
    }
    return std::nullopt;
  }

  cv::VideoCapture capture_;
  FrameSelection selection_;
  std::optional<double> fps_;
  double frame_interval_s_ = 0.0;
  SourceInfo info_;
  SkipList skips_;
  std::int64_t index_ = 0;       ///< of the next frame in the file
  std::int64_t candidates_ = 0;  ///< frames at or after the start
  int delivered_ = 0;
  double origin_s_ = 0.0, last_s_ = 0.0;
  std::optional<SourceFrame> first_;
};

}  // namespace

bool isVideoFile(const std::filesystem::path& file) {
  constexpr std::array<std::string_view, 9> kExtensions = {
      ".mp4", ".avi", ".mov", ".mkv", ".webm", ".m4v", ".3gp", ".mpg", ".mpeg"};
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

Result<std::unique_ptr<FrameSource>> openVideo(const std::filesystem::path& file,
                                               const FrameSelection& selection,
                                               std::optional<double> fps) {
  cv::VideoCapture capture(file.string(), cv::CAP_FFMPEG);
  if (!capture.isOpened()) return errorIn(file, "is no video that can be decoded");
  auto source = std::make_unique<VideoSource>(capture, selection, fps);
  source->setOrigin(file);
  if (source->info().width == 0) return errorIn(file, "has no frame in the part asked for");
  return std::unique_ptr<FrameSource>(std::move(source));
}

}  // namespace glide::replay
