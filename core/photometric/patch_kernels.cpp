#include "photometric/patch_kernels.h"

// foreach_target.h compiles this file once per instruction set; the best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "photometric/patch_kernels.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

#ifndef GLIDE_PHOTOMETRIC_PATCH_KERNELS_ONCE
#define GLIDE_PHOTOMETRIC_PATCH_KERNELS_ONCE
namespace glide {
namespace {
// A sampled patch with its border of one pixel: columns for two vectors, a spare row for the last.
constexpr int kRegionStride = 32;
constexpr int kRegionRows = kMaxPatchSize + 3;
}  // namespace
}  // namespace glide
#endif

HWY_BEFORE_NAMESPACE();
namespace glide::HWY_NAMESPACE {
namespace hn = hwy::HWY_NAMESPACE;

/// A row interpolated horizontally.
template <class D>
HWY_INLINE hn::Vec<D> lerpRow(D d, const float* row, hn::Vec<D> frac_x) {
  const auto left = hn::LoadU(d, row);
  return hn::MulAdd(frac_x, hn::Sub(hn::LoadU(d, row + 1), left), left);
}

/// Samples the patch and its border; columns 0..stride+1 of the region are written.
template <class D>
HWY_INLINE void sampleRegion(
    D d, const ImageF& image, const PatchLayout& layout, const PatchSite& site, float* region) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto frac_x = hn::Set(d, site.frac_x);
  const auto frac_y = hn::Set(d, site.frac_y);
  const float* first = image.row(site.y - 1) + site.x - 1;
  for (int c = 0; c <= layout.stride; c += lanes) {
    auto upper = lerpRow(d, first + c, frac_x);
    for (int r = 0; r < layout.size + 2; ++r) {
      const auto lower = lerpRow(d, first + (r + 1) * image.stride() + c, frac_x);
      const auto value = hn::MulAdd(frac_y, hn::Sub(lower, upper), upper);
      hn::StoreU(value, d, region + r * kRegionStride + c);
      upper = lower;
    }
  }
}

template <class D>
HWY_INLINE float regionMean(D d, const PatchLayout& layout, const float* region) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  auto sum = hn::Zero(d);
  for (int c = 0; c < layout.size; c += lanes) {
    const auto mask = hn::FirstN(d, static_cast<std::size_t>(layout.size - c));
    for (int r = 1; r <= layout.size; ++r) {
      const auto value = hn::LoadU(d, region + r * kRegionStride + 1 + c);
      sum = hn::Add(sum, hn::IfThenElseZero(mask, value));
    }
  }
  return hn::GetLane(hn::SumOfLanes(d, sum)) / static_cast<float>(layout.pixels());
}

/// Writes e, gx and gy of one patch.
template <class D>
HWY_INLINE void cacheRegion(
    D d, const PatchLayout& layout, const float* region, float mean, float* block) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto mean_lanes = hn::Set(d, mean);
  const auto half = hn::Set(d, 0.5F);
  for (int c = 0; c < layout.stride; c += lanes) {
    const int rest = layout.size > c ? layout.size - c : 0;
    const auto mask = hn::FirstN(d, static_cast<std::size_t>(rest));
    float* out = block + c;
    for (int r = 0; r < layout.size; ++r) {
      const float* at = region + (r + 1) * kRegionStride + 1 + c;
      const float* above = at - kRegionStride;
      const float* below = at + kRegionStride;
      const auto gx = hn::Mul(half, hn::Sub(hn::LoadU(d, at + 1), hn::LoadU(d, at - 1)));
      const auto gy = hn::Mul(half, hn::Sub(hn::LoadU(d, below), hn::LoadU(d, above)));
      const auto e = hn::Sub(hn::LoadU(d, at), mean_lanes);
      hn::Store(hn::IfThenElseZero(mask, e), d, out);
      hn::Store(hn::IfThenElseZero(mask, gx), d, out + layout.stride);
      hn::Store(hn::IfThenElseZero(mask, gy), d, out + 2 * layout.stride);
      out += 3 * layout.stride;
    }
  }
}

template <class D>
HWY_INLINE PatchMoments
blockMoments(D d, const PatchLayout& layout, float mean, const float* block) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto zero = hn::Zero(d);
  auto e_e = zero, gx_gx = zero, gx_gy = zero, gy_gy = zero;
  auto gx_sum = zero, gy_sum = zero, gx_e = zero, gy_e = zero;
  for (int r = 0; r < layout.size; ++r) {
    for (int c = 0; c < layout.stride; c += lanes) {
      const float* at = block + 3 * r * layout.stride + c;
      const auto e = hn::Load(d, at);
      const auto gx = hn::Load(d, at + layout.stride);
      const auto gy = hn::Load(d, at + 2 * layout.stride);
      e_e = hn::MulAdd(e, e, e_e);
      gx_gx = hn::MulAdd(gx, gx, gx_gx);
      gx_gy = hn::MulAdd(gx, gy, gx_gy);
      gy_gy = hn::MulAdd(gy, gy, gy_gy);
      gx_sum = hn::Add(gx, gx_sum);
      gy_sum = hn::Add(gy, gy_sum);
      gx_e = hn::MulAdd(gx, e, gx_e);
      gy_e = hn::MulAdd(gy, e, gy_e);
    }
  }
  const auto total = [d](hn::Vec<D> v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  return {mean,
          total(e_e),
          total(gx_gx),
          total(gx_gy),
          total(gy_gy),
          total(gx_sum),
          total(gy_sum),
          total(gx_e),
          total(gy_e)};
}

