#include "synthetic/living_room/room_builder.h"

#include "synthetic/scene_builder.h"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <thread>
#include <utility>

namespace glide::synthetic {

namespace {

constexpr float kTwoPi = 6.28318531F;
constexpr float kGamma = 2.2F;  // of screens, about

/// A function of 0..limit in steps: powers are slow.
class Curve {
 public:
  template <class Function>
  Curve(float limit, const Function& function) : scale_(kSteps / limit) {
    for (int i = 0; i <= kSteps; ++i)
      values_[static_cast<std::size_t>(i)] = function(static_cast<float>(i) / scale_);
  }
  float operator()(float x) const {
    return values_[static_cast<std::size_t>(std::clamp(x * scale_, 0.0F, float{kSteps}))];
  }
  Vec3f operator()(const Vec3f& x) const {
    return {(*this)(x.x()), (*this)(x.y()), (*this)(x.z())};
  }

 private:
  static constexpr int kSteps = 8192;
  float scale_;
  std::array<float, kSteps + 1> values_{};
};

/// From colours as painted to linear reflectance.
Curve reflectanceCurve() {
  return Curve(1.0F, [](float shown) { return std::pow(shown, kGamma); });
}

/// From linear radiance to levels 0..255, with a shoulder instead of a clipped end.
Curve filmCurve() {
  constexpr float kSpeed = 1.8F, kBrightest = 6.0F;
  return Curve(kBrightest, [](float radiance) {
    return 255.0F * std::pow(1.0F - std::exp(-kSpeed * radiance), 1.0F / kGamma);
  });
}

ColorCanvas canvasOf(const Surface& surface) {
  const auto texels = [&](float metres) {
    return std::max(2, static_cast<int>(std::lround(metres * surface.texels_per_m)));
  };
  ColorCanvas canvas;
  canvas.texels_per_m = surface.texels_per_m;
  canvas.color.resize(texels(surface.width), texels(surface.height));
  return canvas;
}

template <class Change>
void forEachTexel(ImageRgb* image, const Change& change) {
  for (int y = 0; y < image->height(); ++y) {
    for (int x = 0; x < image->width(); ++x) change(x, y, &image->row(y)[x]);
  }
}

Vec3f meanOf(ImageRgb* image) {
  Vec3f sum = Vec3f::Zero();
  forEachTexel(image, [&](int, int, const Vec3f* texel) { sum += *texel; });
  return sum / (static_cast<float>(image->width()) * static_cast<float>(image->height()));
}

/// Calls work(i) for 0 <= i < count on all cores.
template <class Work>
void inParallel(std::size_t count, const Work& work) {
  std::atomic<std::size_t> next{0};
  const auto loop = [&] {
    for (std::size_t i = next++; i < count; i = next++) work(i);
  };
  std::vector<std::future<void>> helpers;
  for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k)
    helpers.push_back(std::async(std::launch::async, loop));
  loop();
}

}  // namespace

BoxLook allAround(const Look& look) { return {look, look, look}; }

Vec3f Stand::at(float right, float up, float back) const {
  return foot + Eigen::AngleAxisf(yaw, Vec3f::UnitY()) * Vec3f(right, -up, back);
}

Stand Stand::stand(float right, float up, float back, float turn) const {
  return {at(right, up, back), yaw + turn};
}

void RoomBuilder::add(const Vec3f& origin,
                      const Vec3f& along_u,
                      const Vec3f& along_v,
                      const Look& look) {
  Scene scene;
  Surface surface;
  surface.texels_per_m = look.texels_per_m;
  surface.is_round = look.is_round;
  addSurface(origin, along_u, along_v, surface, &scene);
  surfaces_.push_back(std::move(scene.surfaces.front()));
  looks_.push_back(look);
}

void RoomBuilder::addBox(const Stand& stand, const Vec3f& size, const BoxLook& look) {
  const float w = size.x(), h = size.y(), d = size.z();
  const Vec3f right = stand.at(1, 0, 0) - stand.foot, back = stand.at(0, 0, 1) - stand.foot;
  const Vec3f down = h * Vec3f::UnitY();
  add(stand.at(-0.5F * w, h, -0.5F * d), w * right, down, look.front);
  add(stand.at(0.5F * w, h, 0.5F * d), -w * right, down, look.front);
  add(stand.at(0.5F * w, h, -0.5F * d), d * back, down, look.side);
  add(stand.at(-0.5F * w, h, 0.5F * d), -d * back, down, look.side);
  add(stand.at(-0.5F * w, h, 0.5F * d), w * right, -d * back, look.top);
}

