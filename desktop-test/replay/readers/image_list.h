#pragma once

#include "replay/readers/dataset.h"
#include "replay/readers/frame_source.h"

#include "glide/result.h"

#include <memory>

namespace glide::replay {

/// The entries of an ordered list that a selection keeps; start and duration count from t_first_ns.
std::vector<ImageEntry> selectEntries(const std::vector<ImageEntry>& images,
                                      const FrameSelection& selection);

/// Reads the selected images of a dataset one by one. Missing files are found here and counted
/// once. io when no image at all can be read; the message says why.
Result<std::unique_ptr<FrameSource>> openImageList(Dataset dataset,
                                                   const FrameSelection& selection);

}  // namespace glide::replay
