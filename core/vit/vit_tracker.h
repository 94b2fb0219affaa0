#pragma once

#include "vit/vit_frame.h"
#include "vit/vit_pose.h"
#include "vit/vit_pose_queue.h"
#include "vit/vit_velocity.h"

#include "base/work_queue.h"
#include "base/worker.h"

#include "glide/session.h"

#include <cstddef>
#include <cstdint>
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
  bool isRunning() const { return sequence() != nullptr; }

  vit_result addCamera(const vit_camera_calibration& calibration);
  vit_result pushImage(const vit_img_sample& sample);
  vit_result pushImu(const vit_imu_sample& sample);
  /// Null when there is none.
  std::unique_ptr<vit_pose> popPose();

  vit_result enable(vit_extension extension, bool enable);
  vit_extension_set enabled() const;

 private:
  using FrameQueue = glide::WorkQueue<glide::VitFrame>;

  // Images that wait: more would only be older when their turn comes.
  static constexpr std::size_t kWaitingImages = 3;

  /// What comes in from start() to stop(): times start over with the next one.
  struct Sequence {
    int width = 0, height = 0;  ///< px, of its images
    FrameQueue frames{kWaitingImages};
    std::int64_t last_image_ns = INT64_MIN;  ///< of the thread that pushes images
    std::int64_t last_imu_ns = INT64_MIN;    ///< of the thread that pushes IMU samples
  };

  vit_tracker() = default;
  /// Null unless the tracker runs.
  std::shared_ptr<Sequence> sequence() const;
  void run(FrameQueue* frames);
  /// Null when the frame has no pose.
  std::unique_ptr<vit_pose> track(const glide::VitFrame& frame, glide::Session* session);
  std::unique_ptr<vit_pose> toVitPose(const glide::VitFrame& frame,
                                      const glide::FrameResult& result,
                                      const glide::Session& session);

  // Before start(), and constant while it runs.
  glide::Config config_;
  std::optional<glide::VitCamera> camera_;
  vit_extension_set enabled_{true, true, false, false};

  // The runtime's thread that starts and stops.
  std::unique_ptr<glide::Worker> worker_;

  // Between the threads.
  mutable std::mutex mutex_;  ///< guards sequence_
  std::shared_ptr<Sequence> sequence_;
  glide::VitPoseQueue poses_;

  // The tracking thread.
  glide::VitVelocity velocity_;
};
