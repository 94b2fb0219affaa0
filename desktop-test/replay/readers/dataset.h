#pragma once

#include "replay/readers/frame_source.h"

#include "glide/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace glide::replay {

/// One listed image.
struct ImageEntry {
  std::int64_t t_ns = 0;
  std::filesystem::path file;  ///< absolute or relative to the working directory
  std::string name;            ///< as listed, for messages
};

/// A sequence of image files with what lies beside it.
struct Dataset {
  std::string kind;
  std::filesystem::path path;
  std::string name;
  std::string list_name;           ///< what lists the images, for messages: "rgb.txt"
  std::vector<ImageEntry> images;  ///< strictly increasing timestamps, all of them listed
  SkipList skips;                  ///< entries that the list itself disqualifies
  int listed = 0;                  ///< entries in the list, skipped ones included
  std::optional<std::filesystem::path> calibration;
  std::string preset;  ///< calibration preset that the folder's name tells, else empty
  std::optional<std::filesystem::path> groundtruth;
};

/// TUM RGB-D layout: rgb.txt with "seconds file". io naming file and line when the list is broken.
Result<Dataset> openTum(const std::filesystem::path& folder);

/// EuRoC ASL layout: FOLDER[/mav0]/cam0/{data.csv,data/,sensor.yaml}, or FOLDER itself a cam0.
Result<Dataset> openEuroc(const std::filesystem::path& folder);

/// A folder of images in natural order (img2 before img10). Timestamps: from the file names when
/// all are seconds with a decimal point or nanoseconds of at least 16 digits and no fps is given;
/// else index / fps, 30 by default.
Result<Dataset> openImageFolder(const std::filesystem::path& folder, std::optional<double> fps);

/// Whether a file name has the extension of an image that we read.
bool isImageFile(const std::filesystem::path& file);

/// "a9" < "a10": runs of digits compare as numbers.
bool naturalLess(const std::string& a, const std::string& b);

}  // namespace glide::replay
