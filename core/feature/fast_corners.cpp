#include "feature/fast_corners.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>

// The ring is kept in an array of vectors, which vectors of unknown length cannot be.
#undef HWY_DISABLED_TARGETS
#define HWY_DISABLED_TARGETS (HWY_SVE | HWY_SVE2 | HWY_SVE_256 | HWY_SVE2_128 | HWY_RVV)
// foreach_target.h compiles this file once per instruction set; the best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "feature/fast_corners.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef GLIDE_FEATURE_FAST_CORNERS_ONCE
#define GLIDE_FEATURE_FAST_CORNERS_ONCE
namespace glide {
namespace {

/// The circle of radius 3 around a pixel, clockwise from the top.
constexpr std::array<int, 16> kRingX{0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3, -3, -3, -2, -1};
constexpr std::array<int, 16> kRingY{-3, -3, -2, -1, 0, 1, 2, 3, 3, 3, 2, 1, 0, -1, -2, -3};
/// Spare bytes of a row of scores on each side: a whole vector.
constexpr std::size_t kRowPadding = 64;
/// Of the window in which a corner is located, px.
constexpr int kRefineRadius = 2;
constexpr int kRefineSize = 2 * kRefineRadius + 1;

using RingOffsets = std::array<std::ptrdiff_t, 16>;

RingOffsets ringOffsets(std::ptrdiff_t stride) {
  RingOffsets offsets{};
  for (std::size_t k = 0; k < offsets.size(); ++k) offsets[k] = kRingY[k] * stride + kRingX[k];
  return offsets;
}

/// Centroid of the squares of the scores above the smallest of them, from the middle of the window.
template <class Scores>
Vec2f squaredCentroid(const Scores& scores) {
  int floor = scores[0][0];
  for (int y = 0; y < kRefineSize; ++y) {
    for (int x = 0; x < kRefineSize; ++x) floor = std::min<int>(floor, scores[y][x]);
  }
  int sum = 0, sum_x = 0, sum_y = 0;
  for (int y = 0; y < kRefineSize; ++y) {
    for (int x = 0; x < kRefineSize; ++x) {
      const int score = scores[y][x] - floor;
      const int weight = score * score;
      sum += weight;
      sum_x += weight * (x - kRefineRadius);
      sum_y += weight * (y - kRefineRadius);
    }
  }
  if (sum == 0) return Vec2f::Zero();
  return Vec2f(static_cast<float>(sum_x), static_cast<float>(sum_y)) / static_cast<float>(sum);
}

}  // namespace
}  // namespace glide
#endif

HWY_BEFORE_NAMESPACE();
namespace glide::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

/// Largest, over the 16 arcs of nine neighbours on the ring, of the smallest value in the arc.
template <class D, class V = hn::Vec<D>>
HWY_INLINE V bestArc(D d, const V (&ring)[16]) {
  V best = hn::Zero(d);
#pragma GCC unroll 8
  for (int k = 1; k < 16; k += 2) {
    const auto at = [&](int i) HWY_ATTR { return ring[(k + i) % 16]; };
    // The eight values from k on are common to the arcs that start at k - 1 and at k.
    const V half_a = hn::Min(hn::Min(at(0), at(1)), hn::Min(at(2), at(3)));
    const V half_b = hn::Min(hn::Min(at(4), at(5)), hn::Min(at(6), at(7)));
    best = hn::Max(best, hn::Min(hn::Min(half_a, half_b), hn::Max(at(15), at(8))));
  }
  return best;
}

/// Whether any lane may be a corner: an arc of nine holds two neighbouring quarter points.
template <class D, class V = hn::Vec<D>>
HWY_INLINE bool mayHoldCorner(D d, const std::uint8_t* p, const RingOffsets& ring, V limit) {
  const V center = hn::LoadU(d, p);
  V brighter[4], darker[4];
#pragma GCC unroll 4
  for (std::size_t q = 0; q < 4; ++q) {
    const V value = hn::LoadU(d, p + ring[4 * q]);
    brighter[q] = hn::SaturatedSub(value, center);
    darker[q] = hn::SaturatedSub(center, value);
  }
  V most = hn::Zero(d);
#pragma GCC unroll 4
  for (std::size_t q = 0; q < 4; ++q) {
    const std::size_t next = (q + 1) % 4;
    most = hn::Max(most, hn::Min(brighter[q], brighter[next]));
    most = hn::Max(most, hn::Min(darker[q], darker[next]));
  }
  return !hn::AllTrue(d, hn::Eq(hn::SaturatedSub(most, limit), hn::Zero(d)));
}

/// Least difference to the centre in the best arc, of the rings that are brighter (flip 0) or
/// darker (flip 255: the image in negative).
template <class D, class V = hn::Vec<D>>
HWY_INLINE V arcContrast(D d, const std::uint8_t* p, const RingOffsets& ring, V flip) {
  const V center = hn::Xor(hn::LoadU(d, p), flip);
  V above[16];
#pragma GCC unroll 16
  for (std::size_t k = 0; k < 16; ++k) {
    above[k] = hn::SaturatedSub(hn::Xor(hn::LoadU(d, p + ring[k]), flip), center);
  }
  return bestArc(d, above);
}

struct RowSpan {
  int y, x_begin, x_end;
};

