#pragma once

#include "vit/vit_pose.h"

#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>

namespace glide {

/// The poses on their way from the tracking thread to the runtime's, oldest first. A frame may be
/// in tracking while the runtime resets: its pose, of the map that goes, is told by its era. Any
/// thread.
class VitPoseQueue {
 public:
  /// How often the queue was cleared: to be asked before a frame is tracked.
  std::uint64_t era() const;
  /// Takes the pose of a frame whose tracking began in `era`, and drops it when the queue has been
  /// cleared since. A full queue loses its oldest.
  void push(std::unique_ptr<vit_pose> pose, std::uint64_t era);
  /// Null when there is none.
  std::unique_ptr<vit_pose> pop();
  /// Drops all poses, and those of the frames that are in tracking: a new era.
  void clear();

 private:
  mutable std::mutex mutex_;  ///< guards what follows
  std::uint64_t era_ = 0;
  std::deque<std::unique_ptr<vit_pose>> poses_;
};

}  // namespace glide
