#include "map/map_header.h"

#include "map/byte_stream.h"
#include "map/map_records.h"

#include "geometry/camera_model.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <zlib.h>

namespace glide {
namespace {

// "GLiDEmap" read as a little-endian number; its first byte is no text file's, its case tells a
// damaged transfer.
constexpr std::array<std::uint8_t, 8> kMagic{'G', 'L', 'i', 'D', 'E', 'm', 'a', 'p'};
// Counts up with every change of the format; older versions are not read (docs/map-format.md).
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kChecksumOffset = kMagic.size() + sizeof(kVersion);
constexpr std::size_t kChecksumEnd = kChecksumOffset + sizeof(std::uint32_t);
constexpr std::size_t kMaxCoefficients = 5;
// Far above Config's range, and low enough for factor^levels.
constexpr double kMaxLevelFactor = 10.0;

struct SectionRecord {
  std::uint32_t count = 0, record_bytes = 0;
};

struct HeaderRecord {
  std::array<std::uint8_t, 8> magic = kMagic;
  std::uint32_t version = kVersion, checksum = 0;
  std::uint64_t revision = 0;
  std::uint32_t width = 0, height = 0;
  std::array<double, 4> focal_center{};  ///< fx, fy, cx, cy
  std::uint32_t distortion = 0, coefficient_count = 0;
  std::array<double, kMaxCoefficients> coefficients{};
  double level_factor = 0.0;
  std::uint32_t level_count = 0, reserved = 0;
  std::array<SectionRecord, kMapSections> sections{};

