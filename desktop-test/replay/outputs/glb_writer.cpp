#include "replay/outputs/glb_writer.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace glide::replay {
namespace {

// Numbers of the glTF 2.0 specification.
constexpr int kUnsignedShort = 5123, kUnsignedInt = 5125, kFloat = 5126;  // component types
constexpr int kVertexBuffer = 34962, kIndexBuffer = 34963;                // targets of views
constexpr std::uint32_t kMagic = 0x46546C67, kVersion = 2;                // "glTF"
constexpr std::uint32_t kJsonChunk = 0x4E4F534A, kBinaryChunk = 0x004E4942;
constexpr std::size_t kChunkAlignment = 4, kHeaderBytes = 12;

template <class T>
std::span<const std::uint8_t> bytesOf(std::span<const T> values) {
  return {reinterpret_cast<const std::uint8_t*>(values.data()), values.size_bytes()};
}

/// glTF's vertex colours are linear light; sixteen bits keep what eight of sRGB tell apart.
std::uint16_t linear(std::uint8_t srgb) {
  const double c = srgb / 255.0;
  const double light = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  return static_cast<std::uint16_t>(std::lround(65535.0 * light));
}

void append(std::uint32_t number, std::string* text) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    text->push_back(static_cast<char>((number >> shift) & 0xFFU));
  }
}

void appendChunk(std::uint32_t type, std::string data, char padding, std::string* file) {
  data.resize((data.size() + kChunkAlignment - 1) / kChunkAlignment * kChunkAlignment, padding);
  append(static_cast<std::uint32_t>(data.size()), file);
  append(type, file);
  *file += data;
}

}  // namespace

void GlbWriter::addMesh(const std::string& name, std::span<const Primitive> primitives) {
  if (primitives.empty()) return;
  Json mesh{{"name", name}, {"primitives", Json::array()}};
  for (const Primitive& primitive : primitives) mesh["primitives"].push_back(toJson(primitive));
  meshes_.push_back(std::move(mesh));
}

GlbWriter::Json GlbWriter::toJson(const Primitive& primitive) {
  Json json{
      {"attributes",
       {{"POSITION", addPositions(primitive.positions)}, {"COLOR_0", addColors(primitive.colors)}}},
      {"material", 0},
      {"mode", static_cast<int>(primitive.mode)}};
  if (!primitive.indices.empty()) json["indices"] = addIndices(primitive.indices);
  return json;
}

int GlbWriter::addPositions(std::span<const Point3f> positions) {
  Point3f low = positions.front();
  Point3f high = low;
  for (const Point3f& position : positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      low[k] = std::min(low[k], position[k]);
      high[k] = std::max(high[k], position[k]);
    }
  }
  return addAccessor(bytesOf(positions),
                     kVertexBuffer,
                     {{"componentType", kFloat},
                      {"count", positions.size()},
                      {"type", "VEC3"},
                      {"min", low},
                      {"max", high}});
}

int GlbWriter::addColors(std::span<const Rgb8> colors) {
  constexpr std::uint16_t kOpaque = 65535;
  std::vector<std::array<std::uint16_t, 4>> rgba;
  rgba.reserve(colors.size());
  for (const Rgb8& color : colors)
    rgba.push_back({linear(color.red), linear(color.green), linear(color.blue), kOpaque});
  return addAccessor(bytesOf(std::span<const std::array<std::uint16_t, 4>>(rgba)),
                     kVertexBuffer,
                     {{"componentType", kUnsignedShort},
                      {"normalized", true},
                      {"count", rgba.size()},
                      {"type", "VEC4"}});
}

int GlbWriter::addIndices(std::span<const std::uint32_t> indices) {
  return addAccessor(
      bytesOf(indices),
      kIndexBuffer,
      {{"componentType", kUnsignedInt}, {"count", indices.size()}, {"type", "SCALAR"}});
}

int GlbWriter::addAccessor(std::span<const std::uint8_t> bytes, int target, Json accessor) {
  views_.push_back({{"buffer", 0},
                    {"byteOffset", buffer_.size()},
                    {"byteLength", bytes.size()},
                    {"target", target}});
  buffer_.append(bytes.begin(), bytes.end());
  accessor["bufferView"] = views_.size() - 1;
  accessors_.push_back(std::move(accessor));
  return static_cast<int>(accessors_.size()) - 1;
}

std::string GlbWriter::finish(Json root) const {
  Json file{{"asset", {{"version", "2.0"}, {"generator", "GLidE-SLAM"}}}, {"scene", 0}};
  file["scenes"] = {{{"nodes", {0}}}};
  Json nodes = Json::array({std::move(root)});
  for (std::size_t i = 0; i < meshes_.size(); ++i) {
    nodes[0]["children"].push_back(i + 1);
    nodes.push_back({{"name", meshes_[i]["name"]}, {"mesh", i}});
  }
  file["nodes"] = std::move(nodes);
  if (!meshes_.empty()) {  // glTF has no empty lists
    file["extensionsUsed"] = {"KHR_materials_unlit"};
    file["materials"] = {{{"extensions", {{"KHR_materials_unlit", Json::object()}}}}};
    file["meshes"] = meshes_;
    file["accessors"] = accessors_;
    file["bufferViews"] = views_;
    file["buffers"] = {{{"byteLength", buffer_.size()}}};
  }
  std::string chunks;
  appendChunk(kJsonChunk, file.dump(), ' ', &chunks);
  if (!meshes_.empty()) appendChunk(kBinaryChunk, buffer_, '\0', &chunks);
  std::string result;
  append(kMagic, &result);
  append(kVersion, &result);
  append(static_cast<std::uint32_t>(kHeaderBytes + chunks.size()), &result);
  return result + chunks;
}

}  // namespace glide::replay
