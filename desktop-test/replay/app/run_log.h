#pragma once

#include "glide/result.h"

#include <filesystem>
#include <fstream>
#include <string>

namespace glide::replay {

/// log.txt and what is told on stderr. Lines before open() are kept and written then.
class RunLog {
 public:
  /// Starts the file with the lines so far.
  Status open(const std::filesystem::path& file);

  /// To the file only.
  void note(const std::string& line);
  /// To the file and to stderr.
  void say(const std::string& line);

 private:
  std::string early_;
  std::ofstream file_;
};

}  // namespace glide::replay