  template <class Stream>
  void fields(Stream& stream) {
    stream(std::span<std::uint8_t>(magic));
    stream(version);
    stream(checksum);
    stream(revision);
    stream(width);
    stream(height);
    for (double& value : focal_center) stream(value);
    stream(distortion);
    stream(coefficient_count);
    for (double& value : coefficients) stream(value);
    stream(level_factor);
    stream(level_count);
    stream(reserved);
    for (SectionRecord& section : sections) {
      stream(section.count);
      stream(section.record_bytes);
    }
  }
};

std::array<std::size_t, kMapSections> recordBytes() {
  return {bytesOf<KeyframeRecord>(),
          bytesOf<FeatureRecord>(),
          bytesOf<PatchRecord>(),
          bytesOf<LandmarkRecord>(),
          bytesOf<RetiredRecord>(),
          bytesOf<LoopRecord>()};
}

constexpr std::array<const char*, kMapSections> kSectionNames{
    "keyframes", "features", "patches", "landmarks", "retired keyframes", "loops"};

std::uint32_t checksumOf(std::span<const std::byte> file) {
  const std::span<const std::byte> covered = file.subspan(kChecksumEnd);
  return static_cast<std::uint32_t>(
      crc32_z(0, reinterpret_cast<const Bytef*>(covered.data()), covered.size()));
}

/// Number of coefficients that a lens model may have here; the rest is CameraModel's to check.
MapFault readCamera(const HeaderRecord& record, CameraIntrinsics* camera) {
  const auto side = static_cast<std::uint32_t>(kMaxMapImageSide);
  if (record.width > side || record.height > side) return "header: the image size is implausible";
  if (record.distortion > static_cast<std::uint32_t>(DistortionModel::kannala_brandt4)) {
    return "header: unknown lens model " + std::to_string(record.distortion);
  }
  if (record.coefficient_count > kMaxCoefficients) {
    return "header: " + std::to_string(record.coefficient_count) + " lens coefficients";
  }
  const double* const first = record.coefficients.data();
  const double* const last = first + record.coefficient_count;
  const auto is_zero = [](double value) { return value == 0.0 && !std::signbit(value); };
  if (!std::all_of(last, first + kMaxCoefficients, is_zero)) {
    return "header: lens coefficients beyond their number";
  }
  camera->width = static_cast<int>(record.width);
  camera->height = static_cast<int>(record.height);
  camera->fx = record.focal_center[0];
  camera->fy = record.focal_center[1];
  camera->cx = record.focal_center[2];
  camera->cy = record.focal_center[3];
  camera->distortion = static_cast<DistortionModel>(record.distortion);
  camera->coefficients.assign(first, last);
  const Result<CameraModel> model = CameraModel::create(*camera);
  if (!model) return "header: " + model.error().message;
  return std::nullopt;
}

MapFault readLevels(const HeaderRecord& record, MapHeader* header) {
  if (!(record.level_factor > 1.0 && record.level_factor <= kMaxLevelFactor)) {
    return "header: the scale factor is out of range";
  }
  if (record.level_count < 1 || record.level_count > ScaleLevels::kMaxLevels) {
    return "header: " + std::to_string(record.level_count) + " scale levels";
  }
  header->level_factor = record.level_factor;
  header->level_count = static_cast<int>(record.level_count);
  return std::nullopt;
}

MapFault readSections(const HeaderRecord& record, std::size_t file_bytes, MapHeader* header) {
  const std::array<std::size_t, kMapSections> expected = recordBytes();
  for (std::size_t i = 0; i < kMapSections; ++i) {
    if (record.sections[i].record_bytes != expected[i]) {
      return std::string("header: records of ") + kSectionNames[i] + " have the wrong size";
    }
    header->counts[i] = record.sections[i].count;
  }
  if (header->fileBytes() != file_bytes) {
    return std::string(header->fileBytes() > file_bytes ? "truncated" : "too long") + ": " +
           std::to_string(file_bytes) + " bytes, the header tells of " +
           std::to_string(header->fileBytes());
  }
  return std::nullopt;
}

/// Whether the first bytes, as far as there are any, are a map's.
bool startsLikeMap(std::span<const std::byte> file) {
  const auto shown = static_cast<std::ptrdiff_t>(std::min(file.size(), kMagic.size()));
  return std::equal(
      kMagic.begin(), kMagic.begin() + shown, file.begin(), [](std::uint8_t a, std::byte b) {
        return a == static_cast<std::uint8_t>(b);
      });
}

}  // namespace

std::uint64_t MapHeader::offset(MapSection section) const {
  const std::array<std::size_t, kMapSections> record_bytes = recordBytes();
  std::uint64_t bytes = kMapHeaderBytes;
  for (std::size_t i = 0; i < static_cast<std::size_t>(section); ++i) {
    bytes += record_bytes[i] * counts[i];
  }
  return bytes;
}

std::uint64_t MapHeader::fileBytes() const {
  return offset(MapSection::loops) + count(MapSection::loops) * bytesOf<LoopRecord>();
}

void writeMapHeader(const MapHeader& header, std::vector<std::byte>* bytes) {
  assert(header.camera.coefficients.size() <= kMaxCoefficients);
  HeaderRecord record;
  record.revision = header.revision;
  record.width = static_cast<std::uint32_t>(header.camera.width);
  record.height = static_cast<std::uint32_t>(header.camera.height);
  record.focal_center = {header.camera.fx, header.camera.fy, header.camera.cx, header.camera.cy};
  record.distortion = static_cast<std::uint32_t>(header.camera.distortion);
  record.coefficient_count = static_cast<std::uint32_t>(header.camera.coefficients.size());
  std::copy(header.camera.coefficients.begin(),
            header.camera.coefficients.end(),
            record.coefficients.begin());
  record.level_factor = header.level_factor;
  record.level_count = static_cast<std::uint32_t>(header.level_count);
  const std::array<std::size_t, kMapSections> record_bytes = recordBytes();
  for (std::size_t i = 0; i < kMapSections; ++i) {
    record.sections[i] = {header.counts[i], static_cast<std::uint32_t>(record_bytes[i])};
  }
  ByteWriter writer(bytes);
  record.fields(writer);
}

void sealMapFile(std::span<std::byte> file) {
  if (file.size() < kMapHeaderBytes) return;
  std::vector<std::byte> sum;
  ByteWriter writer(&sum);
  writer(checksumOf(file));
  std::copy(sum.begin(), sum.end(), file.begin() + kChecksumOffset);
}

bool isOtherMapVersion(std::span<const std::byte> file) {
  if (file.size() < kMapHeaderBytes || !startsLikeMap(file)) return false;
  HeaderRecord record;
  ByteReader reader(file);
  record.fields(reader);
  return record.version != kVersion;
}

MapFault readMapHeader(std::span<const std::byte> file, MapHeader* header) {
  assert(bytesOf<HeaderRecord>() == kMapHeaderBytes);
  HeaderRecord record;
  if (file.empty()) return "empty";
  if (!startsLikeMap(file)) return "not a map of GLidE-SLAM (its first bytes are others)";
  if (file.size() < kMapHeaderBytes) {
    return "truncated: " + std::to_string(file.size()) + " bytes, less than a header";
  }
  ByteReader reader(file);
  record.fields(reader);
  if (record.version != kVersion) {
    return "version " + std::to_string(record.version) + " of the format, this program reads " +
           std::to_string(kVersion);
  }
  if (MapFault fault = readSections(record, file.size(), header)) return fault;
  if (record.checksum != checksumOf(file)) return "damaged: the checksum is wrong";
  if (record.reserved != 0) return "header: the reserved field is not zero";
  header->revision = record.revision;
  if (MapFault fault = readLevels(record, header)) return fault;
  return readCamera(record, &header->camera);
}

}  // namespace glide
