#include "replay/readers/image_list.h"

#include "replay/common/text.h"
#include "replay/readers/image_decoder.h"

#include <cmath>
#include <string>
#include <utility>

namespace glide::replay {
namespace {

class ImageListSource : public FrameSource {
 public:
  ImageListSource(SourceInfo info, std::vector<ImageEntry> images, SkipList skips)
      : info_(std::move(info)), images_(std::move(images)), skips_(std::move(skips)) {
    first_ = decodeNext();
    if (!first_) return;
    info_.width = first_->image.width();
    info_.height = first_->image.height();
  }

  const SourceInfo& info() const override { return info_; }
  const SkipList& skips() const override { return skips_; }

  std::optional<SourceFrame> next() override {
    if (first_) return std::exchange(first_, std::nullopt);
    return decodeNext();
  }

 private:
  std::optional<SourceFrame> decodeNext() {
    while (next_ < images_.size()) {
      const ImageEntry& entry = images_[next_++];
      Result<DecodedImage> image = decodeImage(entry.file);
      if (!image) {
        skips_.add("images " + image.error().message, entry.name);
      } else if (info_.width != 0 &&
                 (image->gray.width() != info_.width || image->gray.height() != info_.height)) {
        skips_.add("images have another size than the first one", entry.name);
      } else {
        return SourceFrame{entry.t_ns, entry.name, std::move(image->gray), std::move(image->color)};
      }
    }
    return std::nullopt;
  }

  SourceInfo info_;
  std::vector<ImageEntry> images_;
  SkipList skips_;
  std::size_t next_ = 0;
  std::optional<SourceFrame> first_;  ///< decoded early: its size is the sequence's
};

std::string allSkips(const SkipList& skips, int listed) {
  std::string text;
  for (const Skip& skip : skips.skips()) text += "; " + describe(skip, listed);
  return text;
}

}  // namespace

std::vector<ImageEntry> selectEntries(const std::vector<ImageEntry>& images,
                                      const FrameSelection& selection) {
  std::vector<ImageEntry> selected;
  int index = 0;
  for (const ImageEntry& entry : images) {
    const double t_s = static_cast<double>(entry.t_ns - images.front().t_ns) * 1e-9;
    if (t_s < selection.start_s) continue;
    if (selection.duration_s && t_s >= selection.start_s + *selection.duration_s) break;
    if (selection.max_frames && static_cast<int>(selected.size()) >= *selection.max_frames) break;
    if (index++ % selection.stride == 0) selected.push_back(entry);
  }
  return selected;
}

Result<std::unique_ptr<FrameSource>> openImageList(Dataset dataset,
                                                   const FrameSelection& selection) {
  std::vector<ImageEntry> existing;
  for (ImageEntry& entry : dataset.images) {
    std::error_code ignored;
    if (std::filesystem::exists(entry.file, ignored)) {
      existing.push_back(std::move(entry));
    } else {
      dataset.skips.add("images listed in " + dataset.list_name + " are missing", entry.name);
    }
  }
  const std::vector<ImageEntry> selected = selectEntries(existing, selection);
  SourceInfo info{dataset.kind, dataset.path, dataset.name, 0, dataset.listed, 0, 0};
  info.frames = static_cast<int>(selected.size());
  auto source = std::make_unique<ImageListSource>(info, selected, dataset.skips);
  if (source->info().width == 0) {
    const bool is_selection = selected.empty() && !existing.empty();
    return errorIn(dataset.path,
                   (is_selection ? "no frame lies in the part asked for (--start, --duration)"
                                 : "no readable image") +
                       allSkips(source->skips(), dataset.listed));
  }
  return std::unique_ptr<FrameSource>(std::move(source));
}

}  // namespace glide::replay
