#include "gpu/gpu_tuning.h"

#include <array>
#include <cstdint>
#include <cstring>

namespace glide {
namespace {

// Group size, plan, pyramid kernel, pixels of a single group.
using Fields = std::array<std::int32_t, 4>;

bool isGroupSize(std::int32_t value) { return value == 32 || value == 64 || value == 128; }

template <class Enum>
bool isUpTo(std::int32_t value, Enum last) {
  return value >= 0 && value <= static_cast<std::int32_t>(last);
}

}  // namespace

std::vector<std::byte> encodeTuning(const GpuTuning& tuning) {
  const Fields fields{tuning.group_size,
                      static_cast<std::int32_t>(tuning.plan),
                      static_cast<std::int32_t>(tuning.pyramid),
                      tuning.single_group_pixels};
  std::vector<std::byte> bytes(sizeof(fields));
  std::memcpy(bytes.data(), fields.data(), sizeof(fields));
  return bytes;
}

std::optional<GpuTuning> decodeTuning(std::span<const std::byte> bytes) {
  Fields fields{};
  if (bytes.size() != sizeof(fields)) return std::nullopt;
  std::memcpy(fields.data(), bytes.data(), sizeof(fields));
  const auto [group_size, plan, pyramid, single_group_pixels] = fields;
  if (!isGroupSize(group_size) || !isUpTo(plan, GpuPlan::paper) ||
      !isUpTo(pyramid, PyramidKernel::two_pass) || single_group_pixels < 0) {
    return std::nullopt;
  }
  return GpuTuning{group_size,
                   static_cast<GpuPlan>(plan),
                   static_cast<PyramidKernel>(pyramid),
                   single_group_pixels};
}

}  // namespace glide
