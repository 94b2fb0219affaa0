#pragma once

#include "map/map_snapshot.h"

#include "glide/frame_map.h"

#include <cstdint>
#include <memory>
#include <mutex>

namespace glide {

/// A FrameMap that copies a snapshot when it is looked at.
class SnapshotMap final : public FrameMap {
 public:
  /// `resets` and `generation` as in MapView; the snapshot is not null.
  SnapshotMap(std::shared_ptr<const MapSnapshot> snapshot,
              std::uint64_t generation,
              std::uint64_t resets);

  const MapSnapshot& snapshot() const { return *snapshot_; }
  std::uint64_t generation() const override { return generation_; }
  std::uint64_t revision() const override { return snapshot_->revision(); }
  std::shared_ptr<const MapView> view() const override;

 private:
  const std::shared_ptr<const MapSnapshot> snapshot_;
  const std::uint64_t generation_, resets_;
  mutable std::mutex mutex_;  ///< one copies, the others wait for it: it is the same work
  mutable std::shared_ptr<const MapView> view_;
};

}  // namespace glide
