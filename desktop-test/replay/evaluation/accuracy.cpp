#include "replay/evaluation/accuracy.h"

#include "replay/common/text.h"

#include "geometry/align_sim3.h"

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

constexpr double kMaxTimeDifference = 0.01;  // s, evo's default t_max_diff
constexpr double kRelativeDelta = 1.0;       // s
constexpr double kRelativeTolerance = 0.1;   // s, so that a truth at 6 Hz still has pairs
constexpr double kTimeJitter = 1e-3;         // s, so that the last pose counts as a second later
constexpr double kDegPerRad = 57.29577951308232;

/// Times as the doubles that evo reads from our files: its comparisons with 10 ms are made in them.
std::vector<double> seconds(const Trajectory& trajectory) {
  std::vector<double> times;
  times.reserve(trajectory.size());
  for (const StampedPose& pose : trajectory) times.push_back(toSeconds(pose.t_ns));
  return times;
}

/// Index of the sorted time nearest to t, the earlier one on a tie.
std::size_t nearest(const std::vector<double>& sorted, double t) {
  const auto after = std::upper_bound(sorted.begin(), sorted.end(), t);
  const std::size_t upper =
      std::min(static_cast<std::size_t>(after - sorted.begin()), sorted.size() - 1);
  if (upper == 0) return 0;
  return sorted[upper] - t < t - sorted[upper - 1] ? upper : upper - 1;
}

/// Compares as evo does, bit for bit: beyond the ends with the shifted end, inside by difference.
bool isSameTime(const std::vector<double>& sorted, std::size_t index, double t) {
  if (t > sorted.back()) return t <= sorted.back() + kMaxTimeDifference;
  if (t < sorted.front() - kMaxTimeDifference) return false;
  return std::abs(sorted[index] - t) <= kMaxTimeDifference;
}

}  // namespace

std::vector<PosePair> associate(const Trajectory& truth, const Trajectory& estimate) {
  std::vector<PosePair> pairs;
  if (truth.empty() || estimate.empty()) return pairs;
  const bool is_truth_shorter = estimate.size() > truth.size();
  const std::vector<double> shorter = seconds(is_truth_shorter ? truth : estimate);
  const std::vector<double> longer = seconds(is_truth_shorter ? estimate : truth);
  for (std::size_t i = 0; i < shorter.size(); ++i) {
    const std::size_t j = nearest(longer, shorter[i]);
    if (!isSameTime(longer, j, shorter[i])) continue;
    pairs.push_back(is_truth_shorter ? PosePair{i, j} : PosePair{j, i});
  }
  return pairs;
}

std::optional<AbsoluteError> absoluteError(const Trajectory& truth, const Trajectory& estimate) {
  std::vector<Vec3d> p_truth, p_estimate;
  for (const PosePair& pair : associate(truth, estimate)) {
    p_truth.push_back(truth[pair.truth].T_world_rig.t);
    p_estimate.push_back(estimate[pair.estimate].T_world_rig.t);
  }
  const auto S_truth_estimate = alignSim3(p_truth, p_estimate, AlignScale::estimated);
  if (!S_truth_estimate) return std::nullopt;
  AbsoluteError error;
  error.scale = S_truth_estimate->s;
  double sum = 0.0;
  for (std::size_t i = 0; i < p_truth.size(); ++i) {
    const double squared = (p_truth[i] - *S_truth_estimate * p_estimate[i]).squaredNorm();
    sum += squared;
    error.max_m = std::max(error.max_m, std::sqrt(squared));
  }
  error.rmse_m = std::sqrt(sum / static_cast<double>(p_truth.size()));
  return error;
}

std::optional<RelativeError> relativeError(const Trajectory& truth,
                                           const Trajectory& estimate,
                                           double scale) {
  const std::vector<PosePair> pairs = associate(truth, estimate);
  std::vector<double> times;
  times.reserve(pairs.size());
  for (const PosePair& pair : pairs) times.push_back(toSeconds(estimate[pair.estimate].t_ns));
  RelativeError error;
  double trans_sum = 0.0, rot_sum = 0.0;
  for (std::size_t i = 0; i < pairs.size(); ++i) {
    if (times[i] + kRelativeDelta > times.back() + kTimeJitter) break;
    const std::size_t j = nearest(times, times[i] + kRelativeDelta);
    if (j <= i || std::abs(times[j] - times[i] - kRelativeDelta) > kRelativeTolerance) continue;
    const SE3d T_i_j_truth =
        truth[pairs[i].truth].T_world_rig.inverse() * truth[pairs[j].truth].T_world_rig;
    SE3d T_i_j =
        estimate[pairs[i].estimate].T_world_rig.inverse() * estimate[pairs[j].estimate].T_world_rig;
    T_i_j.t *= scale;
    const SE3d difference = T_i_j_truth.inverse() * T_i_j;
    trans_sum += difference.t.squaredNorm();
    rot_sum += so3Log(difference.q).squaredNorm();
    ++error.pairs;
  }
  if (error.pairs == 0) return std::nullopt;
  error.trans_m = std::sqrt(trans_sum / error.pairs);
  error.rot_deg = std::sqrt(rot_sum / error.pairs) * kDegPerRad;
  return error;
}

}  // namespace glide::replay
