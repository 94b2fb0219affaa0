#pragma once

#include "image/image.h"

#include <cstddef>
#include <span>

namespace glide {

/// Patches are at most this wide: one row fits into the longest vector that is used.
inline constexpr int kMaxPatchSize = 15;

/// How a patch lies in memory: per patch row one row each of e, gx and gy, padded with zeros to a
/// whole vector. docs/algorithms/photometric-alignment.md names the symbols.
struct PatchLayout {
  int size = 0;    ///< n x n pixels, n odd, at most kMaxPatchSize
  int stride = 0;  ///< floats of a padded row: 8 or 16

  static PatchLayout ofSize(int size) { return {size, size <= 8 ? 8 : 16}; }
  int pixels() const { return size * size; }
  /// Floats of one patch, rounded up to whole cache lines.
  std::size_t blockSize() const {
    return static_cast<std::size_t>((3 * size * stride + 15) / 16 * 16);
  }
};

/// Where a patch is sampled: its first pixel and the fraction that all its pixels share.
struct PatchSite {
  int x = 0, y = 0;
  float frac_x = 0.0F, frac_y = 0.0F;

  /// The patch of the given half size around pixel (u, v), both not negative after subtracting it.
  static PatchSite around(double u, double v, int half) {
    const int x0 = static_cast<int>(u);
    const int y0 = static_cast<int>(v);
    return {x0 - half, y0 - half, static_cast<float>(u - x0), static_cast<float>(v - y0)};
  }
};

/// Sums over one reference patch.
struct PatchMoments {
  float mean = 0.0F;                               ///< m0, grey levels
  float e_e = 0.0F;                                ///< E
  float gx_gx = 0.0F, gx_gy = 0.0F, gy_gy = 0.0F;  ///< Gxx, Gxy, Gyy
  float gx = 0.0F, gy = 0.0F;                      ///< Gx, Gy
  float gx_e = 0.0F, gy_e = 0.0F;                  ///< Ex, Ey
};

/// A patch of the frame to be compared with a cached one.
struct PatchProbe {
  PatchSite site;
  float mean = 0.0F;              ///< m0 of the cached patch
  const float* cached = nullptr;  ///< its block, 64-byte aligned
};

/// S1, S2, Sc, Sx, Sy of one probe.
struct PatchSums {
  float s1 = 0.0F, s2 = 0.0F, sc = 0.0F, sx = 0.0F, sy = 0.0F;
};

/// Where the patches of a reference are kept, one entry of each per patch.
struct PatchCache {
  float* blocks = nullptr;  ///< blockSize() floats each, 64-byte aligned
  PatchMoments* moments = nullptr;
};

/// Samples reference patches: fills one block and its moments per site. Each patch with a border of
/// one pixel, and one more to the right and below, lies inside the image. The image's buffer is
/// that of an Image: 64 spare elements follow its last row.
void cachePatches(const ImageF& image,
                  const PatchLayout& layout,
                  std::span<const PatchSite> sites,
                  PatchCache out);

/// Compares the frame with cached patches; one result per probe. Each patch and one more pixel to
/// the right and below lie inside the image.
void sumPatches(const ImageF& image,
                const PatchLayout& layout,
                std::span<const PatchProbe> probes,
                PatchSums* sums);

}  // namespace glide
