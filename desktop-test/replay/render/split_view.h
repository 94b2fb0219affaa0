#pragma once

#include "replay/evaluation/trajectory.h"
#include "replay/outputs/frame_observer.h"
#include "replay/render/ar_scene.h"
#include "replay/render/follow_camera.h"
#include "replay/render/split_layout.h"
#include "replay/render/timeline.h"
#include "replay/render/truth_overlay.h"
#include "replay/render/view_control.h"

#include "glide/camera_renderer.h"
#include "glide/map_renderer.h"
#include "glide/result.h"

#include <memory>
#include <optional>
#include <vector>

namespace glide::replay {

/// What lies behind everything: light, so that orange and dark blue both stand out.
inline constexpr Color kPaperColor{0.965F, 0.965F, 0.955F, 1.0F};

/// What a split view has to know before the first frame.
struct SplitViewSetup {
  CameraIntrinsics camera;
  int frames = 0;    ///< that will come; 0 when unknown
  Trajectory truth;  ///< of the camera, metres; empty: none
  RenderView view = RenderView::split;
};

/// What a frame shows.
struct ShownFrame {
  const FrameRecord& record;
  const SourceFrame& frame;
  std::shared_ptr<const MapView> map;  ///< never null
  std::vector<TrackedPoint> points;
};

/// A replay as one picture: the camera's view with the tracked points, the map from above, the map
/// in 3-D from a camera that flies along, and a strip of who tracked what; or
/// one part of it alone (RenderView). Lives on the thread of
/// an OpenGL ES 3.1 context, which is current in all calls.
class SplitView {
 public:
  /// unsupported when the context cannot.
  static Result<SplitView> create(const SplitViewSetup& setup);

  /// Takes over what a frame changed.
  void show(const FrameMoment& moment);
  void show(ShownFrame shown);
  /// Draws the present state into the framebuffer that is bound, from its lower left corner.
  Status draw(const PictureSize& size, const ViewControl& control);
  /// What draw() shows the scene from; nothing while there is no map to fly around.
  std::optional<Orbit> shownFrom(const ViewControl& control) const;

 private:
  struct Renderers {
    MapRenderer map;
    CameraRenderer picture, strip;
  };

  SplitView(const SplitViewSetup& setup, ArScene ar, Renderers renderers);
  std::shared_ptr<const MapView> mapOf(const FrameMoment& moment) const;
  void showMap(std::shared_ptr<const MapView> map);
  void useCamera(const CameraIntrinsics& camera);
  void keepPicture(const SourceFrame& frame);
  Status drawMap(const SplitLayout& layout, const ViewControl& control);
  Status drawPicture(const Viewport& viewport);
  Status drawOverPicture(const Viewport& viewport);
  Status drawTimeline(const Viewport& viewport);

  Renderers renderers_;
  RenderView view_;
  CameraIntrinsics camera_;  ///< as it was given
  Timeline timeline_;
  TruthOverlay truth_;
  FollowCamera flight_;
  ArScene ar_;
  Pose T_world_cam_;  ///< of the last frame
  bool is_tracked_ = false;
  std::shared_ptr<const MapView> map_;
  RgbPicture color_;  ///< of the last frame; empty when the source has no colour
  ImageU8 gray_;
  std::vector<TrackedPoint> points_;
  TrackerKind tracker_ = TrackerKind::none;
  int shown_frames_ = 0;
};

}  // namespace glide::replay
