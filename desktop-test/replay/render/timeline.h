#pragma once

#include "glide/frame.h"
#include "glide/render_types.h"

#include <cstdint>
#include <vector>

namespace glide::replay {

/// A picture of its own: rows of red, green, blue bytes, the uppermost first, no padding.
struct RgbPicture {
  int width = 0, height = 0;  ///< px
  std::vector<std::uint8_t> rgb;
};

/// The same pixels for the renderers; valid while the picture is.
Rgb viewOf(const RgbPicture& picture);

/// Which tracker placed which frame, as a strip from the first frame on the left to the last one on
/// the right: orange direct, dark blue indirect, black lost, gray before there is a map. A column
/// of many frames is divided by their shares.
class Timeline {
 public:
  /// `frames`: how many will come; 0 when unknown, then the strip always holds those so far.
  explicit Timeline(int frames) : expected_(frames) {}

  void add(const FrameResult& frame);
  RgbPicture paint(int width, int height) const;

 private:
  int expected_;
  std::vector<std::uint8_t> kinds_;  ///< of each frame, an index into the strip's colours
};

}  // namespace glide::replay
