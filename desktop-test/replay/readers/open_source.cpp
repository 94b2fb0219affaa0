#include "replay/readers/open_source.h"

#include "replay/common/text.h"
#include "replay/readers/dataset.h"
#include "replay/readers/image_list.h"
#include "replay/readers/video.h"

#include <algorithm>
#include <string_view>
#include <utility>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;

struct Spec {
  std::string kind;  ///< empty: to be recognised
  fs::path path;
};

Spec splitSpec(const std::string& text) {
  for (const std::string kind : {"tum", "euroc", "video", "images"}) {
    if (text.rfind(kind + ":", 0) == 0) return {kind, text.substr(kind.size() + 1)};
  }
  return {"", text};
}

bool hasImages(const fs::path& folder) {
  std::error_code ignored;
  const fs::directory_iterator entries(folder, ignored);
  return std::any_of(begin(entries), end(entries), [](const fs::directory_entry& entry) {
    return isImageFile(entry.path());
  });
}

/// Kind of an existing path, or empty.
std::string recognise(const fs::path& path) {
  if (!fs::is_directory(path)) return isVideoFile(path) ? "video" : "";
  if (fs::exists(path / "rgb.txt")) return "tum";
  for (const char* list : {"mav0/cam0/data.csv", "cam0/data.csv", "data.csv"}) {
    if (fs::exists(path / list)) return "euroc";
  }
  return hasImages(path) ? "images" : "";
}

Result<OpenedSource> openDataset(Result<Dataset> dataset, const FrameSelection& selection) {
  if (!dataset) return dataset.error();
  OpenedSource opened;
  opened.calibration = dataset->calibration ? dataset->calibration->string() : dataset->preset;
  opened.groundtruth = dataset->groundtruth;
  auto frames = openImageList(std::move(dataset).value(), selection);
  if (!frames) return frames.error();
  opened.frames = std::move(frames).value();
  return opened;
}

Result<OpenedSource> openVideoFile(const fs::path& file,
                                   const FrameSelection& selection,
                                   std::optional<double> fps) {
  auto frames = openVideo(file, selection, fps);
  if (!frames) return frames.error();
  OpenedSource opened;
  opened.frames = std::move(frames).value();
  return opened;
}

}  // namespace

Result<OpenedSource> openSource(const std::string& spec,
                                const FrameSelection& selection,
                                std::optional<double> fps) {
  auto [kind, path] = splitSpec(spec);
  std::error_code ignored;
  if (!fs::exists(path, ignored)) return errorIn(path, "does not exist");
  if (kind.empty()) kind = recognise(path);
  if (kind == "tum") return openDataset(openTum(path), selection);
  if (kind == "euroc") return openDataset(openEuroc(path), selection);
  if (kind == "images") return openDataset(openImageFolder(path, fps), selection);
  if (kind == "video") return openVideoFile(path, selection, fps);
  return errorIn(path,
                 "is not recognised as a sequence: expected a folder with rgb.txt (TUM), "
                 "mav0/cam0/data.csv (EuRoC) or images, or a video file; a prefix tum: euroc: "
                 "video: images: forces the kind");
}

}  // namespace glide::replay
