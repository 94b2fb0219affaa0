#include "replay/readers/dataset.h"

#include "replay/common/text.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <initializer_list>
#include <string_view>

namespace glide::replay {
namespace {

namespace fs = std::filesystem;

constexpr double kDefaultFps = 30.0;
constexpr std::size_t kMinNsDigits = 16;  // ns since 1970 have 19, seconds 10, indices fewer

/// How a list of images is written.
struct ListFormat {
  std::string_view separators;
  fs::path image_folder;
  std::optional<std::int64_t> (*parse_time)(std::string_view);
};

/// Name for the output: the folder's own, also when the path ends in a slash or is ".".
std::string folderName(const fs::path& folder) {
  std::error_code ignored;
  const fs::path full = fs::weakly_canonical(folder, ignored);
  return full.filename().empty() ? "sequence" : full.filename().string();
}

std::optional<fs::path> firstExisting(const fs::path& folder,
                                      std::initializer_list<std::string_view> names) {
  for (const std::string_view name : names) {
    if (fs::exists(folder / name)) return folder / name;
  }
  return std::nullopt;
}

/// Appends an entry; a repeated timestamp is skipped, one that goes back is an error message.
std::optional<std::string> append(Dataset& dataset, ImageEntry entry) {
  ++dataset.listed;
  if (!dataset.images.empty()) {
    const std::int64_t last_ns = dataset.images.back().t_ns;
    if (entry.t_ns < last_ns) {
      return "timestamp " + secondsText(entry.t_ns) + " s lies before " + secondsText(last_ns) +
             " s of the image before";
    }
    if (entry.t_ns == last_ns) {
      dataset.skips.add("images repeat the timestamp of the one before", entry.name);
      return std::nullopt;
    }
  }
  dataset.images.push_back(std::move(entry));
  return std::nullopt;
}

Status readList(const fs::path& list, const ListFormat& format, Dataset& dataset) {
  const Result<std::vector<TextLine>> lines = readDataLines(list);
  if (!lines) return lines.error();
  for (const TextLine& line : *lines) {
    const auto fields = splitFields(line.text, format.separators);
    if (fields.size() < 2) return errorAt(list, line.number, "expected a timestamp and a file");
    const std::optional<std::int64_t> t_ns = format.parse_time(fields[0]);
    if (!t_ns) {
      return errorAt(list, line.number, "'" + std::string(fields[0]) + "' is not a timestamp");
    }
    const std::string name(fields[1]);
    const auto fault = append(dataset, {*t_ns, format.image_folder / name, name});
    if (fault) return errorAt(list, line.number, *fault);
  }
  dataset.list_name = list.filename().string();
  if (dataset.listed == 0) return errorIn(list, "lists no image");
  return Unit{};
}

/// The original sequences are told by their names: rgbd_dataset_freiburg3_..., tum_fr3_...
std::string presetOf(const std::string& name) {
  const auto has = [&](const std::string& part) { return name.find(part) != std::string::npos; };
  for (const std::string digit : {"1", "2", "3"}) {
    if (has("freiburg" + digit + "_") || has("fr" + digit + "_")) return "freiburg" + digit;
  }
  return {};
}

void findCompanions(const fs::path& folder, Dataset& dataset) {
  if (!dataset.calibration) {
    dataset.calibration =
        firstExisting(folder, {"calibration.yaml", "camera.yaml", "camchain.yaml", "sensor.yaml"});
  }
  if (!dataset.groundtruth) {
    dataset.groundtruth = firstExisting(folder, {"groundtruth.txt", "groundtruth.csv"});
  }
}

enum class NameTime { none, seconds, nanoseconds };

NameTime timeInNames(const std::vector<fs::path>& files) {
  const auto all = [&](auto&& isTime) { return std::all_of(files.begin(), files.end(), isTime); };
  const bool are_ns = all([](const fs::path& file) {
    const std::string stem = file.stem().string();
    return stem.size() >= kMinNsDigits && parseInteger(stem).has_value();
  });
  if (are_ns) return NameTime::nanoseconds;
  const bool are_seconds = all([](const fs::path& file) {
    const std::string stem = file.stem().string();
    return stem.find('.') != std::string::npos && parseSeconds(stem).has_value();
  });
  return are_seconds ? NameTime::seconds : NameTime::none;
}

std::vector<fs::path> imageFiles(const fs::path& folder) {
  std::vector<fs::path> files;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    if (isImageFile(entry.path())) files.push_back(entry.path());
  }
  std::sort(files.begin(), files.end(), [](const fs::path& a, const fs::path& b) {
    return naturalLess(a.filename().string(), b.filename().string());
  });
  return files;
}

}  // namespace

