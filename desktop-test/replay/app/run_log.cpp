#include "replay/app/run_log.h"

#include "replay/common/text.h"

#include <iostream>

namespace glide::replay {

Status RunLog::open(const std::filesystem::path& file) {
  file_.open(file, std::ios::binary);
  if (!file_) return errorIn(file, "cannot be written");
  file_ << early_ << std::flush;
  early_.clear();
  return Unit{};
}

void RunLog::note(const std::string& line) {
  if (file_.is_open()) {
    file_ << line << std::endl;  // flushed: the log matters most when the program dies
  } else {
    early_ += line + "\n";
  }
}

void RunLog::say(const std::string& line) {
  note(line);
  std::cerr << line << std::endl;
}

}  // namespace glide::replay
