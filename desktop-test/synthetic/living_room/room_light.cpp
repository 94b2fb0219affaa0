#include "synthetic/living_room/room_light.h"

#include "synthetic/random.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <future>
#include <thread>
#include <utility>

namespace glide::synthetic {

namespace {

constexpr float kPi = 3.14159265F;
// Texels between nodes of direct light, finer than its softest shadows; metres between those of
// light that is passed on.
constexpr float kFineTexels = 12.0F, kCoarse = 0.1F;
constexpr float kInset = 2e-3F;  // metres: nodes do not lie in other surfaces
constexpr int kSunSamples = 4, kBulbSamples = 5;
constexpr int kOpeningSamples = 5;   // per side
constexpr float kSunRadius = 0.02F;  // radians: a little more than the sun's, for nodes 3 cm apart
constexpr int kGatherRays = 64;
constexpr int kBounces = 2;

/// Two unit vectors that are perpendicular to a unit vector and to each other.
std::pair<Vec3f, Vec3f> tangentsOf(const Vec3f& normal) {
  const Vec3f helper = std::abs(normal.x()) < 0.7F ? Vec3f::UnitX() : Vec3f::UnitY();
  const Vec3f a = normal.cross(helper).normalized();
  return {a, normal.cross(a)};
}

/// The k-th of n points spread evenly over the unit disc (Vogel's spiral).
Vec2f discPoint(int k, int n) {
  constexpr float kGoldenAngle = 2.39996323F;
  const float radius = std::sqrt((static_cast<float>(k) + 0.5F) / static_cast<float>(n));
  const float angle = kGoldenAngle * static_cast<float>(k);
  return radius * Vec2f(std::cos(angle), std::sin(angle));
}

std::vector<int> opaque(std::span<const Reflector> reflectors) {
  std::vector<int> indices;
  for (std::size_t i = 0; i < reflectors.size(); ++i) {
    if (!reflectors[i].is_shining) indices.push_back(static_cast<int>(i));
  }
  return indices;
}

template <class Spacing>
std::vector<LightGrid> gridsOf(std::span<const Surface> surfaces, const Spacing& spacing) {
  std::vector<LightGrid> grids;
  for (const Surface& surface : surfaces) grids.emplace_back(surface, spacing(surface));
  return grids;
}

float fineSpacing(const Surface& surface) { return kFineTexels / surface.texels_per_m; }
float coarseSpacing(const Surface&) { return kCoarse; }

}  // namespace

LightGrid::LightGrid(const Surface& surface, float spacing_m)
    : size_(surface.width, surface.height) {
  const auto cells = [&](float length) {
    return std::max(1, static_cast<int>(std::lround(length / spacing_m)));
  };
  const int w = cells(surface.width), h = cells(surface.height);
  spacing_ = size_.cwiseQuotient(Vec2f(static_cast<float>(w), static_cast<float>(h)));
  nodes_.resize(w + 1, h + 1);
}

Vec2f LightGrid::placeOf(int x, int y) const {
  const Vec2f place = spacing_.cwiseProduct(Vec2f(static_cast<float>(x), static_cast<float>(y)));
  const Vec2f inset = Vec2f::Constant(kInset).cwiseMin(0.5F * size_);
  return place.cwiseMax(inset).cwiseMin(size_ - inset);
}

Vec3f LightGrid::at(float u, float v) const {
  const float x = u / spacing_.x(), y = v / spacing_.y();
  const int x0 = std::clamp(static_cast<int>(x), 0, nodes_.width() - 2);
  const int y0 = std::clamp(static_cast<int>(y), 0, nodes_.height() - 2);
  const float fx = x - static_cast<float>(x0), fy = y - static_cast<float>(y0);
  const Vec3f *top = nodes_.row(y0) + x0, *bottom = nodes_.row(y0 + 1) + x0;
  return (1 - fy) * ((1 - fx) * top[0] + fx * top[1]) +
         fy * ((1 - fx) * bottom[0] + fx * bottom[1]);
}

LitRoom::LitRoom(std::span<const Surface> surfaces,
                 std::vector<Reflector> reflectors,
                 const RoomLight& light)
    : surfaces_(surfaces),
      reflectors_(std::move(reflectors)),
      light_(light),
      tree_(surfaces, opaque(reflectors_)),
      direct_(gridsOf(surfaces, fineSpacing)),
      bounced_(gridsOf(surfaces, coarseSpacing)) {
  fillGrids(&direct_, [this](const Vec3f& p, const Vec3f& normal) { return direct(p, normal); });
  for (LightGrid& grid : bounced_) {
    for (int y = 0; y < grid.nodes().height(); ++y)
      std::fill_n(grid.nodes().row(y), grid.nodes().width(), black<Vec3f>());
  }
  for (int bounce = 0; bounce < kBounces; ++bounce) {
    std::vector<LightGrid> next = bounced_;
    fillGrids(&next, [this](const Vec3f& p, const Vec3f& normal) { return gathered(p, normal); });
    bounced_ = std::move(next);
  }
}

template <class Light>
void LitRoom::fillGrids(std::vector<LightGrid>* grids, const Light& light) const {
  std::atomic<std::size_t> next{0};
  const auto work = [&] {
    for (std::size_t i = next++; i < grids->size(); i = next++) {
      if (reflectors_[i].is_shining) continue;
      const Surface& surface = surfaces_[i];
      LightGrid& grid = (*grids)[i];
      for (int y = 0; y < grid.nodes().height(); ++y) {
        for (int x = 0; x < grid.nodes().width(); ++x) {
          const Vec2f place = grid.placeOf(x, y);
          const Vec3f p = surface.origin + place.x() * surface.axis_u + place.y() * surface.axis_v +
                          kInset * surface.normal;
          grid.nodes().row(y)[x] = light(p, surface.normal);
        }
      }
    }
  };
  std::vector<std::future<void>> helpers;
  for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k)
    helpers.push_back(std::async(std::launch::async, work));
  work();
}

