#include "replay/render/video_file.h"

#include "replay/common/text.h"
#include "replay/outputs/render_path.h"

#include <opencv2/imgproc.hpp>

#include <string>
#include <system_error>
#include <utility>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kWaiting = 9;      // eight intervals: their median is the rate
constexpr double kLoneFrameRate = 30.0;  // of a video of one frame

std::vector<int> codecsFor(const fs::path& file) {
  const int h264 = cv::VideoWriter::fourcc('a', 'v', 'c', '1');
  const int mpeg4 = cv::VideoWriter::fourcc('m', 'p', '4', 'v');
  const int xvid = cv::VideoWriter::fourcc('X', 'V', 'I', 'D');
  if (lowerExtension(file) == ".avi") return {xvid};
  return {h264, mpeg4};
}

}  // namespace

Result<std::unique_ptr<FrameSink>> VideoFile::open(const fs::path& file, const PictureSize& size) {
  std::error_code fault;
  if (fs::is_directory(file, fault)) return errorIn(file, "is a folder, not a video");
  fault.clear();  // that the file is not there yet is none
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), fault);
  if (fault) return errorIn(file.parent_path(), "cannot be made: " + fault.message());
  std::unique_ptr<VideoFile> video(new VideoFile(file, size));
  const Status writable = writeFile(video->beside_, "");
  if (!writable) return errorIn(file, "cannot be written");
  // What has no encoder should say so before the replay, not after its first frames.
  if (!video->openWriter(kLoneFrameRate)) return errorIn(file, "no video encoder can write it");
  video->writer_.release();
  return std::unique_ptr<FrameSink>(std::move(video));
}

VideoFile::VideoFile(const fs::path& file, const PictureSize& size)
    : file_(file), beside_(partialVideo(file)), size_(size) {}

VideoFile::~VideoFile() {
  writer_.release();
  std::error_code ignored;
  fs::remove(beside_, ignored);
}

bool VideoFile::openWriter(double frames_per_s) {
  for (const int codec : codecsFor(file_)) {
    const cv::Size size(size_.width, size_.height);
    if (writer_.open(beside_.string(), cv::CAP_FFMPEG, codec, frames_per_s, size)) return true;
  }
  return false;
}

Status VideoFile::write(const RgbPicture& picture, std::int64_t t_ns) {
  if (pacer_) {
    append(picture, t_ns);
    return Unit{};
  }
  waiting_.push_back({picture, t_ns});
  return waiting_.size() == kWaiting ? startWriting() : Status(Unit{});
}

Status VideoFile::startWriting() {
  std::vector<std::int64_t> times_ns;
  for (const Waiting& frame : waiting_) times_ns.push_back(frame.t_ns);
  const double rate = times_ns.size() > 1 ? frameRate(times_ns) : kLoneFrameRate;
  if (!openWriter(rate)) return errorIn(file_, "cannot be written");
  pacer_.emplace(rate, times_ns.front());
  for (const Waiting& frame : std::exchange(waiting_, {})) append(frame.picture, frame.t_ns);
  return Unit{};
}

void VideoFile::append(const RgbPicture& picture, std::int64_t t_ns) {
  const int steps = pacer_->steps(t_ns);
  for (int repeat = 1; repeat < steps; ++repeat) writer_.write(last_bgr_);
  const cv::Mat rgb(
      picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.rgb.data()));
  cv::cvtColor(rgb, last_bgr_, cv::COLOR_RGB2BGR);
  if (steps > 0) writer_.write(last_bgr_);
  written_ += steps;
}

Status VideoFile::finish() {
  if (!pacer_ && waiting_.empty()) return Unit{};
  if (!pacer_) {
    const Status started = startWriting();
    if (!started) return started;
  }
  writer_.release();
  const Status whole = checkWhole();
  if (!whole) return whole;
  std::error_code fault;
  fs::rename(beside_, file_, fault);
  if (fault) return errorIn(file_, "cannot be written: " + fault.message());
  return Unit{};
}

/// The writer does not tell when the disk is full; a file without its end cannot be opened.
Status VideoFile::checkWhole() const {
  const cv::VideoCapture video(beside_.string(), cv::CAP_FFMPEG);
  const bool is_whole =
      video.isOpened() && static_cast<int>(video.get(cv::CAP_PROP_FRAME_COUNT)) >= written_;
  if (!is_whole) return errorIn(file_, "could not be written to its end (is the disk full?)");
  return Unit{};
}

}  // namespace glide::replay
