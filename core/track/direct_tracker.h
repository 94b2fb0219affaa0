#pragma once

#include "track/tracked_frame.h"

#include "photometric/aligner.h"

#include "glide/config.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace glide {

/// Photometric tracking of tween frames against one reference. Owned by the thread that calls
/// Session::update; with the GL backend that is the GL thread.
class DirectTracker {
 public:
  DirectTracker(const Config::Direct& config, std::unique_ptr<Aligner> aligner);

  /// Aligns the frame to the reference. ok is the switch policy's verdict; the pose of a refused
  /// frame is kept as a guess for the indirect tracker, unless its patch error speaks against it.
  TrackedFrame track(const Frame& frame, const FrameImage& image, const SE3d& T_cam_world_guess);

  /// Makes the frame tracked last the reference, with the landmarks that the indirect tracker
  /// matched in it. Too few of them drop the reference. Returns the milliseconds of the precompute.
  double refreshReference(const Frame& frame, const TrackedFrame& tracked);

  void dropReference() { reference_.reset(); }

  /// What refreshReference made the reference last: its points, and their landmarks one for one.
  std::span<const AlignPoint> referencePoints() const { return points_; }
  std::span<const LandmarkId> referenceLandmarks() const { return landmarks_; }
  /// What aligning the frame tracked last gave; means nothing unless that was ok.
  const AlignResult& alignment() const { return alignment_; }

  /// Whether track() has an aligner that can go on (Aligner::isUsable).
  bool isUsable() const { return aligner_ != nullptr && aligner_->isUsable(); }
  /// Goes on with another aligner; there is no reference until refreshReference.
  void setAligner(std::unique_ptr<Aligner> aligner);
  /// Lets go of the aligner: what it has on the device is freed, or forgotten without a GL call.
  /// Until setAligner, track() must not be called.
  void releaseAligner() { setAligner(nullptr); }
  void abandonAligner();

 private:
  struct Reference {
    AnchoredPose pose;
    double median_depth = 1.0;
    int direct_frames = 0;
    double last_rms = 0.0;  ///< of the last accepted frame
  };

  /// Landmarks of the frame in its own camera frame, at most Config::Direct::max_points.
  void collectPoints(const Frame& frame, const TrackedFrame& tracked);
  TrackedFrame makeTracked(const AlignResult& align, const MapSnapshot& map) const;

  Config::Direct config_;
  std::unique_ptr<Aligner> aligner_;
  std::optional<Reference> reference_;
  double usual_surprise_ = 0.0;   ///< DirectEvidence::usual_surprise
  bool is_frame_loaded_ = false;  ///< the aligner took the frame that was tracked last
  std::vector<AlignPoint> points_;
  std::vector<LandmarkId> landmarks_;  ///< of points_
  AlignResult alignment_;
};

}  // namespace glide
