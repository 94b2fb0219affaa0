#include "session/session_impl.h"

#include "map/map_snapshot.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

namespace glide {
namespace {

// Calibrations that are read from files differ in their last digits.
constexpr double kCameraTolerance = 1e-6;

bool isClose(double a, double b) {
  return std::abs(a - b) <= kCameraTolerance * std::max({1.0, std::abs(a), std::abs(b)});
}

/// A pinhole is the radial-tangential camera without distortion.
std::array<double, 5> coefficientsOf(const CameraIntrinsics& camera) {
  std::array<double, 5> k{};
  std::copy_n(
      camera.coefficients.begin(), std::min(camera.coefficients.size(), k.size()), k.begin());
  return k;
}

/// Whether a map can have been made with the camera: it brings the k1 that it corrected along.
bool isSameCamera(const CameraIntrinsics& a, const CameraIntrinsics& b) {
  const bool same_image = a.width == b.width && a.height == b.height;
  const bool same_pinhole =
      isClose(a.fx, b.fx) && isClose(a.fy, b.fy) && isClose(a.cx, b.cx) && isClose(a.cy, b.cy);
  const bool same_model = (a.distortion == DistortionModel::kannala_brandt4) ==
                          (b.distortion == DistortionModel::kannala_brandt4);
  const std::array<double, 5> k_a = coefficientsOf(a);
  const std::array<double, 5> k_b = coefficientsOf(b);
  return same_image && same_pinhole && same_model &&
         std::abs(k_a[0] - k_b[0]) <= kMaxRadialCorrection + kCameraTolerance &&
         std::equal(k_a.begin() + 1, k_a.end(), k_b.begin() + 1, isClose);
}

std::string describe(const CameraIntrinsics& camera) {
  return std::to_string(camera.width) + "x" + std::to_string(camera.height) +
         ", fx = " + std::to_string(camera.fx);
}

}  // namespace

void Session::Impl::reset() {
  back_end_.send(ClearMap{});
  ++generation_;
  ++resets_;
  forgetMap();
}

void Session::Impl::pause() { is_paused_ = true; }

void Session::Impl::resume() {
  is_paused_ = false;
  motion_.stop();  // the camera may be anywhere by now
  if (direct_) direct_->dropReference();
}

void Session::Impl::releaseGl() {
  reader_.releaseGl();
  if (direct_ && config_.backend != Backend::cpu) direct_->releaseAligner();
}

void Session::Impl::abandonGl() {
  reader_.abandonGl();
  if (direct_ && config_.backend != Backend::cpu) direct_->abandonAligner();
}

Status Session::Impl::ensureAligner() {
  if (!direct_ || direct_->isUsable()) return Unit{};
  Result<ChosenAligner> chosen = chooseAligner(config_, camera_);
  if (!chosen) return chosen.error();
  backend_ = std::move(chosen->info);
  direct_->setAligner(std::move(chosen->aligner));
  reader_.setBackend(backend_.backend);
  return Unit{};
}

std::shared_ptr<const MapSnapshot> Session::Impl::mapOf(std::uint64_t generation) const {
  std::shared_ptr<const MapSnapshot> mapped = back_end_.snapshot();
  return mapped->generation() == generation ? mapped : no_map_;
}

std::shared_ptr<const MapView> Session::Impl::view() const {
  const std::uint64_t generation = this->generation();
  return shown(mapOf(generation), generation)->view();
}

std::shared_ptr<const SnapshotMap> Session::Impl::shown(
    const std::shared_ptr<const MapSnapshot>& map, std::uint64_t generation) const {
  const auto is_same = [&](const SnapshotMap& other) {
    return other.generation() == generation && other.revision() == map->revision();
  };
  if (auto of_frame = frame_map_.load(); is_same(*of_frame)) return of_frame;
  if (auto newest = newest_map_.load(); is_same(*newest)) return newest;
  auto made = std::make_shared<const SnapshotMap>(map, generation, resets_.load());
  newest_map_.store(made);
  return made;
}

LocatedCamera Session::Impl::locate(std::int64_t t_ns) const {
  const std::shared_ptr<const PoseTimeline> timeline = timeline_.load();
  const std::shared_ptr<const SnapshotMap> map = frame_map_.load();
  const bool is_of_map = map->generation() == timeline->generation();
  return timeline->at(t_ns, is_of_map ? map->snapshot() : *no_map_);
}

StoredMap Session::Impl::stored() const {
  const std::shared_ptr<const MapSnapshot> shown = map();
  const auto& corrected = shown->correctedCamera();
  return {shown,
          corrected ? corrected->intrinsics() : config_.camera,
          ScaleLevels(config_.features.scale_factor, config_.features.levels)};
}

Status Session::Impl::restore(const StoredMap& stored) {
  const auto refuse = [](const std::string& what) {
    return Error{ErrorCode::invalid_argument, "the map was made with " + what};
  };
  if (!isSameCamera(stored.camera, config_.camera))
    return refuse("another camera: " + describe(stored.camera) + "; this session has " +
                  describe(config_.camera));
  if (stored.levels.count() != config_.features.levels ||
      !isClose(stored.levels.factor(), config_.features.scale_factor))
    return refuse("other values of features.levels or features.scale_factor");
  if (stored.map->empty()) return refuse("no keyframe");
  forgetMap();
  back_end_.send(RestoredMap{stored.map});
  ++generation_;
  const MapSnapshot& map = *stored.map;
  const KeyframeId last = map.keyframes().back().id;
  std::uint64_t newest = last.value;
  if (!map.retired().empty()) newest = std::max(newest, map.retired().back().id.value);
  next_keyframe_id_ = std::max(next_keyframe_id_, newest + 1);
  map_start_ = map.keyframes().front().id;
  last_keyframe_ = LastKeyframe{last, 0};
  last_pose_ = anchorTo(last, *map.T_cam_world(last), map);
  is_restored_ = true;
  lost_frames_ = 1;  // nothing is known about where the camera is
  return Unit{};
}

}  // namespace glide
