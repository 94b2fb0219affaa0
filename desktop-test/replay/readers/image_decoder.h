#pragma once

#include "image/image.h"

#include "glide/result.h"

#include <filesystem>

namespace cv {
class Mat;
}

namespace glide::replay {

/// Reads an image file as 8-bit gray; colour is converted, orientation tags are not applied (they
/// would not match the calibration). The error's message completes the sentence "N images ...", for
/// instance "cannot be decoded", so that equal faults can be counted.
Result<ImageU8> decodeGray(const std::filesystem::path& file);

/// The same for a decoded 8-bit image of one, three (BGR) or four (BGRA) channels.
Result<ImageU8> toGray(const cv::Mat& image);

}  // namespace glide::replay
