#include "track/direct_tracker.h"

#include "track/switch_policy.h"

#include "base/median.h"

#include <algorithm>
#include <utility>

namespace glide {
namespace {

// What is usual is forgotten within a second or so: halved after seven frames.
constexpr double kSurpriseDecay = 0.9;

/// Leaves at most `most` values, evenly spread.
template <class T>
void thin(std::size_t most, std::vector<T>* values) {
  if (values->size() <= most) return;
  for (std::size_t i = 0; i < most; ++i) (*values)[i] = (*values)[i * values->size() / most];
  values->resize(most);
}

double medianDepth(const std::vector<AlignPoint>& points) {
  std::vector<double> depths;
  depths.reserve(points.size());
  for (const AlignPoint& point : points) depths.push_back(point.p_ref.z());
  return median(std::move(depths), 1.0);
}

/// DirectEvidence::surprise.
double distanceBetween(const SE3d& T_cam_ref, const SE3d& T_cam_ref_guess, double depth) {
  const SE3d T_cam_guess = T_cam_ref * T_cam_ref_guess.inverse();
  return T_cam_guess.t.norm() / std::max(depth, 1e-9) + so3Log(T_cam_guess.q).norm();
}

}  // namespace

DirectTracker::DirectTracker(const Config::Direct& config, std::unique_ptr<Aligner> aligner)
    : config_(config), aligner_(std::move(aligner)) {}

void DirectTracker::setAligner(std::unique_ptr<Aligner> aligner) {
  aligner_ = std::move(aligner);
  reference_.reset();
  is_frame_loaded_ = false;
}

void DirectTracker::abandonAligner() {
  if (aligner_) aligner_->abandon();
  setAligner(nullptr);
}

TrackedFrame DirectTracker::track(const Frame& frame,
                                  const FrameImage& image,
                                  const SE3d& T_cam_world_guess) {
  TrackedFrame tracked;
  tracked.T_cam_world = T_cam_world_guess;
  is_frame_loaded_ = aligner_->loadFrame(image).ok();
  if (!is_frame_loaded_) return tracked;
  if (!reference_) {
    tracked.stats.pyramid_ms = aligner_->times().pyramid_ms;
    return tracked;
  }
  const SE3d T_ref_world = reference_->pose.T_cam_world(*frame.map);
  SE3d T_cam_ref_guess = T_cam_world_guess * T_ref_world.inverse();
  T_cam_ref_guess.t /= reference_->pose.growth(*frame.map);  // the reference keeps its unit
  const AlignResult& align = alignment_ = aligner_->align(T_cam_ref_guess);
  if (align.valid) tracked = makeTracked(align, *frame.map);
  const double surprise =
      distanceBetween(align.T_cam_ref, T_cam_ref_guess, reference_->median_depth);
  tracked.switch_reason = decideSwitch(config_,
                                       {align,
                                        reference_->direct_frames,
                                        reference_->median_depth,
                                        reference_->last_rms,
                                        surprise,
                                        usual_surprise_});
  tracked.ok = tracked.switch_reason == SwitchReason::none;
  if (tracked.switch_reason == SwitchReason::photometric_error) {
    // It ended in a wrong place: what was expected is the better guess.
    tracked.tracker = TrackerKind::none;
    tracked.T_cam_world = T_cam_world_guess;
  }
  if (tracked.ok) {
    ++reference_->direct_frames;
    reference_->last_rms = align.rms;
    usual_surprise_ = std::max(surprise, kSurpriseDecay * usual_surprise_);
  }
  tracked.stats.pyramid_ms = aligner_->times().pyramid_ms;
  tracked.stats.align_ms = aligner_->times().align_ms;
  return tracked;
}

TrackedFrame DirectTracker::makeTracked(const AlignResult& align, const MapSnapshot& map) const {
  TrackedFrame tracked;
  tracked.tracker = TrackerKind::direct;
  tracked.pose = reference_->pose;
  tracked.pose.T_cam_key = align.T_cam_ref * reference_->pose.T_cam_key;
  tracked.T_cam_world = tracked.pose.T_cam_world(map);
  tracked.confidence = align.points > 0 ? static_cast<double>(align.inliers) / align.points : 0.0;
  tracked.stats.visible = align.visible;
  tracked.stats.inliers = align.inliers;
  tracked.stats.rms = align.rms;
  return tracked;
}

void DirectTracker::collectPoints(const Frame& frame, const TrackedFrame& tracked) {
  points_.clear();
  landmarks_.clear();
  for (const LandmarkId id : tracked.landmarks) {
    if (id == kNoLandmark) continue;
    const MapSnapshot::LandmarkEntry* landmark = frame.map->landmark(id);
    if (landmark == nullptr) continue;
    points_.push_back({tracked.T_cam_world * landmark->p_world});
    landmarks_.push_back(id);
  }
  thin(static_cast<std::size_t>(config_.max_points), &points_);
  thin(static_cast<std::size_t>(config_.max_points), &landmarks_);
}

double DirectTracker::refreshReference(const Frame& frame, const TrackedFrame& tracked) {
  collectPoints(frame, tracked);
  reference_.reset();
  const bool is_enough = static_cast<int>(points_.size()) >= config_.min_points;
  if (!is_frame_loaded_ || !is_enough) return 0.0;
  aligner_->promoteReference(points_);
  reference_ = Reference{tracked.pose, medianDepth(points_), 0, 0.0};
  return aligner_->times().precompute_ms;
}

}  // namespace glide
