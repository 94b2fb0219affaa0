#include "replay/readers/image_decoder.h"

#include "replay/common/text.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <string>
#include <string_view>

namespace glide::replay {
namespace {

Error fault(const std::string& message) { return {ErrorCode::io, message}; }

/// The decoder pads a truncated JPEG with gray and calls it a success, so look for the end marker.
bool isTruncatedJpeg(std::string_view bytes) {
  constexpr std::size_t kTail = 4096;  // some cameras pad the file after the marker
  if (bytes.size() < 2 || bytes.substr(0, 2) != "\xff\xd8") return false;
  const std::string_view tail = bytes.substr(bytes.size() - std::min(bytes.size(), kTail));
  return tail.find("\xff\xd9") == std::string_view::npos;
}

/// libpng decodes what is there and OpenCV keeps the rows; the end chunk tells.
bool isTruncatedPng(std::string_view bytes) {
  if (bytes.substr(0, 4) != "\x89PNG") return false;
  return bytes.find("IEND", bytes.size() - std::min<std::size_t>(bytes.size(), 64)) ==
         std::string_view::npos;
}

ImageU8 grayOf(const cv::Mat& pixels) {
  cv::Mat gray = pixels;
  if (pixels.channels() == 3) cv::cvtColor(pixels, gray, cv::COLOR_BGR2GRAY);
  if (pixels.channels() == 4) cv::cvtColor(pixels, gray, cv::COLOR_BGRA2GRAY);
  ImageU8 result(gray.cols, gray.rows);
  for (int y = 0; y < gray.rows; ++y) {
    std::copy_n(gray.ptr<std::uint8_t>(y), gray.cols, result.row(y));
  }
  return result;
}

ColorImage colorOf(const cv::Mat& pixels) {
  if (pixels.channels() == 1) return {};
  ColorImage color{pixels.cols, pixels.rows, {}};
  color.rgb.resize(3 * pixels.total());
  cv::Mat rgb(pixels.rows, pixels.cols, CV_8UC3, color.rgb.data());
  cv::cvtColor(pixels, rgb, pixels.channels() == 3 ? cv::COLOR_BGR2RGB : cv::COLOR_BGRA2RGB);
  return color;
}

}  // namespace

Result<DecodedImage> decodedImage(const cv::Mat& pixels) {
  if (pixels.empty()) return fault("have no pixels");
  if (pixels.depth() != CV_8U) return fault("do not have 8 bits per channel");
  const int channels = pixels.channels();
  if (channels != 1 && channels != 3 && channels != 4)
    return fault("have neither one, three nor four channels");
  return DecodedImage{grayOf(pixels), colorOf(pixels)};
}

Result<DecodedImage> decodeImage(const std::filesystem::path& file) {
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return fault("cannot be opened");
  if (bytes->empty()) return fault("are empty files");
  if (isTruncatedJpeg(*bytes) || isTruncatedPng(*bytes)) return fault("are truncated");
  const cv::Mat buffer(1, static_cast<int>(bytes->size()), CV_8U, const_cast<char*>(bytes->data()));
  try {
    const cv::Mat image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    if (image.empty()) return fault("cannot be decoded");
    return decodedImage(image);
  } catch (const cv::Exception&) {  // e.g. dimensions beyond OpenCV's limits
    return fault("cannot be decoded");
  }
}

}  // namespace glide::replay
