#pragma once

#include "glide/glide_types.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <optional>

namespace glide {

/// A size-tagged struct of a caller whose header may be older or newer: what it does not know is
/// zero. Nothing when it is null, or too small to hold even its own size.
template <class T>
std::optional<T> readSized(const T* given) {
  if (given == nullptr || given->struct_size < sizeof(given->struct_size)) return std::nullopt;
  T known{};
  std::memcpy(&known, given, std::min<std::size_t>(given->struct_size, sizeof(T)));
  return known;
}

/// Whether a result struct may be written to.
template <class T>
bool isWritable(const T* out) {
  return out != nullptr && out->struct_size >= sizeof(out->struct_size);
}

/// Writes what the caller's struct has room for; its size stays.
template <class T>
void writeSized(T value, T* out) {
  value.struct_size = out->struct_size;
  std::memcpy(out, &value, std::min<std::size_t>(out->struct_size, sizeof(T)));
}

}  // namespace glide
