#pragma once

#include "photometric/aligner.h"

#include "image/image.h"

#include "glide/config.h"
#include "glide/frame.h"

#include <variant>

namespace glide {

/// The image of the frame that update() is about: checks it, and brings a texture's pixels to the
/// CPU when somebody asks for them. Owned and called by the thread of update().
class FrameReader {
 public:
  /// Frames are `width` x `height` pixels; `backend` is where the direct tracker runs.
  FrameReader(int width, int height, Backend backend)
      : width_(width), height_(height), backend_(backend) {}

  using Input = decltype(FrameInput::image);

  /// What can be said without OpenGL: invalid_argument that names what is wrong.
  Status check(const Input& input) const;
  /// Makes it the frame of the calls below, until update() returns. After an error there is none.
  Status take(const Input& input);

  /// What the direct tracker loads.
  FrameImage image();
  /// The frame's pixels.
  ImageViewU8 luma();
  /// Milliseconds that luma() took to bring a texture's pixels.
  double readback_ms() const { return readback_ms_; }

 private:
  Status checkLuma(const Luma& luma) const;

  int width_, height_;
  Backend backend_;
  FrameImage image_;
  double readback_ms_ = 0.0;
};

}  // namespace glide
