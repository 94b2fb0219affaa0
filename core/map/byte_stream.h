#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <type_traits>
#include <vector>

namespace glide {

template <std::size_t kBytes>
using UnsignedOfSize =
    std::conditional_t<kBytes == 1,
                       std::uint8_t,
                       std::conditional_t<kBytes == 4, std::uint32_t, std::uint64_t>>;

/// Appends numbers to a vector, least significant byte first, floats by their IEEE 754 bits.
class ByteWriter {
 public:
  explicit ByteWriter(std::vector<std::byte>* bytes) : bytes_(bytes) {}

  template <class Number>
  void operator()(const Number& number) {
    static_assert(std::is_arithmetic_v<Number>);
    UnsignedOfSize<sizeof(Number)> bits{};
    std::memcpy(&bits, &number, sizeof(Number));
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bytes_->push_back(static_cast<std::byte>((bits >> (8 * i)) & 0xFFU));
    }
  }

  void operator()(std::span<std::uint8_t> block) {
    const std::size_t begin = bytes_->size();
    bytes_->resize(begin + block.size());
    std::memcpy(bytes_->data() + begin, block.data(), block.size());
  }

 private:
  std::vector<std::byte>* bytes_;
};

/// Reads what ByteWriter wrote. The caller has made sure that the bytes are there.
class ByteReader {
 public:
  explicit ByteReader(std::span<const std::byte> bytes) : bytes_(bytes) {}

  template <class Number>
  void operator()(Number& number) {
    static_assert(std::is_arithmetic_v<Number>);
    assert(bytes_.size() >= sizeof(Number));
    UnsignedOfSize<sizeof(Number)> bits{};
    for (std::size_t i = 0; i < sizeof(Number); ++i) {
      bits |= static_cast<decltype(bits)>(static_cast<decltype(bits)>(bytes_[i]) << (8 * i));
    }
    std::memcpy(&number, &bits, sizeof(Number));
    bytes_ = bytes_.subspan(sizeof(Number));
  }

  void operator()(std::span<std::uint8_t> block) {
    assert(bytes_.size() >= block.size());
    std::memcpy(block.data(), bytes_.data(), block.size());
    bytes_ = bytes_.subspan(block.size());
  }

 private:
  std::span<const std::byte> bytes_;
};

}  // namespace glide
