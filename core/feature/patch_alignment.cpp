#include "feature/patch_alignment.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glide {
namespace {

constexpr int kGrid = 8;  // template pixels on a side
constexpr int kPixels = kGrid * kGrid;
constexpr int kRing = kGrid + 2;  // with the ring that central differences need
constexpr int kMaxIterations = 12;
constexpr float kConverged_px = 0.01F;
// Further away the descriptor matched another corner.
constexpr float kMaxMove_px = 2.5F;
// Correlation of two looks at the same corner; noise and small changes of view leave more than
// this.
constexpr float kMinCorrelation = 0.8F;
// Templates with less contrast than this carry no position, grey levels.
constexpr float kMinDeviation = 2.0F;

using Template = std::array<float, kPixels>;

/// Bilinear sample; false outside of the patch. Coordinates in patch pixels.
bool sample(const FeaturePatch& patch, float x, float y, float* value) {
  constexpr float kLast = FeaturePatch::kSize - 1;
  if (!(x >= 0.0F && y >= 0.0F && x < kLast && y < kLast)) return false;
  const int xi = static_cast<int>(x);
  const int yi = static_cast<int>(y);
  const float fx = x - static_cast<float>(xi);
  const float fy = y - static_cast<float>(yi);
  const std::uint8_t* p = patch.pixels.data() + yi * FeaturePatch::kSize + xi;
  const float upper = static_cast<float>(p[0]) + fx * static_cast<float>(p[1] - p[0]);
  const std::uint8_t* q = p + FeaturePatch::kSize;
  const float lower = static_cast<float>(q[0]) + fx * static_cast<float>(q[1] - q[0]);
  *value = upper + fy * (lower - upper);
  return true;
}

float offsetOf(int cell, int cells) {
  return static_cast<float>(cell) - 0.5F * static_cast<float>(cells - 1);
}

/// The source as the target would see it, with a ring around it.
bool warpSource(const FeaturePatch& source,
                const Eigen::Matrix2f& A_source_target,
                std::array<float, kRing * kRing>* warped) {
  const Vec2f corner = source.corner();
  for (int y = 0; y < kRing; ++y)
    for (int x = 0; x < kRing; ++x) {
      const Vec2f at = corner + A_source_target * Vec2f(offsetOf(x, kRing), offsetOf(y, kRing));
      float* value = &(*warped)[static_cast<std::size_t>(y * kRing + x)];
      if (!sample(source, at.x(), at.y(), value)) return false;
    }
  return true;
}

struct Linearised {
  Template value{}, gx{}, gy{};  ///< mean-free
  Eigen::Matrix2f H_inverse;
  float deviation = 0.0F;
};

float removeMean(Template* values) {
  float sum = 0.0F;
  for (const float v : *values) sum += v;
  float squares = 0.0F;
  for (float& v : *values) {
    v -= sum / kPixels;
    squares += v * v;
  }
  return std::sqrt(squares / kPixels);
}

std::optional<Linearised> linearise(const std::array<float, kRing * kRing>& warped) {
  Linearised t;
  for (int y = 0; y < kGrid; ++y)
    for (int x = 0; x < kGrid; ++x) {
      const float* p = warped.data() + (y + 1) * kRing + x + 1;
      const std::size_t k = static_cast<std::size_t>(y * kGrid + x);
      t.value[k] = *p;
      t.gx[k] = 0.5F * (p[1] - p[-1]);
      t.gy[k] = 0.5F * (p[kRing] - p[-kRing]);
    }
  t.deviation = removeMean(&t.value);
  if (t.deviation < kMinDeviation) return std::nullopt;
  removeMean(&t.gx);  // the bias is solved for: its column is orthogonal to mean-free gradients
  removeMean(&t.gy);
  Eigen::Matrix2f H = Eigen::Matrix2f::Zero();
  for (std::size_t k = 0; k < kPixels; ++k) {
    const Vec2f g(t.gx[k], t.gy[k]);
    H += g * g.transpose();
  }
  const float determinant = H.determinant();
  const float trace = H.trace();
  constexpr float kMinCondition = 0.01F;  // an edge slides along itself
  if (!(determinant > kMinCondition * trace * trace / 4.0F)) return std::nullopt;
  t.H_inverse = H.inverse();
  return t;
}

/// Mean-free target pixels around `at`; their deviation, or nothing outside of the patch.
std::optional<float> sampleTarget(const FeaturePatch& target, const Vec2f& at, Template* values) {
  for (int y = 0; y < kGrid; ++y)
    for (int x = 0; x < kGrid; ++x) {
      float* value = &(*values)[static_cast<std::size_t>(y * kGrid + x)];
      if (!sample(target, at.x() + offsetOf(x, kGrid), at.y() + offsetOf(y, kGrid), value))
        return std::nullopt;
    }
  return removeMean(values);
}

float correlation(const Linearised& t, const Template& values, float deviation) {
  float sum = 0.0F;
  for (std::size_t k = 0; k < kPixels; ++k) sum += t.value[k] * values[k];
  return sum / (kPixels * std::max(t.deviation * deviation, 1e-6F));
}

Vec2f step(const Linearised& t, const Template& values, float gain) {
  Vec2f b = Vec2f::Zero();
  for (std::size_t k = 0; k < kPixels; ++k) {
    const float residual = values[k] * gain - t.value[k];
    b += Vec2f(t.gx[k], t.gy[k]) * residual;
  }
  return t.H_inverse * b;
}

}  // namespace

std::optional<Vec2f> alignPatch(const FeaturePatch& source,
                                const FeaturePatch& target,
                                const Eigen::Matrix2f& A_target_source) {
  std::array<float, kRing * kRing> warped{};
  if (!warpSource(source, A_target_source.inverse(), &warped)) return std::nullopt;
  const std::optional<Linearised> reference = linearise(warped);
  if (!reference) return std::nullopt;
  const Vec2f start = target.corner();
  Vec2f at = start;
  Template values;
  for (int i = 0; i < kMaxIterations; ++i) {
    const std::optional<float> deviation = sampleTarget(target, at, &values);
    if (!deviation || *deviation < kMinDeviation) return std::nullopt;
    const Vec2f delta = step(*reference, values, reference->deviation / *deviation);
    at -= delta;
    if (!((at - start).norm() < kMaxMove_px)) return std::nullopt;
    if (delta.norm() >= kConverged_px) continue;
    if (correlation(*reference, values, *deviation) < kMinCorrelation) return std::nullopt;
    return Vec2f(at - FeaturePatch::centre());
  }
  return std::nullopt;
}

}  // namespace glide