bool isImageFile(const fs::path& file) {
  constexpr std::array<std::string_view, 9> kExtensions = {
      ".png", ".jpg", ".jpeg", ".bmp", ".pgm", ".ppm", ".tif", ".tiff", ".webp"};
  std::string extension = file.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return std::find(kExtensions.begin(), kExtensions.end(), extension) != kExtensions.end();
}

bool naturalLess(const std::string& a, const std::string& b) {
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  std::size_t i = 0, j = 0;
  while (i < a.size() && j < b.size()) {
    if (!isDigit(a[i]) || !isDigit(b[j])) {
      if (a[i] != b[j]) return a[i] < b[j];
      ++i, ++j;
      continue;
    }
    const auto runAt = [&](const std::string& text, std::size_t& at) {
      while (at < text.size() && text[at] == '0') ++at;
      const std::size_t begin = at;
      while (at < text.size() && isDigit(text[at])) ++at;
      return std::string_view(text).substr(begin, at - begin);
    };
    const std::string_view run_a = runAt(a, i), run_b = runAt(b, j);
    if (run_a.size() != run_b.size()) return run_a.size() < run_b.size();
    if (run_a != run_b) return run_a < run_b;
  }
  if (a.size() - i != b.size() - j) return a.size() - i < b.size() - j;
  return a < b;  // equal but for leading zeros
}

Result<Dataset> openTum(const fs::path& folder) {
  Dataset dataset;
  dataset.kind = "tum";
  dataset.path = folder;
  dataset.name = folderName(folder);
  const Status list = readList(folder / "rgb.txt", {" \t,", folder, parseSeconds}, dataset);
  if (!list) return list.error();
  findCompanions(folder, dataset);
  dataset.preset = presetOf(dataset.name);
  return dataset;
}

Result<Dataset> openEuroc(const fs::path& folder) {
  Dataset dataset;
  dataset.kind = "euroc";
  dataset.path = folder;
  dataset.name = folderName(folder);
  fs::path camera = folder;
  for (const char* candidate : {"mav0/cam0", "cam0"}) {
    if (fs::exists(folder / candidate)) camera = folder / candidate;
    if (camera != folder) break;
  }
  const Status list =
      readList(camera / "data.csv", {", \t", camera / "data", parseInteger}, dataset);
  if (!list) return list.error();
  dataset.calibration = firstExisting(camera, {"sensor.yaml"});
  dataset.groundtruth =
      firstExisting(camera, {"../state_groundtruth_estimate0/data.csv", "../groundtruth.txt"});
  findCompanions(folder, dataset);
  return dataset;
}

Result<Dataset> openImageFolder(const fs::path& folder, std::optional<double> fps) {
  Dataset dataset;
  dataset.kind = "images";
  dataset.path = folder;
  dataset.name = folderName(folder);
  dataset.list_name = "the folder";
  const std::vector<fs::path> files = imageFiles(folder);
  if (files.empty()) return errorIn(folder, "has no images");
  const NameTime name_time = fps ? NameTime::none : timeInNames(files);
  for (std::size_t i = 0; i < files.size(); ++i) {
    const std::string stem = files[i].stem().string();
    std::int64_t t_ns =
        static_cast<std::int64_t>(static_cast<double>(i) * 1e9 / fps.value_or(kDefaultFps));
    if (name_time == NameTime::nanoseconds) t_ns = parseInteger(stem).value_or(t_ns);
    if (name_time == NameTime::seconds) t_ns = parseSeconds(stem).value_or(t_ns);
    const std::string name = files[i].filename().string();
    const auto fault = append(dataset, {t_ns, files[i], name});
    if (fault) return errorIn(files[i], *fault);
  }
  findCompanions(folder, dataset);
  return dataset;
}

}  // namespace glide::replay
