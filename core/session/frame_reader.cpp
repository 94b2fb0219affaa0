#include "session/frame_reader.h"

#include <string>

namespace glide {
namespace {

Error invalid(const std::string& what) { return {ErrorCode::invalid_argument, what}; }

std::string sizeText(int width, int height) {
  return std::to_string(width) + "x" + std::to_string(height);
}

}  // namespace

Status FrameReader::checkLuma(const Luma& luma) const {
  if (luma.pixels == nullptr) return invalid("FrameInput.image.pixels is null");
  if (luma.width != width_ || luma.height != height_)
    return invalid("FrameInput.image is " + sizeText(luma.width, luma.height) +
                   ", but the camera of the config is " + sizeText(width_, height_));
  if (luma.stride < luma.width) return invalid("FrameInput.image.stride is smaller than the width");
  return Unit{};
}

Status FrameReader::check(const Input& input) const {
  if (const auto* luma = std::get_if<Luma>(&input)) return checkLuma(*luma);
  return Error{ErrorCode::unsupported, "FrameInput.image: textures are not read yet"};
}

Status FrameReader::take(const Input& input) {
  Status valid = check(input);
  if (!valid) return valid;
  const Luma& luma = *std::get_if<Luma>(&input);
  image_ = ImageViewU8{luma.pixels, luma.width, luma.height, luma.stride};
  return Unit{};
}

FrameImage FrameReader::image() { return image_; }

ImageViewU8 FrameReader::luma() { return *std::get_if<ImageViewU8>(&image_); }

}  // namespace glide
