// write_corpus FOLDER: the files that fuzzing starts from.
#include "fuzz/map_input.h"

#include "base/file_io.h"

#include <cstdio>
#include <string>

int main(int argc, char** argv) {
  if (argc != 2) return std::fprintf(stderr, "usage: write_corpus FOLDER\n"), 1;
  const std::filesystem::path folder = argv[1];
  std::filesystem::create_directories(folder);
  int count = 0;
  for (const std::vector<std::byte>& file : glide::test::seedFiles()) {
    const std::filesystem::path path = folder / ("map" + std::to_string(count++));
    const glide::Status status =
        glide::writeFileAtomically(path, file, glide::FileDurability::synced);
    if (!status.ok()) return std::fprintf(stderr, "%s\n", status.error().message.c_str()), 1;
  }
  return 0;
}
