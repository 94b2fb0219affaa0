#pragma once

#include "replay/render/frame_sink.h"

#include <cstdint>
#include <filesystem>
#include <memory>
#include <utility>

namespace glide::replay {

/// A folder of 000000.png, 000001.png and so on, one picture a frame, each whole or not there.
/// Those of an earlier run, which .glide-pictures counts, are replaced or removed; other files
/// stay, and a folder with other pictures of such names is refused.
class PictureFolder : public FrameSink {
 public:
  static Result<std::unique_ptr<FrameSink>> open(const std::filesystem::path& folder);

  Status write(const RgbPicture& picture, std::int64_t t_ns) override;
  Status finish() override { return Unit{}; }

 private:
  explicit PictureFolder(std::filesystem::path folder) : folder_(std::move(folder)) {}

  std::filesystem::path folder_;
  int next_ = 0;
};

}  // namespace glide::replay
