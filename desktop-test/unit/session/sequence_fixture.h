#pragma once

#include "support/textured_scene.h"

#include "glide/session.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

namespace glide::test {

/// A short rendered walk along a textured wall: 320x240, pinhole, 30 frames a second.
class SequenceFixture {
 public:
  SequenceFixture();

  /// Camera that has moved `x` metres to the right along a wavy line and turned a little.
  static SE3d poseAt(double x);
  /// The image at poseAt(x).
  ImageU8 imageAt(double x) const;
  /// What is seen at pixel `uv` from poseAt(x), and where a point of the world is seen from there.
  std::optional<Vec3d> pointAt(double x, const Vec2d& uv) const;
  std::optional<Vec2d> pixelOf(double x, const Vec3d& p_world) const;
  /// A frame without any structure.
  ImageU8 blank() const;

  Config config() const { return config_; }

  /// Feeds one image as the next frame.
  FrameResult feed(Session* session, const ImageU8& image);

 private:
  TexturedScene scene_;
  CameraModel camera_;
  Config config_;
  std::int64_t t_ns_ = 0;
};

/// Mapping is inline: deterministic.
Session makeSession(const Config& config);

}  // namespace glide::test
