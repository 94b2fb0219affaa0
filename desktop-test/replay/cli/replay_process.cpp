#include "replay/cli/replay_process.h"

#include <array>
#include <csignal>
#include <cstdlib>
#include <poll.h>
#include <pty.h>
#include <sys/wait.h>
#include <unistd.h>

namespace glide::replay {
namespace {

constexpr winsize kSize{24, 80, 0, 0};
constexpr int kPatienceMs = 60'000;

[[noreturn]] void become(const std::vector<std::string>& arguments,
                         const ReplayProcess::Variables& variables) {
  for (const char* name : {"NO_COLOR", "CLICOLOR_FORCE"}) unsetenv(name);
  setenv("TERM", "xterm-256color", 1);
  for (const auto& [name, value] : variables) setenv(name.c_str(), value.c_str(), 1);
  std::signal(SIGINT, SIG_DFL);  // whoever started the test may ignore it
  std::vector<char*> words{const_cast<char*>(GLIDE_REPLAY_PROGRAM)};
  for (const std::string& argument : arguments)
    words.push_back(const_cast<char*>(argument.c_str()));
  words.push_back(nullptr);
  execv(words[0], words.data());
  _exit(127);
}

}  // namespace

ReplayProcess::ReplayProcess(const std::vector<std::string>& arguments,
                             const Variables& variables) {
  process_ = forkpty(&terminal_, nullptr, nullptr, &kSize);
  if (process_ == 0) become(arguments, variables);
}

ReplayProcess::~ReplayProcess() {
  if (process_ > 0) {
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }
  if (terminal_ >= 0) close(terminal_);
}

bool ReplayProcess::read() {
  pollfd event{terminal_, POLLIN, 0};
  if (poll(&event, 1, kPatienceMs) <= 0) return false;
  std::array<char, 4096> piece{};
  const ssize_t size =
      ::read(terminal_, piece.data(), piece.size());  // EIO: nobody writes any more
  if (size <= 0) return false;
  screen_.append(piece.data(), static_cast<std::size_t>(size));
  return true;
}

bool ReplayProcess::writes(std::string_view text) {
  while (screen_.find(text) == std::string::npos) {
    if (!read()) return false;
  }
  return true;
}

void ReplayProcess::type(std::string_view keys) const {
  if (write(terminal_, keys.data(), keys.size()) < 0) perror("ReplayProcess::type");
}

int ReplayProcess::wait() {
  while (read()) continue;
  int status = 0;
  waitpid(process_, &status, 0);
  process_ = -1;
  return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

}  // namespace glide::replay
