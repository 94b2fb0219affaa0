#pragma once

#include "synthetic/kidnap.h"
#include "synthetic/renderer.h"
#include "synthetic/scene.h"
#include "synthetic/sensor.h"
#include "synthetic/trajectory.h"

#include "geometry/lie.h"
#include "image/image.h"

#include "glide/result.h"
#include "glide/types.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace glide::synthetic {

/// Everything that defines a synthetic sequence.
struct SequenceOptions {
  SceneKind scene = SceneKind::room;
  CameraIntrinsics camera;
  Motion motion;
  Sensor sensor;
  Kidnap kidnap;
  int frames = 300;  ///< 0 = as many as the walk takes (MotionKind::walk only)
  double fps = 30.0;
  std::uint64_t seed = 1;
};

/// A pinhole camera of 63 degrees field of view, a radial-tangential one of 79 and a Kannala-Brandt
/// one of 150, with the principal point a little off the centre.
CameraIntrinsics makeCamera(DistortionModel model, int width, int height);

/// Images and exact poses of a synthetic camera, one frame at a time. One thread per instance; the
/// scene may be shared by several.
class Sequence {
 public:
  /// invalid_argument when the camera or an option is out of range; the message names it.
  static Result<Sequence> create(const SequenceOptions& options);
  /// The same with a scene that exists already: making one takes about a second.
  static Result<Sequence> create(const SequenceOptions& options,
                                 std::shared_ptr<const Scene> scene);

  int size() const { return options_.frames; }
  const CameraModel& camera() const { return camera_; }
  const SequenceOptions& options() const { return options_; }
  const std::shared_ptr<const Scene>& scene() const { return scene_; }

  /// Middle of the exposure of the middle row, nanoseconds.
  std::int64_t timestamp(int frame) const;
  /// True pose at that instant; where the camera was last seen while it is carried away.
  SE3d T_world_cam(int frame) const;
  /// Whether the camera is carried away and sees nothing of the scene.
  bool isKidnapped(int frame) const;

  /// What the camera delivers, gray.
  void image(int frame, ImageU8* out);
  /// What a camera delivers in a scene that has colours (scene()->has_color): red, green, blue side
  /// by side, three bytes a pixel.
  void colorImage(int frame, ImageU8* out);
  /// The perfect view at timestamp(frame), without blur, exposure and noise.
  const Rendering& rendering(int frame);

 private:
  Sequence(const SequenceOptions& options,
           const CameraModel& camera,
           std::shared_ptr<const Scene> scene);
  double seconds(int frame) const { return frame / options_.fps; }
  /// Pose `offset_s` seconds after the middle of a frame's exposure.
  SE3d poseNear(int frame, double offset_s) const;
  void render(int frame, double offset_s);
  /// Averages what falls onto the sensor during a frame's exposure into exposed_.
  void expose(int frame);
  Exposure exposureOf(int frame) const;
  std::uint64_t noiseSeed(int frame) const;

  SequenceOptions options_;
  CameraModel camera_;
  std::shared_ptr<const Scene> scene_;
  Renderer renderer_;
  Rendering rendering_;
  ImageF exposed_;  ///< radiance averaged over the exposure
  ImageRgb exposed_color_;
  ImageU8 gray_;  ///< of elsewhere
  Return return_;
  std::unique_ptr<Sequence> elsewhere_;  ///< what is seen while being carried away; null = black
  std::vector<SE3d> row_poses_;
};

}  // namespace glide::synthetic
