#pragma once

#include "synthetic/sequence.h"

#include "glide/result.h"

#include <filesystem>
#include <functional>

namespace glide::synthetic {

enum class Layout {
  tum,    ///< rgb.txt, rgb/, groundtruth.txt (camera poses), camera.yaml
  euroc,  ///< mav0/cam0 with sensor.yaml, mav0/state_groundtruth_estimate0 (body poses; T_BS is not
          ///< the identity)
};

/// How a dataset is written. Colour needs a scene that has colours.
struct DatasetFormat {
  Layout layout = Layout::tum;
  bool in_color = false;
};

/// Called after each frame with the number of frames written so far, by one thread at a time.
using Progress = std::function<void(int)>;

/// Renders the whole sequence on all cores into `folder`, which is made when missing; files in the
/// way are replaced. Frames in which the camera is carried away have no ground truth. io error
/// naming the file that cannot be written.
Status writeDataset(Sequence* sequence,
                    const DatasetFormat& format,
                    const std::filesystem::path& folder,
                    const Progress& progress);

}  // namespace glide::synthetic
