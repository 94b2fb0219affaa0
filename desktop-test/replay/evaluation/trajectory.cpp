#include "replay/evaluation/trajectory.h"

#include "replay/common/text.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <optional>
#include <string_view>

namespace glide::replay {
namespace {

constexpr std::size_t kColumns = 8;          // a time, a position and a quaternion
constexpr double kMinQuaternionNorm = 1e-3;  // shorter ones are a placeholder for "unknown"

using PoseNumbers = std::array<double, kColumns - 1>;

std::optional<PoseNumbers> poseNumbers(const std::vector<std::string_view>& fields) {
  PoseNumbers numbers{};
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const std::optional<double> value = parseNumber(fields[i + 1]);
    if (!value) return std::nullopt;
    numbers[i] = *value;
  }
  return numbers;
}

SE3d toPose(const PoseNumbers& v, RigFrame rig) {
  const Vec3d t(v[0], v[1], v[2]);
  // TUM writes x y z w, EuRoC w x y z.
  const Eigen::Quaterniond q = rig == RigFrame::camera ? Eigen::Quaterniond(v[6], v[3], v[4], v[5])
                                                       : Eigen::Quaterniond(v[3], v[4], v[5], v[6]);
  return {q, t};
}

}  // namespace

Result<GroundTruth> readGroundTruth(const std::filesystem::path& file) {
  const Result<std::vector<TextLine>> lines = readDataLines(file);
  if (!lines) return lines.error();
  if (lines->empty()) return errorIn(file, "has no pose");
  GroundTruth truth;
  const bool is_csv = lines->front().text.find(',') != std::string::npos;
  truth.rig = is_csv ? RigFrame::body : RigFrame::camera;
  for (const TextLine& line : *lines) {
    const auto fields = splitFields(line.text, is_csv ? ", \t" : " \t");
    if (fields.size() < kColumns) {
      return errorAt(file, line.number, "expected a time, a position and a quaternion");
    }
    const auto t_ns = is_csv ? parseInteger(fields[0]) : parseSeconds(fields[0]);
    const std::optional<PoseNumbers> numbers = poseNumbers(fields);
    if (!t_ns || !numbers) return errorAt(file, line.number, "has an entry that is not a number");
    SE3d T_world_rig = toPose(*numbers, truth.rig);
    if (T_world_rig.q.norm() < kMinQuaternionNorm) {
      return errorAt(file, line.number, "the quaternion is zero");
    }
    T_world_rig.q.normalize();
    truth.poses.push_back({*t_ns, T_world_rig});
  }
  std::stable_sort(truth.poses.begin(), truth.poses.end(), [](const auto& a, const auto& b) {
    return a.t_ns < b.t_ns;
  });
  return truth;
}

std::string tumText(const Trajectory& trajectory) {
  std::string text = "# timestamp tx ty tz qx qy qz qw\n";
  for (const StampedPose& pose : trajectory) {
    const Vec3d& t = pose.T_world_rig.t;
    const Eigen::Quaterniond& q = pose.T_world_rig.q;
    char line[240];
    std::snprintf(line,
                  sizeof line,
                  "%s %.9f %.9f %.9f %.9f %.9f %.9f %.9f\n",
                  secondsText(pose.t_ns).c_str(),
                  t.x(),
                  t.y(),
                  t.z(),
                  q.x(),
                  q.y(),
                  q.z(),
                  q.w());
    text += line;
  }
  return text;
}

Trajectory inFrame(const Trajectory& trajectory, const SE3d& T_rig_b) {
  Trajectory result = trajectory;
  for (StampedPose& pose : result) pose.T_world_rig = pose.T_world_rig * T_rig_b;
  return result;
}

}  // namespace glide::replay
