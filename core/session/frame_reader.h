#pragma once

#include "photometric/aligner.h"

#include "image/image.h"

#include "glide/config.h"
#include "glide/frame.h"

#include <memory>

namespace glide {

/// The image of the frame that update() is about: checks it, and brings a texture's pixels to the
/// CPU when somebody asks for them, once. Owned and called by the thread of update(), which has the
/// GL context current when the image is a texture.
class FrameReader {
 public:
  /// For frames of the config's camera; `backend` is where the direct tracker runs.
  FrameReader(const Config& config, Backend backend);
  ~FrameReader();
  FrameReader(const FrameReader&) = delete;
  FrameReader& operator=(const FrameReader&) = delete;

  using Input = decltype(FrameInput::image);

  /// What can be said without OpenGL: invalid_argument or unsupported naming what is wrong.
  Status check(const Input& input) const;
  /// Makes it the frame of the calls below, until update() returns. Errors as check(), and what
  /// OpenGL says of a texture (gpu/texture_reader.h); missing_context when none is current.
  Status take(const Input& input);

  /// What the direct tracker loads: on the CPU always pixels.
  FrameImage image();
  /// The frame's pixels. Black when the GPU does not answer in time: the frame is lost then.
  ImageViewU8 luma();
  /// Milliseconds that the frame's texture took to be read; zero while nobody asked for its pixels.
  double readback_ms() const { return readback_ms_; }

  void setBackend(Backend backend) { backend_ = backend; }
  /// Frees what it has in the GL context; the next texture makes it again.
  void releaseGl();
  /// The same without a GL call: the context is gone.
  void abandonGl();

 private:
  struct Gl;

  Status checkLuma(const Luma& luma) const;
  Status checkTexture(const Texture& texture) const;
  Status takeTexture(const Texture& texture);
  Status takeBuffer(const HardwareBuffer& buffer);
  Status ensureGl();
  void read(const Texture& texture);

  int width_, height_;
  Backend backend_;
  Config::Gl options_;
  std::unique_ptr<Gl> gl_;  ///< made for the first texture
  FrameImage image_;
  ImageU8 bytes_;         ///< of a texture, once somebody asked
  bool is_read_ = false;  ///< bytes_ are of this frame
  double readback_ms_ = 0.0;
};

}  // namespace glide
