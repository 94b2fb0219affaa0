#pragma once

#include "replay/readers/frame_source.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace glide::replay {

/// Width of the report's pictures of frames, px.
inline constexpr int kThumbnailWidth = 240;

/// A small JPEG of one frame.
struct Thumbnail {
  std::size_t frame = 0;  ///< position in RunRecord::frames
  bool is_keyframe = false;
  std::vector<std::uint8_t> jpeg;
};

/// The frame at kThumbnailWidth (or its own width if that is less), in colour where it has colour.
std::vector<std::uint8_t> thumbnailJpeg(const SourceFrame& frame);

/// Pictures of a run of unknown length within a budget: of every frame and every keyframe at first;
/// whenever the budget is exceeded every other picture goes, of frames or of keyframes, whichever
/// take more room.
class ThumbnailStrip {
 public:
  /// Bytes of all pictures together, in base64.
  explicit ThumbnailStrip(std::size_t budget) : budget_(budget) {}

  /// Whether the next frame's picture is wanted; to be asked once per frame, in order.
  bool wantsNext(bool is_keyframe);
  /// The picture of the frame that was asked for last.
  void add(std::vector<std::uint8_t> jpeg);

  const std::vector<Thumbnail>& pictures() const { return pictures_; }

 private:
  /// Counts the frames of one kind and says which of them have a picture: every stride-th.
  struct Kind {
    std::size_t seen = 0, stride = 1, bytes = 0, pictures = 0;
  };

  Kind& kindOf(bool is_keyframe) { return is_keyframe ? keyframes_ : others_; }
  void thin();

  std::size_t budget_;
  std::size_t next_frame_ = 0;
  bool is_keyframe_ = false;  ///< the frame that was asked for last
  Kind keyframes_, others_;
  std::vector<Thumbnail> pictures_;
};

}  // namespace glide::replay
