#include "replay/render/picture_folder.h"

#include "replay/common/text.h"

#include <fmt/format.h>
#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <string>
#include <string_view>
#include <system_error>
#include <vector>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;
constexpr std::size_t kDigits = 6;

bool isOurs(const fs::path& file) {
  const std::string stem = file.stem().string();
  return file.extension() == ".png" && stem.size() >= kDigits &&
         stem.find_first_not_of("0123456789") == std::string::npos;
}

std::error_code removeEarlier(const fs::path& folder) {
  std::error_code fault;
  std::vector<fs::path> earlier;
  for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end;
       entry.increment(fault)) {
    if (isOurs(entry->path())) earlier.push_back(entry->path());
  }
  for (const fs::path& file : earlier) {
    if (!fault) fs::remove(file, fault);
  }
  return fault;
}

}  // namespace

Result<std::unique_ptr<FrameSink>> PictureFolder::open(const fs::path& folder) {
  std::error_code fault;
  fs::create_directories(folder, fault);
  if (fault) return errorIn(folder, "cannot be made: " + fault.message());
  fault = removeEarlier(folder);
  if (fault) return errorIn(folder, "cannot be cleared of earlier pictures: " + fault.message());
  return std::unique_ptr<FrameSink>(new PictureFolder(folder));
}

Status PictureFolder::write(const RgbPicture& picture, std::int64_t) {
  const cv::Mat rgb(
      picture.height, picture.width, CV_8UC3, const_cast<std::uint8_t*>(picture.rgb.data()));
  cv::Mat bgr;
  cv::cvtColor(rgb, bgr, cv::COLOR_RGB2BGR);
  const fs::path file = folder_ / fmt::format("{:06}.png", next_++);
  std::vector<std::uint8_t> bytes;
  if (!cv::imencode(".png", bgr, bytes)) return errorIn(file, "cannot be encoded");
  const fs::path beside = fs::path(file) += ".part";
  const Status written = writeFile(
      beside, std::string_view(reinterpret_cast<const char*>(bytes.data()), bytes.size()));
  if (!written) return written;
  std::error_code fault;
  fs::rename(beside, file, fault);
  if (fault) return errorIn(file, "cannot be written: " + fault.message());
  return Unit{};
}

}  // namespace glide::replay
