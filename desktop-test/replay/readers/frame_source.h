#pragma once

#include "image/image.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glide::replay {

/// Which part of a sequence is replayed. Applied in this order.
struct FrameSelection {
  double start_s = 0.0;              ///< seconds after the first frame that exists
  std::optional<double> duration_s;  ///< seconds; none: to the end
  int stride = 1;                    ///< every n-th frame, at least 1
  std::optional<int> max_frames;     ///< none: all
};

/// Frames that were left out for one reason.
struct Skip {
  std::string what;  ///< for instance "images cannot be decoded"
  int count = 0;
  std::string first;  ///< name of the first one
};

/// Left-out frames counted by reason, in order of first appearance.
class SkipList {
 public:
  void add(const std::string& what, const std::string& name);
  const std::vector<Skip>& skips() const { return skips_; }

 private:
  std::vector<Skip> skips_;
};

/// "2570 of 2586 images listed in rgb.txt are missing (first: rgb/1.png)"
std::string describe(const Skip& skip, int frames_listed);

/// What a source is, known once it is open.
struct SourceInfo {
  std::string kind;  ///< tum, euroc, video or images
  std::filesystem::path path;
  std::string name;  ///< for output folders
  int frames = 0;    ///< selected frames that exist; 0 when only the end will tell
  int listed = 0;    ///< all frames that the source claims to have
  int width = 0;     ///< px, of the first readable frame
  int height = 0;    ///< px
};

/// Red, green, blue bytes, no padding between rows.
struct ColorImage {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgb;
};

/// One decoded frame.
struct SourceFrame {
  std::int64_t t_ns = 0;
  std::string name;
  ImageU8 image;       ///< 8-bit gray: what is tracked
  ColorImage color{};  ///< the same in colour; empty when the source has none
};

/// A sequence of frames with strictly increasing timestamps. One thread at a time.
class FrameSource {
 public:
  virtual ~FrameSource() = default;
  virtual const SourceInfo& info() const = 0;
  /// The next frame that can be used; nothing at the end. Unusable ones are counted in skips().
  virtual std::optional<SourceFrame> next() = 0;
  virtual const SkipList& skips() const = 0;
};

}  // namespace glide::replay
