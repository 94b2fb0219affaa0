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

}  // namespace

Result<ImageU8> toGray(const cv::Mat& image) {
  if (image.empty()) return fault("have no pixels");
  if (image.depth() != CV_8U) return fault("do not have 8 bits per channel");
  cv::Mat gray;
  switch (image.channels()) {
    case 1:
      gray = image;
      break;
    case 3:
      cv::cvtColor(image, gray, cv::COLOR_BGR2GRAY);
      break;
    case 4:
      cv::cvtColor(image, gray, cv::COLOR_BGRA2GRAY);
      break;
    default:
      return fault("have neither one, three nor four channels");
  }
  ImageU8 result(gray.cols, gray.rows);
  for (int y = 0; y < gray.rows; ++y) {
    std::copy_n(gray.ptr<std::uint8_t>(y), gray.cols, result.row(y));
  }
  return result;
}

Result<ImageU8> decodeGray(const std::filesystem::path& file) {
  const Result<std::string> bytes = readFile(file);
  if (!bytes) return fault("cannot be opened");
  if (bytes->empty()) return fault("are empty files");
  if (isTruncatedJpeg(*bytes) || isTruncatedPng(*bytes)) return fault("are truncated");
  const cv::Mat buffer(1, static_cast<int>(bytes->size()), CV_8U, const_cast<char*>(bytes->data()));
  try {
    const cv::Mat image = cv::imdecode(buffer, cv::IMREAD_UNCHANGED);
    if (image.empty()) return fault("cannot be decoded");
    return toGray(image);
  } catch (const cv::Exception&) {  // e.g. dimensions beyond OpenCV's limits
    return fault("cannot be decoded");
  }
}

}  // namespace glide::replay
