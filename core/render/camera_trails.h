#pragma once

#include "glide/frame.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

namespace glide {

/// Where landmarks were in the pictures before. Owned by the thread that draws.
class PointTrails {
 public:
  static constexpr std::size_t kLength = 10;  ///< positions before the newest, and draws back

  /// The points of one more picture. The same points once more are the same picture, drawn again;
  /// no points are a picture of their own each time.
  void add(std::span<const TrackedPoint> points);

  /// Pixels, the newest first; of a landmark of the last picture at least one.
  using Positions = std::array<std::array<float, 2>, kLength + 1>;
  struct Trail {
    Positions uv{};
    std::size_t count = 0;
  };
  Trail of(std::uint64_t landmark) const;
  std::size_t size() const { return landmarks_.size(); }

 private:
  struct Sample {
    std::array<float, 2> uv{};
    std::int64_t picture = 0;  ///< the first is 1
  };
  /// By the number of the picture, modulo their count: what is older is overwritten.
  using Samples = std::array<Sample, kLength + 1>;

  bool isLastPicture(std::span<const TrackedPoint> points) const;
  void forgetOld();

  std::unordered_map<std::uint64_t, Samples> landmarks_;
  std::vector<TrackedPoint> last_;
  std::int64_t picture_ = 0;
};

}  // namespace glide
