#pragma once

#include "geometry/lie.h"

#include "glide/map_view.h"

#include <cstdint>
#include <map>
#include <optional>

namespace glide {

/// Poses that keep their place in the scene: each hangs on the keyframe that is nearest when it is
/// made, and follows it when the map is corrected. In the map's world. One owner.
class Anchors {
 public:
  struct State {
    SE3d T_world_anchor;
    bool is_tracked = false;     ///< false once the map that it belongs to is gone
    std::uint64_t revision = 0;  ///< grows when the pose has changed
  };

  /// An id that is never given twice; nothing while the map has no keyframes. follow()s the map.
  std::optional<std::uint64_t> create(const SE3d& T_world_anchor, const MapView& map);
  /// False when there is no such anchor.
  bool destroy(std::uint64_t id) { return anchors_.erase(id) != 0; }
  /// Nothing when there is no such anchor.
  std::optional<State> state(std::uint64_t id) const;

  /// Takes every anchor to where `map` has it; nothing is done for the map that was followed last.
  /// Where an anchor's map is gone it stays where it is, untracked.
  void follow(const MapView& map);

 private:
  struct Anchor {
    std::uint64_t generation = 0;  ///< MapView::generation of its map
    std::uint64_t keyframe = 0;
    SE3d T_key_anchor;
    double key_scale = 1.0;  ///< MapView::Keyframe::scale that T_key_anchor is given in
    State state;
  };

  static void follow(const MapView& map, Anchor* anchor);

  std::map<std::uint64_t, Anchor> anchors_;
  std::uint64_t next_id_ = 1;  // 0 is never an anchor
  std::uint64_t followed_generation_ = 0, followed_revision_ = 0;
};

}  // namespace glide