Vec3f LitRoom::at(std::size_t surface, float u, float v) const {
  return direct_[surface].at(u, v) + bounced_[surface].at(u, v);
}

Vec3f LitRoom::direct(const Vec3f& p, const Vec3f& normal) const {
  Vec3f sum = fromSun(p, normal);
  for (const Opening& opening : light_.openings) sum += fromOpening(opening, p, normal);
  for (const Bulb& bulb : light_.bulbs) sum += fromBulb(bulb, p, normal);
  return sum;
}

Vec3f LitRoom::fromSun(const Vec3f& p, const Vec3f& normal) const {
  const float cosine = normal.dot(light_.to_sun);
  if (cosine <= 0.0F) return Vec3f::Zero();
  constexpr float kFar = 50.0F;  // metres: out of the house
  const auto [a, b] = tangentsOf(light_.to_sun);
  int free = 0;
  for (int k = 0; k < kSunSamples; ++k) {
    const Vec2f spread = kSunRadius * discPoint(k, kSunSamples);
    const Vec3f way = kFar * (light_.to_sun + spread.x() * a + spread.y() * b);
    free += tree_.isBlocked(p, p + way) ? 0 : 1;
  }
  return cosine * static_cast<float>(free) / kSunSamples * light_.sun;
}

Vec3f LitRoom::fromOpening(const Opening& opening, const Vec3f& p, const Vec3f& normal) const {
  const Vec3f area = opening.along_u.cross(opening.along_v);
  float sum = 0.0F;
  for (int k = 0; k < kOpeningSamples * kOpeningSamples; ++k) {
    const float u = (static_cast<float>(k % kOpeningSamples) + 0.5F) / kOpeningSamples;
    const float v = (static_cast<float>(k / kOpeningSamples) + 0.5F) / kOpeningSamples;
    const Vec3f source = opening.corner + u * opening.along_u + v * opening.along_v;
    const Vec3f way = source - p;
    const float r2 = way.squaredNorm();
    const float here = normal.dot(way), there = std::abs(area.dot(way));
    if (here <= 0.0F || tree_.isBlocked(p, source)) continue;
    sum += here * there / (kPi * r2 * r2);
  }
  return sum / (kOpeningSamples * kOpeningSamples) * opening.radiance;
}

Vec3f LitRoom::fromBulb(const Bulb& bulb, const Vec3f& p, const Vec3f& normal) const {
  const Vec3f axis = (bulb.center - p).normalized();
  const auto [a, b] = tangentsOf(axis);
  float sum = 0.0F;
  for (int k = 0; k < kBulbSamples; ++k) {
    const Vec2f spread = bulb.radius * discPoint(k, kBulbSamples);
    const Vec3f way = bulb.center + spread.x() * a + spread.y() * b - p;
    const float r = way.norm(), cosine = normal.dot(way) / r;
    if (cosine <= 0.0F || tree_.isBlocked(p, p + way)) continue;
    // No brighter than at the shade's surface.
    sum += cosine / std::max(r * r, bulb.radius * bulb.radius);
  }
  return sum / kBulbSamples * bulb.power;
}

Vec3f LitRoom::gathered(const Vec3f& p, const Vec3f& normal) const {
  const auto [a, b] = tangentsOf(normal);
  Vec3f sum = Vec3f::Zero();
  for (int k = 0; k < kGatherRays; ++k) {
    const Vec2f foot = discPoint(k, kGatherRays);  // its projection makes it cosine-weighted
    const float height = std::sqrt(std::max(0.0F, 1.0F - foot.squaredNorm()));
    const Meeting meeting = tree_.nearest(p, foot.x() * a + foot.y() * b + height * normal);
    if (meeting.index < 0 || meeting.is_from_behind) continue;
    const auto surface = static_cast<std::size_t>(meeting.index);
    sum += reflectors_[surface].albedo.cwiseProduct(at(surface, meeting.u, meeting.v));
  }
  return sum / kGatherRays;
}

}  // namespace glide::synthetic
