// Entry points of libFuzzer (https://llvm.org/docs/LibFuzzer.html).
#include "fuzz/map_input.h"
#include "fuzz/map_mutator.h"

#include <cstdint>
#include <cstring>

extern "C" {

std::size_t LLVMFuzzerMutate(std::uint8_t* data, std::size_t size, std::size_t max_size);
int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data,
                                    std::size_t size,
                                    std::size_t max_size,
                                    unsigned int seed);

int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  glide::test::tryMapFile(std::as_bytes(std::span(data, size)));
  return 0;
}

// A part of the changes is libFuzzer's, which knows nothing of maps: most end at the header.
std::size_t LLVMFuzzerCustomMutator(std::uint8_t* data,
                                    std::size_t size,
                                    std::size_t max_size,
                                    unsigned int seed) {
  constexpr unsigned int kForeignShare = 4;
  if (seed % kForeignShare == 0) return LLVMFuzzerMutate(data, size, max_size);
  const auto* const begin = reinterpret_cast<const std::byte*>(data);
  const std::vector<std::byte> mutated =
      glide::test::mutatedMap(std::vector<std::byte>(begin, begin + size), seed);
  if (mutated.size() > max_size) return LLVMFuzzerMutate(data, size, max_size);
  std::memcpy(data, mutated.data(), mutated.size());
  return mutated.size();
}

}  // extern "C"
