#include "track/start_tracks.h"

#include "base/median.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <utility>

namespace glide {
namespace {

// How far features may move between two frames; the last is for a shaken camera. Among bays that
// are alike more is found in a window that holds only one of them.
constexpr std::array<float, 3> kWindows_px{12.0F, 35.0F, 100.0F};
// How far it may be from where its surroundings went: parallax between neighbours, not the motion.
constexpr float kDeviation_px = 12.0F;
// Only features of the finest levels take part: they are located best.
constexpr int kMaxLevel = 1;
constexpr MatchOptions kMatch{50, 0.9, true};

// Surroundings are a cell of this grid with its neighbours.
constexpr std::size_t kColumns = 8, kRows = 6;
// Fewer matches there do not tell how it moved: the whole image does.
constexpr std::size_t kMinNeighbors = 5;

/// Median of each coordinate.
Vec2f medianOf(const std::vector<Vec2f>& flows) {
  std::vector<double> x, y;
  for (const Vec2f& flow : flows) {
    x.push_back(static_cast<double>(flow.x()));
    y.push_back(static_cast<double>(flow.y()));
  }
  return {static_cast<float>(median(std::move(x), 0.0)),
          static_cast<float>(median(std::move(y), 0.0))};
}

using FlowGrid = std::array<std::vector<Vec2f>, kColumns * kRows>;

std::vector<Vec2f> flowsAround(const FlowGrid& grid, std::size_t cell) {
  const std::size_t column = cell % kColumns, row = cell / kColumns;
  std::vector<Vec2f> flows;
  for (std::size_t r = row - std::min<std::size_t>(row, 1); r <= std::min(row + 1, kRows - 1);
       ++r) {
    for (std::size_t c = column - std::min<std::size_t>(column, 1);
         c <= std::min(column + 1, kColumns - 1);
         ++c) {
      const std::vector<Vec2f>& of_cell = grid[r * kColumns + c];
      flows.insert(flows.end(), of_cell.begin(), of_cell.end());
    }
  }
  return flows;
}

}  // namespace

StartTracks::StartTracks(const CameraModel& camera)
    : width_(camera.width()), height_(camera.height()) {}

void StartTracks::start(std::shared_ptr<const FeatureSet> first) {
  first_ = std::move(first);
  expected_uv_.clear();
  for (const Feature& feature : first_->features()) expected_uv_.push_back(feature.uv);
}

std::vector<Match> StartTracks::find(const FeatureSet& now, float window_px) const {
  return matchInWindow(*first_, expected_uv_, now, {kMatch, window_px, kMaxLevel});
}

std::vector<Match> StartTracks::follow(const FeatureSet& now) {
  std::vector<Match> most;
  for (const float window_px : kWindows_px) {
    std::vector<Match> found = find(now, window_px);
    if (found.size() > most.size()) most = std::move(found);
  }
  moveAlong(now, most);
  std::vector<Match> matches = find(now, kDeviation_px);
  for (const Match& match : matches) {
    expected_uv_[static_cast<std::size_t>(match.a)] =
        now.feature(static_cast<std::size_t>(match.b)).uv;
  }
  return matches;
}

std::size_t StartTracks::cellOf(const Vec2f& uv) const {
  const auto index = [](float at, int size, std::size_t count) {
    const float share = std::clamp(at / static_cast<float>(size), 0.0F, 1.0F);
    return std::min(static_cast<std::size_t>(share * static_cast<float>(count)), count - 1);
  };
  return index(uv.y(), height_, kRows) * kColumns + index(uv.x(), width_, kColumns);
}

void StartTracks::moveAlong(const FeatureSet& now, std::span<const Match> matches) {
  FlowGrid grid;
  std::vector<Vec2f> all;
  for (const Match& match : matches) {
    const Vec2f& from = expected_uv_[static_cast<std::size_t>(match.a)];
    all.push_back(now.feature(static_cast<std::size_t>(match.b)).uv - from);
    grid[cellOf(from)].push_back(all.back());
  }
  std::array<Vec2f, kColumns * kRows> motion;
  motion.fill(medianOf(all));
  for (std::size_t cell = 0; cell < motion.size(); ++cell) {
    const std::vector<Vec2f> flows = flowsAround(grid, cell);
    if (flows.size() >= kMinNeighbors) motion[cell] = medianOf(flows);
  }
  for (Vec2f& uv : expected_uv_) uv += motion[cellOf(uv)];
}

}  // namespace glide
