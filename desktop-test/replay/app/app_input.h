#pragma once

#include "replay/app/options.h"

#include "image/image.h"

#include "glide/frame.h"
#include "glide/result.h"

#include <memory>

namespace glide::replay {

/// Hands the images of a replay to the session as an app would that has them in that form: pixels,
/// or one texture into which each image is uploaded. Dies before the GL context.
class AppInput {
 public:
  /// Nothing is made before the first image.
  explicit AppInput(InputKind kind);
  AppInput(AppInput&&) noexcept;
  AppInput& operator=(AppInput&&) noexcept;
  ~AppInput();

  /// Valid until the next call or the end of `image`. unsupported when the GL has no such texture.
  Result<FrameInput> make(std::int64_t t_ns, const ImageU8& image);

 private:
  struct Uploaded;

  InputKind kind_;
  std::unique_ptr<Uploaded> texture_;
};

}  // namespace glide::replay
