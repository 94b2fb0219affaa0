#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace glide {

struct GlCaps;

/// Files that belong to one GL device and driver: program binaries, what the autotuner chose. A
/// file that is missing, truncated, changed, of another driver or of another version of this
/// library is as if it were not there, and the next store() replaces it. Values; any thread.
class DeviceCache {
 public:
  /// Keeps nothing.
  DeviceCache() = default;
  /// Keeps files in `folder`, which store() makes when it is missing. Empty: keeps nothing.
  DeviceCache(std::string folder, const GlCaps& caps);

  bool isKept() const { return !folder_.empty(); }
  /// What store() was given for the same `kind` and `key` on the same device and driver.
  std::optional<std::vector<std::byte>> load(std::string_view kind, std::string_view key) const;
  /// Never fails: what cannot be written is made again at the next start.
  void store(std::string_view kind, std::string_view key, std::span<const std::byte> value) const;
  /// The file of that value; its name begins with `kind`.
  std::string path(std::string_view kind, std::string_view key) const;

 private:
  std::string folder_;
  std::string device_;  ///< vendor, renderer, version
};

}  // namespace glide
