#pragma once

#include <filesystem>
#include <string>
#include <vector>

namespace glide::replay {

/// What a program left behind.
struct ProgramResult {
  int exit_code = -1;
  std::string out;
  std::string err;
};

/// Runs a shell command line, with `folder` for the captured output.
ProgramResult runShell(const std::string& command, const std::filesystem::path& folder);

/// Runs glide-replay with these arguments (no quoting: no spaces inside one).
ProgramResult runReplay(const std::vector<std::string>& arguments,
                        const std::filesystem::path& folder);

/// frames.csv without the columns that tell times.
std::string withoutTimes(const std::string& csv);

}  // namespace glide::replay
