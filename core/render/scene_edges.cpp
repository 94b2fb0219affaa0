#include "render/scene_edges.h"

#include "render/scene_path.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <iterator>
#include <span>

namespace glide {
namespace {

/// Of lines that are there to be overlooked.
constexpr Color kCovisibilityColor{0.5F, 0.5F, 0.5F, 0.45F};

PointRecord endAt(const MapView::Keyframe& keyframe, const Color& color) {
  const auto& t = keyframe.T_world_cam.t_xyz;
  return {{static_cast<float>(t[0]), static_cast<float>(t[1]), static_cast<float>(t[2])},
          packColor(color)};
}

std::span<const std::uint64_t> bestNeighbors(const MapView::Keyframe& keyframe, int neighbors) {
  const auto wanted = static_cast<std::size_t>(std::max(neighbors, 0));
  return std::span(keyframe.covisible).first(std::min(wanted, keyframe.covisible.size()));
}

/// Whether the line from `keyframe` to `neighbor` is its neighbor's to draw: both have it, and the
/// older draws.
bool isDrawnByOther(const MapView::Keyframe& keyframe,
                    const MapView::Keyframe& neighbor,
                    int neighbors) {
  if (keyframe.id < neighbor.id) return false;
  const std::span<const std::uint64_t> back = bestNeighbors(neighbor, neighbors);
  return std::find(back.begin(), back.end(), keyframe.id) != back.end();
}

}  // namespace

std::vector<PointRecord> covisibilityEdges(const MapView& map, int neighbors) {
  std::vector<PointRecord> records;
  for (const MapView::Keyframe& keyframe : map.keyframes) {
    for (const std::uint64_t id : bestNeighbors(keyframe, neighbors)) {
      const MapView::Keyframe* neighbor = map.keyframe(id);
      if (neighbor == nullptr || isDrawnByOther(keyframe, *neighbor, neighbors)) continue;
      records.push_back(endAt(keyframe, kCovisibilityColor));
      records.push_back(endAt(*neighbor, kCovisibilityColor));
    }
  }
  return records;
}

std::vector<PointRecord> loopEdges(const MapView& map) {
  std::vector<PointRecord> records;
  for (const MapView::Loop& loop : map.loops) {
    const MapView::Keyframe* newer = map.keyframe(loop.newer);
    const MapView::Keyframe* older = map.keyframe(loop.older);
    if (newer == nullptr || older == nullptr) continue;
    records.push_back(endAt(*newer, kLoopColor));
    records.push_back(endAt(*older, kLoopColor));
  }
  return records;
}

}  // namespace glide
