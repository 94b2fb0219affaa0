#include "replay/outputs/map_ply.h"

#include <cstdint>
#include <cstring>

namespace glide::replay {
namespace {

void append(std::uint32_t number, std::string* text) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    text->push_back(static_cast<char>((number >> shift) & 0xFFU));
  }
}

std::uint32_t bitsOf(double value) {
  const float number = static_cast<float>(value);
  std::uint32_t bits = 0;
  std::memcpy(&bits, &number, sizeof(bits));
  return bits;
}

}  // namespace

std::string mapPly(const MapView& map, const PointColors& colors) {
  std::string text =
      "ply\n"
      "format binary_little_endian 1.0\n"
      "comment landmarks of a GLidE-SLAM map, revision " +
      std::to_string(map.revision) +
      "; the unit is arbitrary\n"
      "element vertex " +
      std::to_string(map.landmarks.size()) +
      "\n"
      "property float x\n"
      "property float y\n"
      "property float z\n"
      "property uchar red\n"
      "property uchar green\n"
      "property uchar blue\n"
      "property int observations\n"
      "end_header\n";
  for (const MapView::Landmark& landmark : map.landmarks) {
    for (const double coordinate : landmark.p_world) append(bitsOf(coordinate), &text);
    const Rgb8 color = colors.of(landmark.id);
    for (const std::uint8_t share : {color.red, color.green, color.blue})
      text.push_back(static_cast<char>(share));
    append(static_cast<std::uint32_t>(landmark.observations), &text);
  }
  return text;
}

}  // namespace glide::replay
