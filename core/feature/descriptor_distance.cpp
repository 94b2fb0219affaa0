#include "feature/descriptor.h"

#include <cassert>
#include <cstddef>
#include <cstdint>

// foreach_target.h compiles this file once per instruction set; the best one is chosen at run time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "feature/descriptor_distance.cpp"
#include <hwy/foreach_target.h>
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace glide::HWY_NAMESPACE {
namespace {
namespace hn = hwy::HWY_NAMESPACE;

void distancesImpl(const Descriptor& query,
                   std::span<const Descriptor> set,
                   std::span<const int> indices,
                   int* out) {
  const hn::CappedTag<std::uint64_t, 4> d;
  for (const int index : indices) {
    const std::uint64_t* other = set[static_cast<std::size_t>(index)].data();
    auto counts = hn::Zero(d);
    for (std::size_t w = 0; w < query.size(); w += hn::Lanes(d)) {
      const auto differing = hn::Xor(hn::LoadU(d, query.data() + w), hn::LoadU(d, other + w));
      counts = hn::Add(counts, hn::PopulationCount(differing));
    }
    *out++ = static_cast<int>(hn::GetLane(hn::SumOfLanes(d, counts)));
  }
}

}  // namespace
}  // namespace glide::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace glide {
namespace {

/// Set bits of each pair, then nibble, then byte ("Hacker's Delight", section 5-1): without the
/// instruction, which the x86-64 baseline lacks, __builtin_popcountll is a call.
std::uint64_t bitsPerByte(std::uint64_t x) {
  x -= (x >> 1U) & 0x5555555555555555U;
  x = (x & 0x3333333333333333U) + ((x >> 2U) & 0x3333333333333333U);
  return (x + (x >> 4U)) & 0x0f0f0f0f0f0f0f0fU;
}

}  // namespace

HWY_EXPORT(distancesImpl);

int descriptorDistance(const Descriptor& a, const Descriptor& b) {
  std::uint64_t bytes = 0;  // at most 4 * 8 in each
  for (std::size_t i = 0; i < a.size(); ++i) bytes += bitsPerByte(a[i] ^ b[i]);
  // Sums of 16-bit fields, because eight bytes of up to 32 would overflow one.
  constexpr std::uint64_t kLowBytes = 0x00ff00ff00ff00ffU;
  const std::uint64_t pairs = (bytes & kLowBytes) + ((bytes >> 8U) & kLowBytes);
  return static_cast<int>((pairs * 0x0001000100010001U) >> 48U);
}

void descriptorDistances(const Descriptor& query,
                         std::span<const Descriptor> set,
                         std::span<const int> indices,
                         std::span<int> out) {
  assert(indices.size() == out.size());
  HWY_DYNAMIC_DISPATCH(distancesImpl)(query, set, indices, out.data());
}

}  // namespace glide
#endif
