#pragma once

#include "replay/outputs/point_colors.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace glide::replay {

using Point3f = std::array<float, 3>;

/// What the vertices of a primitive are drawn as; the numbers are glTF's.
enum class GlbMode { points = 0, lines = 1, line_strip = 3 };

/// A file in binary glTF 2.0 in the making: one scene of named meshes of coloured points and lines,
/// which lights do not shade (KHR_materials_unlit).
class GlbWriter {
 public:
  /// Vertices with one colour each; at least one of them. With indices, these are what is drawn.
  struct Primitive {
    GlbMode mode = GlbMode::points;
    std::vector<Point3f> positions;
    std::vector<Rgb8> colors;
    std::vector<std::uint32_t> indices;
  };

  /// A node with a mesh of these primitives; nothing when there are none.
  void addMesh(const std::string& name, std::span<const Primitive> primitives);

  /// The file. `root` is the node above all meshes: name, transformation, extras.
  std::string finish(nlohmann::ordered_json root) const;

 private:
  using Json = nlohmann::ordered_json;

  Json toJson(const Primitive& primitive);
  int addPositions(std::span<const Point3f> positions);
  int addColors(std::span<const Rgb8> colors);
  int addIndices(std::span<const std::uint32_t> indices);
  /// Appends what lies in memory, which is little-endian wherever this is built.
  int addAccessor(std::span<const std::uint8_t> bytes, int target, Json accessor);

  Json meshes_ = Json::array(), accessors_ = Json::array(), views_ = Json::array();
  std::string buffer_;
};

}  // namespace glide::replay
