#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

namespace glide {

inline constexpr std::uint64_t kHashStart = 0xcbf29ce484222325U;

/// FNV-1a, 64 bits: names files and finds damage; withstands no attacker. `start` is kHashStart or
/// the hash of what comes before.
inline std::uint64_t fnv1a(std::span<const std::byte> bytes, std::uint64_t start) {
  constexpr std::uint64_t kPrime = 0x100000001b3U;
  for (const std::byte byte : bytes) start = (start ^ static_cast<std::uint64_t>(byte)) * kPrime;
  return start;
}

inline std::span<const std::byte> bytesOf(std::string_view text) {
  return std::as_bytes(std::span<const char>(text.data(), text.size()));
}

}  // namespace glide
