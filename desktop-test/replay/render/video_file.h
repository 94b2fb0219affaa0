#pragma once

#include "replay/render/frame_pacer.h"
#include "replay/render/frame_sink.h"

#include <opencv2/videoio.hpp>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

namespace glide::replay {

/// A video that plays in real time at the frames' own rate. H.264 where the encoder is there, which
/// every player and browser shows, else MPEG-4. It grows beside its final name and takes it when it
/// is whole; without frames there is none.
class VideoFile : public FrameSink {
 public:
  static Result<std::unique_ptr<FrameSink>> open(const std::filesystem::path& file,
                                                 const PictureSize& size);
  ~VideoFile() override;

  Status write(const RgbPicture& picture, std::int64_t t_ns) override;
  Status finish() override;

 private:
  struct Waiting {
    RgbPicture picture;
    std::int64_t t_ns = 0;
  };

  VideoFile(const std::filesystem::path& file, const PictureSize& size);
  bool openWriter(double frames_per_s);
  Status startWriting();
  void append(const RgbPicture& picture, std::int64_t t_ns);
  Status checkWhole() const;

  std::filesystem::path file_, beside_;
  PictureSize size_;
  std::vector<Waiting> waiting_;  ///< the first frames, until they tell their rate
  std::optional<FramePacer> pacer_;
  cv::VideoWriter writer_;
  cv::Mat last_bgr_;
  int written_ = 0;
};

}  // namespace glide::replay
