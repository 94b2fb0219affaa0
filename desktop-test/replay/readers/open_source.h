#pragma once

#include "replay/readers/frame_source.h"

#include "glide/result.h"

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

namespace glide::replay {

/// An open sequence with what was found beside it.
struct OpenedSource {
  std::unique_ptr<FrameSource> frames;
  std::string calibration;  ///< file or preset name that belongs to it, empty when there is none
  std::optional<std::filesystem::path> groundtruth;
};

/// Opens what the command line names: a path, whose layout is recognised, or one with a prefix
/// "tum:", "euroc:", "video:" or "images:" that forces it. io with a message for people.
Result<OpenedSource> openSource(const std::string& spec,
                                const FrameSelection& selection,
                                std::optional<double> fps);

}  // namespace glide::replay