/// Scores of the pixels of a row, 0 for those below min_score and for a vector's length after
/// x_end.
void scoreRow(const ImageViewU8& image, const RowSpan& span, int min_score, std::uint8_t* scores) {
  const hn::ScalableTag<std::uint8_t> d;
  const RingOffsets ring = ringOffsets(image.stride);
  const auto limit = hn::Set(d, static_cast<std::uint8_t>(min_score));
  const auto none = hn::Zero(d), all = hn::Set(d, std::uint8_t{255});
  for (int x = span.x_begin; x < span.x_end; x += static_cast<int>(hn::Lanes(d))) {
    const std::uint8_t* p = image.row(span.y) + x;
    auto score = none;
    if (mayHoldCorner(d, p, ring, limit)) {
      const auto contrast = hn::Max(arcContrast(d, p, ring, none), arcContrast(d, p, ring, all));
      score = hn::SaturatedSub(contrast, hn::Set(d, std::uint8_t{1}));
      score = hn::IfThenElseZero(hn::Eq(hn::Max(score, limit), score), score);
    }
    hn::StoreU(score, d, scores + x);
  }
  std::memset(scores + span.x_end, 0, kRowPadding);
}

template <class D>
HWY_INLINE hn::Vec<D> maxOf3(D d, const std::uint8_t* p) {
  return hn::Max(hn::Max(hn::LoadU(d, p - 1), hn::LoadU(d, p)), hn::LoadU(d, p + 1));
}

/// Appends the local maxima of the middle one of three rows of scores.
void appendMaxima(const std::array<const std::uint8_t*, 3>& rows,
                  const RowSpan& span,
                  std::vector<Corner>* corners) {
  const hn::ScalableTag<std::uint8_t> d;
  for (int x = span.x_begin; x < span.x_end; x += static_cast<int>(hn::Lanes(d))) {
    const std::uint8_t* here = rows[1] + x;
    const auto center = hn::LoadU(d, here);
    if (hn::AllTrue(d, hn::Eq(center, hn::Zero(d)))) continue;
    const auto before = hn::Max(maxOf3(d, rows[0] + x), hn::LoadU(d, here - 1));
    const auto after = hn::Max(maxOf3(d, rows[2] + x), hn::LoadU(d, here + 1));
    const auto is_maximum = hn::And(hn::Gt(center, before), hn::Eq(hn::Max(center, after), center));
    std::uint64_t bits = 0;
    hn::StoreMaskBits(d, is_maximum, reinterpret_cast<std::uint8_t*>(&bits));
    for (; bits != 0; bits &= bits - 1) {
      const int at = x + __builtin_ctzll(bits);
      if (at < span.x_end) corners->push_back({at, span.y, rows[1][at]});
    }
  }
}

void fastCornersImpl(const ImageViewU8& image,
                     int border_px,
                     int min_score,
                     std::vector<Corner>* corners) {
  const std::size_t row_size = static_cast<std::size_t>(image.width) + 2 * kRowPadding;
  std::vector<std::uint8_t> scores(3 * row_size, 0);  // of the last three rows
  const auto row = [&](int y) {
    return scores.data() + static_cast<std::size_t>(y % 3) * row_size + kRowPadding;
  };
  const int x_end = image.width - border_px, y_end = image.height - border_px;
  // One pixel more on each side, so that those at the border compare with all their neighbours.
  for (int y = border_px - 1; y <= y_end; ++y) {
    scoreRow(image, {y, border_px - 1, x_end + 1}, min_score, row(y));
    if (y > border_px) {
      appendMaxima({row(y - 2), row(y - 1), row(y)}, {y - 1, border_px, x_end}, corners);
    }
  }
}

void refineCornersImpl(const ImageViewU8& image,
                       std::span<const Corner> corners,
                       std::span<Vec2f> uv) {
  const hn::CappedTag<std::uint8_t, 16> d;
  const RingOffsets ring = ringOffsets(image.stride);
  const auto bright = hn::Zero(d), dark = hn::Set(d, std::uint8_t{255});
  HWY_ALIGN std::uint8_t scores[kRefineSize][16] = {};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Corner& c = corners[i];
    const auto store = [&](int r, hn::Vec<decltype(d)> flip) HWY_ATTR {
      for (int x = 0; x < kRefineSize; x += static_cast<int>(hn::Lanes(d))) {
        const std::uint8_t* p = image.row(c.y + r - kRefineRadius) + c.x - kRefineRadius + x;
        hn::StoreU(arcContrast(d, p, ring, flip), d, scores[r] + x);
      }
    };
    store(kRefineRadius, bright);
    const auto flip = scores[kRefineRadius][kRefineRadius] > 0 ? bright : dark;
    for (int r = 0; r < kRefineSize; ++r) store(r, flip);
    uv[i] = Vec2f(static_cast<float>(c.x), static_cast<float>(c.y)) + squaredCentroid(scores);
  }
}

}  // namespace
}  // namespace glide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glide {

HWY_EXPORT(fastCornersImpl);
HWY_EXPORT(refineCornersImpl);

void fastCorners(const ImageViewU8& image,
                 int border_px,
                 int min_score,
                 std::vector<Corner>* corners) {
  assert(border_px >= kFastReach && min_score >= 1 && min_score < 255);
  corners->clear();
  HWY_DYNAMIC_DISPATCH(fastCornersImpl)(image, border_px, min_score, corners);
}

void refineCorners(const ImageViewU8& image, std::span<const Corner> corners, std::span<Vec2f> uv) {
  assert(corners.size() == uv.size());
  HWY_DYNAMIC_DISPATCH(refineCornersImpl)(image, corners, uv);
}

}  // namespace glide
#endif
