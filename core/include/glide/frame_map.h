#pragma once

#include "glide/map_view.h"
#include "glide/version.h"

#include <cstdint>
#include <memory>
#include <mutex>

namespace glide {

class MapSnapshot;  // of the library

/// The map that a frame was tracked in: the one that the poses of its FrameResult are of, whatever
/// the mapper has corrected since. Immutable, and hardly larger than a pointer until it is viewed.
/// Any thread.
class GLIDE_API FrameMap {
 public:
  /// `resets` and `generation` as in MapView.
  FrameMap(std::shared_ptr<const MapSnapshot> snapshot,
           std::uint64_t generation,
           std::uint64_t resets);

  std::uint64_t generation() const { return generation_; }
  std::uint64_t revision() const;
  /// A copy, never null: made when it is asked for first, shared by all who ask.
  std::shared_ptr<const MapView> view() const;

  const MapSnapshot& snapshot() const { return *snapshot_; }  ///< of the library

 private:
  const std::shared_ptr<const MapSnapshot> snapshot_;
  const std::uint64_t generation_, resets_;
  mutable std::mutex mutex_;  ///< of who makes the view
  mutable std::shared_ptr<const MapView> view_;
};

}  // namespace glide
