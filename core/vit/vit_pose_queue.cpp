#include "vit/vit_pose_queue.h"

#include <cstddef>
#include <utility>

namespace glide {
namespace {

// A runtime that does not pop poses gets the newest ones.
constexpr std::size_t kMostPoses = 256;

}  // namespace

std::uint64_t VitPoseQueue::era() const {
  const std::lock_guard<std::mutex> lock(mutex_);
  return era_;
}

void VitPoseQueue::push(std::unique_ptr<vit_pose> pose, std::uint64_t era) {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (era != era_) return;
  if (poses_.size() >= kMostPoses) poses_.pop_front();
  poses_.push_back(std::move(pose));
}

std::unique_ptr<vit_pose> VitPoseQueue::pop() {
  const std::lock_guard<std::mutex> lock(mutex_);
  if (poses_.empty()) return nullptr;
  std::unique_ptr<vit_pose> pose = std::move(poses_.front());
  poses_.pop_front();
  return pose;
}

void VitPoseQueue::clear() {
  const std::lock_guard<std::mutex> lock(mutex_);
  ++era_;
  poses_.clear();
}

}  // namespace glide
