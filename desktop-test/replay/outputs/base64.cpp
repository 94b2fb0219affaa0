#include "replay/outputs/base64.h"

namespace glide::replay {
namespace {

constexpr char kAlphabet[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
constexpr unsigned kBitsPerCharacter = 6;
constexpr std::uint32_t kCharacterMask = 63;

}  // namespace

std::string base64(std::span<const std::uint8_t> bytes) {
  std::string text;
  text.reserve(base64Size(bytes.size()));
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t present = bytes.size() - i < 3 ? bytes.size() - i : 3;
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k) group = group << 8 | (k < present ? bytes[i + k] : 0U);
    for (std::size_t k = 0; k < 4; ++k) {
      const unsigned shift = kBitsPerCharacter * static_cast<unsigned>(3 - k);
      text += k <= present ? kAlphabet[(group >> shift) & kCharacterMask] : '=';
    }
  }
  return text;
}

}  // namespace glide::replay
