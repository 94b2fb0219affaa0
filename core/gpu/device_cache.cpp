#include "gpu/device_cache.h"

#include "gpu/gl_caps.h"

#include "base/file_io.h"
#include "base/hash.h"

#include <array>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <system_error>
#include <type_traits>

namespace glide {
namespace {

namespace fs = std::filesystem;

/// Raised when the format of any value that is kept changes: older files are then stale.
constexpr std::uint32_t kFormat = 1;
constexpr std::array<char, 8> kMagic{'G', 'L', 'I', 'D', 'E', 'G', 'P', 'U'};

/// What a file begins with, in the byte order of the machine that wrote it: files never travel.
struct Header {
  std::array<char, 8> magic = kMagic;
  std::uint32_t format = kFormat;
  std::uint32_t key_bytes = 0;
  std::uint64_t value_bytes = 0;
  std::uint64_t checksum = 0;  ///< of key and value
};
static_assert(std::is_trivially_copyable_v<Header> && sizeof(Header) == 32);

std::string hexadecimal(std::uint64_t value) {
  constexpr std::string_view kDigits = "0123456789abcdef";
  constexpr int kBits = 64;
  std::string text;
  for (int shift = kBits - 4; shift >= 0; shift -= 4) text += kDigits[(value >> shift) & 0xFU];
  return text;
}

/// The whole key, as the file holds it.
std::string fullKey(const std::string& device, std::string_view key) {
  return device + std::string(key);
}

/// The value in `file`, or nothing when any byte of it is not what store() wrote for `key`.
std::optional<std::vector<std::byte>> valueOf(std::span<const std::byte> file,
                                              const std::string& key) {
  Header header;
  if (file.size() < sizeof(header)) return std::nullopt;
  std::memcpy(&header, file.data(), sizeof(header));
  file = file.subspan(sizeof(header));
  if (header.magic != kMagic || header.format != kFormat || header.key_bytes != key.size() ||
      header.key_bytes > file.size() || header.value_bytes != file.size() - header.key_bytes ||
      header.checksum != fnv1a(file, kHashStart) ||
      std::memcmp(file.data(), key.data(), key.size()) != 0) {
    return std::nullopt;
  }
  const std::span<const std::byte> value = file.subspan(key.size());
  return std::vector<std::byte>(value.begin(), value.end());
}

}  // namespace

DeviceCache::DeviceCache(std::string folder, const GlCaps& caps)
    : folder_(std::move(folder)),
      device_(caps.vendor + '\n' + caps.renderer + '\n' + caps.version + '\n') {}

std::string DeviceCache::path(std::string_view kind, std::string_view key) const {
  const std::uint64_t name = fnv1a(bytesOf(fullKey(device_, key)), kHashStart);
  return (fs::path(folder_) / (std::string(kind) + "-" + hexadecimal(name) + ".bin")).string();
}

std::optional<std::vector<std::byte>> DeviceCache::load(std::string_view kind,
                                                        std::string_view key) const {
  if (!isKept()) return std::nullopt;
  const Result<std::vector<std::byte>> file = readFile(path(kind, key));
  if (!file) return std::nullopt;
  return valueOf(*file, fullKey(device_, key));
}

void DeviceCache::store(std::string_view kind,
                        std::string_view key,
                        std::span<const std::byte> value) const {
  if (!isKept()) return;
  const std::string full_key = fullKey(device_, key);
  std::vector<std::byte> file(sizeof(Header));
  file.insert(file.end(), bytesOf(full_key).begin(), bytesOf(full_key).end());
  file.insert(file.end(), value.begin(), value.end());
  Header header;
  header.key_bytes = static_cast<std::uint32_t>(full_key.size());
  header.value_bytes = value.size();
  header.checksum = fnv1a(std::span<const std::byte>(file).subspan(sizeof(Header)), kHashStart);
  std::memcpy(file.data(), &header, sizeof(header));
  std::error_code ignored;
  fs::create_directories(folder_, ignored);
  static_cast<void>(writeFileAtomically(path(kind, key), file, FileDurability::cached));
}

}  // namespace glide
