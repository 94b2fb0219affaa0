#pragma once

#include "vit/vit_frame.h"
#include "vit/vit_pose.h"

#include "base/work_queue.h"
#include "base/worker.h"

#include "glide/session.h"

#include <atomic>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <optional>

/// The tracker that a runtime drives: images in on one thread, poses out on another, tracking on a
/// thread of its own with the CPU backend (a runtime gives no GL context).
struct vit_tracker {
 public:
  /// Reads the settings of config.file, when there is one.
  static glide::Result<std::unique_ptr<vit_tracker>> create(const vit_config& config);
  ~vit_tracker() { stop(); }

  vit_result start();
  vit_result stop();
  vit_result reset();
  bool isRunning() const { return frames() != nullptr; }

  vit_result addCamera(const vit_camera_calibration& calibration);
  vit_result pushImage(const vit_img_sample& sample);
  vit_result pushImu(const vit_imu_sample& sample);
  /// Null when there is none.
  std::unique_ptr<vit_pose> popPose();

  vit_result enable(vit_extension extension, bool enable);
  vit_extension_set enabled() const;

 private:
  using FrameQueue = glide::WorkQueue<glide::VitFrame>;

  vit_tracker() = default;
  /// Null unless the tracker runs.
  std::shared_ptr<FrameQueue> frames() const;
  void run(FrameQueue* frames);
  void track(const glide::VitFrame& frame, glide::Session* session);
  void publish(const glide::VitFrame& frame,
               const glide::FrameResult& result,
               const glide::Session& session);
  std::vector<vit_pose_feature> features(const glide::FrameResult& result,
                                         const glide::Session& session) const;

  // Before start(), and constant while it runs.
  glide::Config config_;
  std::optional<glide::VitCamera> camera_;
  vit_extension_set enabled_{true, true, false, false};

  // The runtime's threads: one that pushes images, one that pushes IMU samples, one that starts and
  // stops.
  std::int64_t last_image_ns_ = INT64_MIN, last_imu_ns_ = INT64_MIN;
  std::unique_ptr<glide::Worker> worker_;

  // Between the threads.
  std::atomic<bool> reset_asked_{false};
  mutable std::mutex mutex_;  ///< guards the two below
  std::shared_ptr<FrameQueue> frames_;
  std::deque<std::unique_ptr<vit_pose>> poses_;

  // The tracking thread.
  std::optional<vit_pose_data> last_pose_;
};
