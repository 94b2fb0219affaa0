#include "fuzz/map_mutator.h"

#include "map/map_header.h"
#include "map/map_records.h"

#include <algorithm>
#include <array>
#include <random>

namespace glide::test {
namespace {

using Bytes = std::vector<std::byte>;

constexpr std::size_t kTableEntryBytes = 8;
constexpr std::size_t kTableOffset = kMapHeaderBytes - kMapSections * kTableEntryBytes;

/// Bit patterns on which decoders stumble: NaN and infinities, ends of ranges, small indices.
constexpr std::array<std::uint64_t, 14> kNumbers{0,
                                                 1,
                                                 2,
                                                 3,
                                                 5,
                                                 0x7F,
                                                 0xFF,
                                                 0x7FFFFFFF,
                                                 0xFFFFFFFF,
                                                 0x7FC00000,
                                                 0x7F80000000000000,
                                                 0x7FF0000000000000,
                                                 0x7FF8000000000000,
                                                 0xFFFFFFFFFFFFFFFF};

class Mutation {
 public:
  Mutation(Bytes* file, const MapHeader& header, std::uint64_t seed)
      : file_(*file), header_(header), random_(seed) {}

  void apply() {
    chooseRecord();
    switch (below(8)) {
      case 0:
        return duplicateRecord();
      case 1:
        return removeRecord();
      case 2:
        return swapRecords();
      case 3:
        return replaceNumber(0, kMapHeaderBytes);
      default:
        return replaceNumber(begin_, bytes_);
    }
  }

 private:
  Bytes& file_;
  const MapHeader& header_;
  std::mt19937_64 random_;
  std::size_t section_ = 0, count_ = 0, first_ = 0, begin_ = 0, bytes_ = 0;

  std::size_t below(std::size_t limit) { return limit > 0 ? random_() % limit : 0; }

  void chooseRecord() {
    const std::array<std::size_t, kMapSections> record_bytes{bytesOf<KeyframeRecord>(),
                                                             bytesOf<FeatureRecord>(),
                                                             bytesOf<PatchRecord>(),
                                                             bytesOf<LandmarkRecord>(),
                                                             bytesOf<RetiredRecord>(),
                                                             bytesOf<LoopRecord>()};
    section_ = below(kMapSections);
    count_ = header_.counts[section_];
    bytes_ = count_ > 0 ? record_bytes[section_] : 0;
    first_ = static_cast<std::size_t>(header_.offset(static_cast<MapSection>(section_)));
    begin_ = first_ + below(count_) * bytes_;
  }

  void setCount(std::size_t count) {
    for (std::size_t i = 0; i < sizeof(std::uint32_t); ++i) {
      file_[kTableOffset + section_ * kTableEntryBytes + i] =
          static_cast<std::byte>((count >> (8 * i)) & 0xFFU);
    }
  }

  Bytes::iterator at(std::size_t offset) {
    return file_.begin() + static_cast<std::ptrdiff_t>(offset);
  }

  void duplicateRecord() {
    const Bytes record(at(begin_), at(begin_ + bytes_));
    file_.insert(at(first_ + below(count_ + 1) * bytes_), record.begin(), record.end());
    setCount(count_ + (bytes_ > 0 ? 1 : 0));
  }

  void removeRecord() {
    file_.erase(at(begin_), at(begin_ + bytes_));
    setCount(count_ - (bytes_ > 0 ? 1 : 0));
  }

  void swapRecords() {
    const std::size_t other = first_ + below(count_) * bytes_;
    if (other != begin_) std::swap_ranges(at(begin_), at(begin_ + bytes_), at(other));
  }

  void replaceNumber(std::size_t begin, std::size_t bytes) {
    const std::size_t width = std::size_t{1} << below(4);
    if (bytes < width) return;
    const std::uint64_t number = below(2) == 0 ? random_() : kNumbers[below(kNumbers.size())];
    const std::size_t offset = begin + below(bytes - width + 1);
    for (std::size_t i = 0; i < width; ++i) {
      file_[offset + i] = static_cast<std::byte>((number >> (8 * i)) & 0xFFU);
    }
  }
};

}  // namespace

std::vector<std::byte> mutatedMap(std::vector<std::byte> file, std::uint64_t seed) {
  sealMapFile(file);
  MapHeader header;
  if (readMapHeader(file, &header)) return file;
  Mutation(&file, header, seed).apply();
  sealMapFile(file);
  return file;
}

}  // namespace glide::test
