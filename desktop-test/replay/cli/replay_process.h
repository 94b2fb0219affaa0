#pragma once

#include <string>
#include <string_view>
#include <sys/types.h>
#include <utility>
#include <vector>

namespace glide::replay {

/// glide-replay on a terminal of its own, 80 characters wide, while it runs.
class ReplayProcess {
 public:
  using Variables = std::vector<std::pair<std::string, std::string>>;

  /// Starts it with these arguments; `variables` are set in its environment.
  ReplayProcess(const std::vector<std::string>& arguments, const Variables& variables);
  /// Kills what still runs.
  ~ReplayProcess();
  ReplayProcess(const ReplayProcess&) = delete;
  ReplayProcess& operator=(const ReplayProcess&) = delete;

  /// Whether the program writes `text` before it ends or a minute has passed.
  bool writes(std::string_view text);
  /// As if a person typed it: "\x03" is Ctrl-C.
  void type(std::string_view keys) const;
  /// Reads to the end. The exit status, or 128 + the signal that ended it.
  int wait();
  /// All that was written so far; lines end with "\r\n".
  const std::string& screen() const { return screen_; }

 private:
  /// False at the end, and when nothing comes.
  bool read();

  int terminal_ = -1;
  pid_t process_ = -1;
  std::string screen_;
};

}  // namespace glide::replay
