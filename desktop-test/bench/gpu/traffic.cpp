#include "bench/gpu/traffic.h"

#include "gpu/align_layout.h"

#include "image/pyramid.h"

namespace glide::gpubench {
namespace {

constexpr double kFloat = sizeof(float);
constexpr double kPosition = 4.0 * kFloat;  // xyz and padding

Traffic& operator+=(Traffic& sum, const Traffic& other) {
  sum.read += other.read;
  sum.written += other.written;
  return sum;
}

Traffic operator*(double factor, const Traffic& traffic) {
  return {factor * traffic.read, factor * traffic.written};
}

/// Pixels of a level.
double area(const Workload& workload, int level) {
  return 1.0 * levelSide(workload.width, level) * levelSide(workload.height, level);
}

Traffic pyramidTraffic(const Workload& workload, GpuPlan plan, int levels) {
  Traffic sum;
  for (int level = 0; level + 1 < levels; ++level) {
    sum += {kFloat * area(workload, level), kFloat * area(workload, level + 1)};
    if (plan != GpuPlan::paper) continue;
    sum += {kFloat * levelSide(workload.width, level + 1) * levelSide(workload.height, level),
            kFloat * area(workload, level)};
  }
  return sum;
}

/// Bytes per pixel of a patch in a plan's cache.
double pixelBytes(const Workload& workload, GpuPlan plan) {
  const int floats = plan == GpuPlan::paper ? kPaperPixelFloats : kPixelFloats;
  return kFloat * floats * workload.patch * workload.patch;
}

/// Texels under a patch at a fraction of a pixel, and `around` it.
double texelBytes(const Workload& workload, int around) {
  const double side = workload.patch + 1 + around;
  return kFloat * side * side;
}

// Per point, PaperPlan: H as it is stored, and what an iteration sums.
constexpr double kHessian = 24.0 * kFloat, kTerm = 8.0 * kFloat, kTotal = 12.0 * kFloat;
constexpr double kState = sizeof(GpuAlignState);

Traffic precomputeOfPoint(const Workload& workload, GpuPlan plan) {
  constexpr int kAround = 2;  // one pixel on each side, for the central differences
  Traffic point{kPosition + texelBytes(workload, kAround), pixelBytes(workload, plan)};
  if (plan == GpuPlan::paper) {
    point += {kHessian, kPosition + kHessian};
  } else {
    point += {0.0, sizeof(GpuPointRecord)};
  }
  return point;
}

Traffic fusedIteration(const Workload& workload, double points) {
  constexpr double kMean = 4.0 * kFloat, kWeight = 2.0 * kFloat, kSums = sizeof(GpuPointSums);
  const double pixels = pixelBytes(workload, GpuPlan::fused) + texelBytes(workload, 0);
  Traffic sum = points * Traffic{kPosition + kMean + pixels, kSums};
  sum += points * Traffic{kSums + sizeof(GpuPointRecord), kWeight};
  sum += {2.0 * kState, kState};
  return sum;
}

Traffic paperIteration(const Workload& workload, double points) {
  const double pixels = pixelBytes(workload, GpuPlan::paper) + texelBytes(workload, 0);
  Traffic sum = points * Traffic{kPosition + pixels + kTerm, kTerm};
  sum += {kTotal + kHessian + 3.0 * kState, kTotal + kState};
  return sum;
}

}  // namespace

int levelSide(int side, int level) {
  for (; level > 0; --level) side = (side + 1) / 2;
  return side;
}

std::array<Traffic, kGpuStages> countTraffic(const Workload& workload, const TrafficCase& what) {
  const int levels = pyramidLevels(workload.width, workload.height, workload.levels);
  const double image = area(workload, 0);
  std::array<Traffic, kGpuStages> stages;
  const auto of = [&](GpuStage stage) -> Traffic& {
    return stages[static_cast<std::size_t>(stage)];
  };
  of(GpuStage::upload) = {2.0 * image, image + kFloat * image};
  of(GpuStage::pyramid) = pyramidTraffic(workload, what.plan, levels);
  for (std::size_t level = 0; level < static_cast<std::size_t>(levels); ++level) {
    const double points = what.points[level];
    of(GpuStage::precompute) += points * precomputeOfPoint(workload, what.plan);
    of(GpuStage::track) +=
        what.iterations[level] * (what.plan == GpuPlan::paper ? paperIteration(workload, points)
                                                              : fusedIteration(workload, points));
  }
  of(GpuStage::readback) = {kState, kState};
  return stages;
}

}  // namespace glide::gpubench
