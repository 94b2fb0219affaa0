#include "replay/cli/replay_program.h"

#include "replay/common/text.h"

#include <cstdlib>
#include <sstream>
#include <sys/wait.h>

namespace glide::replay {

ProgramResult runShell(const std::string& command, const std::filesystem::path& folder) {
  const std::filesystem::path out = folder / "stdout.txt", err = folder / "stderr.txt";
  const int status = std::system((command + " > " + out.string() + " 2> " + err.string()).c_str());
  ProgramResult result;
  result.exit_code = WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
  if (const auto text = readFile(out)) result.out = *text;
  if (const auto text = readFile(err)) result.err = *text;
  return result;
}

ProgramResult runReplay(const std::vector<std::string>& arguments,
                        const std::filesystem::path& folder) {
  std::string command = GLIDE_REPLAY_PROGRAM;
  for (const std::string& argument : arguments) command += " " + argument;
  return runShell(command, folder);
}

std::string withoutTimes(const std::string& csv) {
  constexpr std::size_t kFirstTime = 5, kLastTime = 12;
  std::string result;
  std::istringstream lines(csv);
  for (std::string line; std::getline(lines, line);) {
    const auto fields = splitFields(line, ",");
    for (std::size_t i = 0; i < fields.size(); ++i) {
      if (i < kFirstTime || i > kLastTime) result += std::string(fields[i]) + ",";
    }
    result += "\n";
  }
  return result;
}

}  // namespace glide::replay
