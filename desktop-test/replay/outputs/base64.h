#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <vector>

namespace glide::replay {

/// RFC 4648, with padding, on one line.
std::string base64(std::span<const std::uint8_t> bytes);

/// The length of base64() of so many bytes.
constexpr std::size_t base64Size(std::size_t bytes) { return (bytes + 2) / 3 * 4; }

/// Numbers as they lie in memory: little-endian on every machine that this is built for.
template <class T>
std::string base64Of(const std::vector<T>& numbers) {
  static_assert(std::is_trivially_copyable_v<T>);
  const auto* bytes = reinterpret_cast<const std::uint8_t*>(numbers.data());
  return base64({bytes, numbers.size() * sizeof(T)});
}

}  // namespace glide::replay