template <class D>
HWY_INLINE void cacheAll(D d,
                         const ImageF& image,
                         const PatchLayout& layout,
                         std::span<const PatchSite> sites,
                         PatchCache out) {
  HWY_ALIGN float region[kRegionStride * kRegionRows];
  for (const PatchSite& site : sites) {
    sampleRegion(d, image, layout, site, region);
    const float mean = regionMean(d, layout, region);
    cacheRegion(d, layout, region, mean, out.blocks);
    *out.moments++ = blockMoments(d, layout, mean, out.blocks);
    out.blocks += layout.blockSize();
  }
}

template <class D>
HWY_INLINE PatchSums
sumPatch(D d, const ImageF& image, const PatchLayout& layout, const PatchProbe& probe) {
  const int lanes = static_cast<int>(hn::Lanes(d));
  const auto frac_x = hn::Set(d, probe.site.frac_x);
  const auto frac_y = hn::Set(d, probe.site.frac_y);
  const auto mean = hn::Set(d, probe.mean);
  auto s1 = hn::Zero(d), s2 = s1, sc = s1, sx = s1, sy = s1;
  for (int c = 0; c < layout.size; c += lanes) {
    const auto mask = hn::FirstN(d, static_cast<std::size_t>(layout.size - c));
    const float* row = image.row(probe.site.y) + probe.site.x + c;
    const float* cached = probe.cached + c;
    auto upper = lerpRow(d, row, frac_x);
    for (int r = 0; r < layout.size; ++r) {
      row += image.stride();
      const auto lower = lerpRow(d, row, frac_x);
      const auto grey = hn::MulAdd(frac_y, hn::Sub(lower, upper), upper);
      const auto value = hn::IfThenElseZero(mask, hn::Sub(grey, mean));
      s1 = hn::Add(s1, value);
      s2 = hn::MulAdd(value, value, s2);
      sc = hn::MulAdd(value, hn::Load(d, cached), sc);
      sx = hn::MulAdd(value, hn::Load(d, cached + layout.stride), sx);
      sy = hn::MulAdd(value, hn::Load(d, cached + 2 * layout.stride), sy);
      cached += 3 * layout.stride;
      upper = lower;
    }
  }
  const auto total = [d](hn::Vec<D> v) HWY_ATTR { return hn::GetLane(hn::SumOfLanes(d, v)); };
  return {total(s1), total(s2), total(sc), total(sx), total(sy)};
}

template <class D>
HWY_INLINE void sumAll(D d,
                       const ImageF& image,
                       const PatchLayout& layout,
                       std::span<const PatchProbe> probes,
                       PatchSums* sums) {
  for (const PatchProbe& probe : probes) *sums++ = sumPatch(d, image, layout, probe);
}

void cachePatchesImpl(const ImageF& image,
                      const PatchLayout& layout,
                      std::span<const PatchSite> sites,
                      PatchCache out) {
  // One type where vectors are short, two where they are long.
  // NOLINTNEXTLINE(bugprone-branch-clone)
  if (layout.stride == 8) {
    cacheAll(hn::CappedTag<float, 8>(), image, layout, sites, out);
  } else {
    cacheAll(hn::CappedTag<float, 16>(), image, layout, sites, out);
  }
}

void sumPatchesImpl(const ImageF& image,
                    const PatchLayout& layout,
                    std::span<const PatchProbe> probes,
                    PatchSums* sums) {
  // NOLINTNEXTLINE(bugprone-branch-clone)
  if (layout.stride == 8) {
    sumAll(hn::CappedTag<float, 8>(), image, layout, probes, sums);
  } else {
    sumAll(hn::CappedTag<float, 16>(), image, layout, probes, sums);
  }
}

}  // namespace glide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glide {

HWY_EXPORT(cachePatchesImpl);
HWY_EXPORT(sumPatchesImpl);

void cachePatches(const ImageF& image,
                  const PatchLayout& layout,
                  std::span<const PatchSite> sites,
                  PatchCache out) {
  HWY_DYNAMIC_DISPATCH(cachePatchesImpl)(image, layout, sites, out);
}

void sumPatches(const ImageF& image,
                const PatchLayout& layout,
                std::span<const PatchProbe> probes,
                PatchSums* sums) {
  HWY_DYNAMIC_DISPATCH(sumPatchesImpl)(image, layout, probes, sums);
}

}  // namespace glide
#endif
