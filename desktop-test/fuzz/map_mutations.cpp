// map_mutations RUNS SEED: what map_fuzz does, blindly, for compilers without libFuzzer. Chains of
// changes to the seed files, the same ones for the same seed.
#include "fuzz/map_input.h"
#include "fuzz/map_mutator.h"

#include <cstdio>
#include <cstdlib>
#include <random>

int main(int argc, char** argv) {
  if (argc != 3) return std::fprintf(stderr, "usage: map_mutations RUNS SEED\n"), 1;
  const long runs = std::strtol(argv[1], nullptr, 10);
  std::mt19937_64 random(std::strtoull(argv[2], nullptr, 10));
  constexpr int kChain = 4;  // changes until the next seed file: most maps are none after some
  const std::vector<std::vector<std::byte>> seeds = glide::test::seedFiles();
  std::vector<std::byte> file;
  for (long run = 0; run < runs; ++run) {
    if (run % kChain == 0) file = seeds[random() % seeds.size()];
    file = glide::test::mutatedMap(std::move(file), random());
    glide::test::tryMapFile(file);
  }
  std::printf("%ld changed map files: none broke the reader\n", runs);
  return 0;
}
