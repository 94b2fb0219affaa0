#include "image/pyramid.h"

#include <algorithm>
#include <cassert>

// foreach_target.h compiles this file once per instruction set; the best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "image/pyramid.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef GLIDE_IMAGE_PYRAMID_ONCE
#define GLIDE_IMAGE_PYRAMID_ONCE
namespace glide {
namespace {
// No longer than the padding of an image row, so that whole vectors fit at its end.
constexpr int kMaxLanes = 16;
constexpr std::size_t kRowMargin = kMaxLanes;  // left of column 0 of the blurred row; two are used
constexpr std::size_t kRowSpare =
    4 * kMaxLanes;  // right of it: two border pixels, then whole vectors
}  // namespace
}  // namespace glide
#endif

HWY_BEFORE_NAMESPACE();
namespace glide::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;
using Floats = hn::CappedTag<float, kMaxLanes>;

/// Bytes to floats. The source has no padding: its last pixels are read by a vector that ends with
/// the row.
void convertRow(const std::uint8_t* luma, int width, float* out) {
  const Floats d;
  const hn::Rebind<std::int32_t, Floats> d32;
  const hn::Rebind<std::uint8_t, Floats> d8;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto convert = [&](int x) HWY_ATTR {
    hn::StoreU(hn::ConvertTo(d, hn::PromoteTo(d32, hn::LoadU(d8, luma + x))), d, out + x);
  };
  int x = 0;
  for (; x + lanes <= width; x += lanes) convert(x);
  if (x < width && width >= lanes) {
    convert(width - lanes);
  } else {
    for (; x < width; ++x) out[x] = static_cast<float>(luma[x]);
  }
}

void convertImage(const ImageViewU8& luma, ImageF* out) {
  for (int y = 0; y < luma.height; ++y) convertRow(luma.row(y), luma.width, out->row(y));
}

/// Weights 1 4 6 4 1 down the columns around row 2y, not normalised.
void blurColumns(const ImageF& fine, int y, float* blurred) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const int last = fine.height() - 1;
  const float* row0 = fine.row(std::max(2 * y - 2, 0));
  const float* row1 = fine.row(std::max(2 * y - 1, 0));
  const float* row2 = fine.row(2 * y);
  const float* row3 = fine.row(std::min(2 * y + 1, last));
  const float* row4 = fine.row(std::min(2 * y + 2, last));
  const auto four = hn::Set(d, 4.0F);
  const auto six = hn::Set(d, 6.0F);
  for (int x = 0; x < fine.width(); x += lanes) {
    const auto ends = hn::Add(hn::LoadU(d, row0 + x), hn::LoadU(d, row4 + x));
    const auto middles = hn::Add(hn::LoadU(d, row1 + x), hn::LoadU(d, row3 + x));
    const auto sum = hn::MulAdd(six, hn::LoadU(d, row2 + x), hn::MulAdd(four, middles, ends));
    hn::StoreU(sum, d, blurred + x);
  }
}

/// The same weights along the row at its even pixels, normalised for both directions.
void blurAndDecimateRow(const float* blurred, int width, float* out) {
  const Floats d;
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto four = hn::Set(d, 4.0F);
  const auto six = hn::Set(d, 6.0F);
  const auto norm = hn::Set(d, 1.0F / 256.0F);
  for (int x = 0; x < width; x += lanes) {
    hn::Vec<Floats> left2, left1, centre, right1, right2, unused;
    hn::LoadInterleaved2(d, blurred + 2 * x - 2, left2, left1);
    hn::LoadInterleaved2(d, blurred + 2 * x, centre, right1);
    hn::LoadInterleaved2(d, blurred + 2 * x + 2, right2, unused);
    const auto ends = hn::Add(left2, right2);
    const auto sum = hn::MulAdd(six, centre, hn::MulAdd(four, hn::Add(left1, right1), ends));
    hn::StoreU(hn::Mul(norm, sum), d, out + x);
  }
}

/// One level down. `blurred` points at column 0 of a row with kRowMargin before and kRowSpare after
/// it.
void halveImage(const ImageF& fine, float* blurred, ImageF* coarse) {
  const int width = fine.width();
  for (int y = 0; y < coarse->height(); ++y) {
    blurColumns(fine, y, blurred);
    blurred[-2] = blurred[-1] = blurred[0];
    blurred[width] = blurred[width + 1] = blurred[width - 1];
    blurAndDecimateRow(blurred, coarse->width(), coarse->row(y));
  }
}

}  // namespace glide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glide {

HWY_EXPORT(convertImage);
HWY_EXPORT(halveImage);

namespace {
constexpr int kMinLevelSize = 8;  // px; a smaller level holds no patch
}

int pyramidLevels(int width, int height, int levels) {
  int count = 1;
  while (count < levels) {
    width = (width + 1) / 2;
    height = (height + 1) / 2;
    if (std::min(width, height) < kMinLevelSize) break;
    ++count;
  }
  return count;
}

void buildPyramid(const ImageViewU8& luma, int levels, Pyramid* out) {
  assert(luma.data != nullptr && luma.width > 0 && luma.height > 0 && levels > 0);
  out->levels.resize(static_cast<std::size_t>(pyramidLevels(luma.width, luma.height, levels)));
  out->levels.front().resize(luma.width, luma.height);
  HWY_DYNAMIC_DISPATCH(convertImage)(luma, &out->levels.front());

  out->blurred_row.resize(kRowMargin + static_cast<std::size_t>(luma.width) + kRowSpare);
  for (std::size_t l = 1; l < out->levels.size(); ++l) {
    const ImageF& fine = out->levels[l - 1];
    out->levels[l].resize((fine.width() + 1) / 2, (fine.height() + 1) / 2);
    HWY_DYNAMIC_DISPATCH(halveImage)(fine, out->blurred_row.data() + kRowMargin, &out->levels[l]);
  }
}

}  // namespace glide
#endif
