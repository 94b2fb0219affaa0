#pragma once

#include "synthetic/dataset_writer.h"
#include "synthetic/sequence.h"

#include <filesystem>
#include <optional>

namespace glide::synthetic {

/// What `glide-synth` was asked to do.
struct Command {
  std::filesystem::path folder;
  DatasetFormat format;
  bool overwrite = false;
  bool quiet = false;
  SequenceOptions sequence;
};

/// Nothing when there is nothing to do (help) or the arguments are wrong; then `exit_status` says
/// which, and the text has been printed.
std::optional<Command> parseCommandLine(int argc, char** argv, int* exit_status);

}  // namespace glide::synthetic