void RoomBuilder::addSlab(const Stand& stand, const Vec3f& size, const BoxLook& look) {
  addBox(stand, size, look);
  const float w = size.x(), d = size.z();
  add(stand.at(-0.5F * w, 0.0F, -0.5F * d),
      stand.at(w, 0, 0) - stand.foot,
      stand.at(0, 0, d) - stand.foot,
      look.top);
}

void RoomBuilder::addBar(const Vec3f& from, const Vec3f& to, float thickness, const Look& look) {
  const Vec3f way = to - from, along = way.normalized();
  const Vec3f helper = std::abs(along.y()) < 0.9F ? Vec3f::UnitY() : Vec3f::UnitX();
  const Vec3f a = along.cross(helper).normalized(), b = along.cross(a);
  const Vec3f corner = from - 0.5F * thickness * (a + b);
  const Vec3f u = thickness * a, v = thickness * b;
  add(corner + v, way, -v, look);
  add(corner + u, way, v, look);
  add(corner, way, u, look);
  add(corner + u + v, way, -u, look);
}

void RoomBuilder::addDrum(const Stand& stand, const Drum& drum, const Look& wall, const Look& lid) {
  const float step = kTwoPi / static_cast<float>(drum.sides);
  const float side = 2.0F * drum.radius * std::tan(0.5F * step);
  for (int k = 0; k < drum.sides; ++k) {
    const Stand face{stand.foot, stand.yaw + step * static_cast<float>(k)};
    const Vec3f right = face.at(side, 0, 0) - face.foot;
    add(face.at(-0.5F * side, drum.height, -drum.radius),
        right,
        drum.height * Vec3f::UnitY(),
        wall);
  }
  Look round = lid;
  round.is_round = true;
  const float d = 2.0F * drum.radius;
  add(stand.at(-drum.radius, drum.height, drum.radius),
      stand.at(d, 0, 0) - stand.foot,
      stand.at(0, 0, -d) - stand.foot,
      round);
}

void RoomBuilder::addLeaf(const Vec3f& stalk,
                          const Vec3f& along,
                          const Vec3f& across,
                          const Look& look) {
  Look round = look;
  round.is_round = true;
  add(stalk - 0.5F * across, across, along, round);
  add(stalk + 0.5F * across, -across, along, round);
}

Scene RoomBuilder::finish(const RoomLight& light, std::uint64_t seed) const {
  const Curve reflectance = reflectanceCurve(), film = filmCurve();
  std::vector<ColorCanvas> canvases(surfaces_.size());
  std::vector<Reflector> reflectors(surfaces_.size());
  inParallel(surfaces_.size(), [&](std::size_t i) {
    Random random(mixBits(seed) + i);
    canvases[i] = canvasOf(surfaces_[i]);
    looks_[i].paint(&canvases[i], &random);
    forEachTexel(&canvases[i].color, [&](int, int, Vec3f* texel) { *texel = reflectance(*texel); });
    reflectors[i] = {meanOf(&canvases[i].color), looks_[i].glow > 0.0F};
  });
  const LitRoom lit(surfaces_, reflectors, light);
  Scene scene;
  scene.has_color = true;
  scene.surfaces = surfaces_;
  inParallel(surfaces_.size(), [&](std::size_t i) {
    const float texel_m = 1.0F / surfaces_[i].texels_per_m;
    forEachTexel(&canvases[i].color, [&](int x, int y, Vec3f* texel) {
      const Vec3f irradiance = looks_[i].glow > 0.0F
                                   ? Vec3f(Vec3f::Constant(looks_[i].glow))
                                   : lit.at(i,
                                            (static_cast<float>(x) + 0.5F) * texel_m,
                                            (static_cast<float>(y) + 0.5F) * texel_m);
      *texel = film(texel->cwiseProduct(irradiance));
    });
    scene.surfaces[i].texture = Texture(canvases[i].color);
    canvases[i] = {};
  });
  return scene;
}

}  // namespace glide::synthetic
