#pragma once

#include "replay/readers/frame_source.h"

#include "image/image.h"

#include "glide/result.h"

#include <filesystem>

namespace cv {
class Mat;
}

namespace glide::replay {

/// An image as it is tracked and, when it has colour, as it is shown.
struct DecodedImage {
  ImageU8 gray;
  ColorImage color;  ///< empty for images of one channel
};

/// Reads an image file as 8-bit gray and colour; orientation tags are not applied (they would not
/// match the calibration). The error's message completes the sentence "N images ...", for instance
/// "cannot be decoded", so that equal faults can be counted.
Result<DecodedImage> decodeImage(const std::filesystem::path& file);

/// The same for a decoded 8-bit image of one, three (BGR) or four (BGRA) channels.
Result<DecodedImage> decodedImage(const cv::Mat& pixels);

}  // namespace glide::replay
