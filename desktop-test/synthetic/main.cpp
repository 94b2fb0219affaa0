// glide-synth: writes a synthetic dataset. Exit status: 0 ok, 1 usage, 2 the folder cannot be
// written.
#include "synthetic/command_line.h"
#include "synthetic/dataset_writer.h"

#include <cstdio>
#include <exception>
#include <system_error>
#include <unistd.h>

namespace {

using namespace glide::synthetic;

constexpr int kUsage = 1, kCannotWrite = 2;

bool isOccupied(const std::filesystem::path& folder) {
  std::error_code error;
  return std::filesystem::exists(folder, error) && !std::filesystem::is_empty(folder, error);
}

Progress makeProgress(const Command& command) {
  const bool is_shown = !command.quiet && isatty(STDERR_FILENO) != 0;
  const int frames = command.sequence.frames;
  return [is_shown, frames](int done) {
    if (is_shown)
      std::fprintf(stderr, "\r%d of %d frames%s", done, frames, done == frames ? "\n" : "");
  };
}

int fail(int status, const std::string& message) {
  std::fprintf(stderr, "glide synth: %s\n", message.c_str());
  return status;
}

int run(const Command& command) {
  if (!command.overwrite && isOccupied(command.folder)) {
    return fail(kCannotWrite,
                command.folder.string() + ": is not empty (pass --overwrite to write into it)");
  }
  auto sequence = Sequence::create(command.sequence);
  if (!sequence) return fail(kUsage, sequence.error().message);
  if (command.format.in_color && !sequence->scene()->has_color)
    return fail(kUsage, "--color: this scene is gray (--scene living-room has colours)");
  const auto status =
      writeDataset(&*sequence, command.format, command.folder, makeProgress(command));
  if (!status) return fail(kCannotWrite, status.error().message);
  if (!command.quiet) std::printf("%d frames in %s\n", sequence->size(), command.folder.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  try {
    int exit_status = 0;
    const auto command = parseCommandLine(argc, argv, &exit_status);
    return command ? run(*command) : exit_status;
  } catch (const std::exception& error) {
    return fail(kCannotWrite, error.what());
  }
}
