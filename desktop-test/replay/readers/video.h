#pragma once

#include "replay/readers/frame_source.h"

#include "glide/result.h"

#include <filesystem>
#include <memory>
#include <optional>

namespace glide::replay {

/// A video file through OpenCV. Timestamps are index / fps when fps is given, else the container's;
/// a container time that does not increase is replaced by the nominal frame interval and counted in
/// skips() as a repaired timestamp. io when the file cannot be opened or has no frame.
Result<std::unique_ptr<FrameSource>> openVideo(const std::filesystem::path& file,
                                               const FrameSelection& selection,
                                               std::optional<double> fps);

/// Whether a file name has the extension of a video.
bool isVideoFile(const std::filesystem::path& file);

}  // namespace glide::replay
