#include "loop/placement_gates.h"

namespace glide {
namespace {

// A wrong placement is far worse than none, for the next frame is a new chance. What right and
// wrong ones show: docs/algorithms/place-recognition.md.
constexpr int kMinRecognized = 30;  // before anything was looked for
constexpr int kMinInliers = 40;
constexpr double kMinFoundShare = 0.15;      // of the landmarks expected in view
constexpr double kMinAgreement = 0.65;       // of the landmarks found; by chance 0.12 agree
constexpr int kMinCells = 10;                // of 36
constexpr double kMaxPositionSigma = 0.004;  // over the depth: a quarter of 5 cm at 3 m

// Inliers of the second best over those of the best.
constexpr double kRivalShare = 0.5;

}  // namespace

bool isBeyondDoubt(const Placement& placement) {
  return placement.recognized >= kMinRecognized && placement.inliers >= kMinInliers &&
         placement.inliers >= kMinFoundShare * placement.likely &&
         placement.inliers >= kMinAgreement * placement.matched && placement.cells >= kMinCells &&
         placement.position_sigma <= kMaxPositionSigma;
}

bool areAmbiguous(std::span<const Placement> placements) {
  return placements.size() > 1 && placements[1].inliers >= kRivalShare * placements[0].inliers;
}

}  // namespace glide
