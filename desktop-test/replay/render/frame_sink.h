#pragma once

#include "replay/render/split_layout.h"
#include "replay/render/timeline.h"

#include "glide/result.h"

#include <cstdint>
#include <filesystem>
#include <memory>

namespace glide::replay {

/// Where the pictures of a replay go. Without finish() nothing is left behind of a video.
class FrameSink {
 public:
  virtual ~FrameSink() = default;
  /// Times increase. io when it cannot be written.
  virtual Status write(const RgbPicture& picture, std::int64_t t_ns) = 0;
  /// After the last one. io when the result is not whole.
  virtual Status finish() = 0;
};

/// A video, or a folder of 000000.png and so on, by the name. Folders are made as needed. io when
/// it cannot be written.
Result<std::unique_ptr<FrameSink>> openFrameSink(const std::filesystem::path& path,
                                                 const PictureSize& size);

}  // namespace glide::replay
