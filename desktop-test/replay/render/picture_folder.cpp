#include "replay/render/picture_folder.h"

#include "replay/common/text.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kDigits = 6;
constexpr int kMostPictures = 100'000'000;  // a year of video

constexpr const char* kMarker = ".glide-pictures";  // holds how many of them are ours

std::string nameOf(int number) { return fmt::format("{:06}.png", number); }

bool isNumbered(const fs::path& file) {
  const std::string stem = file.stem().string();
  return file.extension() == ".png" && stem.size() >= kDigits &&
         stem.find_first_not_of("0123456789") == std::string::npos;
}

/// How many pictures of an earlier run lie there, by its own word.
int countEarlier(const fs::path& folder) {
  const Result<std::string> marker = readFile(folder / kMarker);
  if (!marker) return 0;
  const std::vector<std::string_view> fields = splitFields(*marker, " \n");
  const std::optional<std::int64_t> count =
      fields.size() == 1 ? parseInteger(fields.front()) : std::nullopt;
  return count && *count > 0 && *count <= kMostPictures ? static_cast<int>(*count) : 0;
}

/// A numbered picture that no earlier run has written.
std::optional<fs::path> findForeign(const fs::path& folder, int earlier, std::error_code& fault) {
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    const fs::path file = entry->path();
    if (!isNumbered(file)) continue;
    const std::optional<std::int64_t> number = parseInteger(file.stem().string());
    const bool is_ours =
        number && *number < earlier && file.filename() == nameOf(static_cast<int>(*number));
    if (!is_ours) return file;
  }
  return std::nullopt;
}

std::error_code removeEarlier(const fs::path& folder, int earlier) {
  std::error_code fault;
  for (int i = 0; i < earlier && !fault; ++i) fs::remove(folder / nameOf(i), fault);
  return fault;
}

/// Whole or not at all.
Status replaceFile(const fs::path& file, std::string_view bytes) {
  const fs::path beside = fs::path(file) += ".part";
  const Status written = writeFile(beside, bytes);
  if (!written) return written;
  std::error_code fault;
  fs::rename(beside, file, fault);
  if (fault) return errorIn(file, "cannot be written: " + fault.message());
  return Unit{};
}

}  // namespace

Result<std::unique_ptr<FrameSink>> PictureFolder::open(const fs::path& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) return errorIn(folder, "cannot be made: " + fault.message());
  const int earlier = countEarlier(folder);
  const std::optional<fs::path> foreign = findForeign(folder, earlier, fault);
  if (foreign) return errorIn(*foreign, "is of no earlier --render: give it another folder");
  if (!fault) fault = removeEarlier(folder, earlier);
  if (fault) return errorIn(folder, "cannot be cleared of earlier pictures: " + fault.message());
  return std::unique_ptr<FrameSink>(new PictureFolder(folder));
}

Status PictureFolder::write(const RgbPicture& picture, std::int64_t) {
  const cv::Mat rgb(
      picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  const fs::path file = folder_ / nameOf(next_++);
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(".png", bgr, bytes)) return errorIn(file, "cannot be encoded");
  const Status marked = replaceFile(folder_ / kMarker, fmt::format("{}\n", next_));
  if (!marked) return marked;
  return replaceFile(file,
                     std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
}

}  // namespace glide::replay
