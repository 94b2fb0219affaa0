#include "synthetic/living_room/painters.h"

#include <array>
#include <cmath>
#include <utility>

// Sizes are in metres: what such things look like, nothing is derived from them.
namespace glide::synthetic {

namespace {

constexpr float kTwoPi = 6.2831853F;

/// A part of a canvas that is drawn on in shares of its own size.
class Field {
 public:
  Field(ColorCanvas* canvas, const Rect& rect) : pen_(canvas), canvas_(canvas), rect_(rect) {}

  Vec2f at(float x, float y) const {
    return {rect_.x + x * rect_.width, rect_.y + y * rect_.height};
  }
  float size() const { return std::min(rect_.width, rect_.height); }
  Pen& pen() { return pen_; }

  void sky(const Rgb& top, const Rgb& bottom) {
    const float k = canvas_->texels_per_m;
    fillDown(canvas_, {k * rect_.x, k * rect_.y, k * rect_.width, k * rect_.height}, top, bottom);
  }
  /// From a skyline y(x) down to the lower edge; shares of the field.
  template <class Skyline>
  void hills(const Skyline& skyline, const Rgb& color) {
    const float k = canvas_->texels_per_m, step = 1.0F / k;
    for (float x = 0.0F; x < rect_.width; x += step) {
      const float y = skyline(x / rect_.width);
      pen_.rect({rect_.x + x, rect_.y + y * rect_.height, step, (1.0F - y) * rect_.height}, color);
    }
  }
  void rect(const Rect& shares, const Rgb& color) {
    const Vec2f corner = at(shares.x, shares.y);
    pen_.rect({corner.x(), corner.y(), shares.width * rect_.width, shares.height * rect_.height},
              color);
  }

 private:
  Pen pen_;
  ColorCanvas* canvas_;
  Rect rect_;
};

using PaintField = std::function<void(Field*, Random*)>;

Painter framed(const Rgb& frame, PaintField paint_field) {
  return [frame, paint = std::move(paint_field)](ColorCanvas* canvas, Random* random) {
    constexpr float kFrame = 0.022F, kMount = 0.045F;
    fill(canvas, frame);
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    pen.rect({0.004F, 0.004F, w - 0.008F, h - 0.008F}, 0.8F * frame);
    pen.rect({kFrame, kFrame, w - 2 * kFrame, h - 2 * kFrame}, hex(0xF3EFE6));
    const float edge = kFrame + kMount;
    Field field(canvas, {edge, edge, w - 2 * edge, h - 2 * edge});
    paint(&field, random);
    // What ran over the picture's edges.
    for (const Rect& side : {Rect{kFrame, kFrame, kMount, h - 2 * kFrame},
                             Rect{w - edge, kFrame, kMount, h - 2 * kFrame},
                             Rect{kFrame, kFrame, w - 2 * kFrame, kMount},
                             Rect{kFrame, h - edge, w - 2 * kFrame, kMount}})
      pen.rect(side, hex(0xF3EFE6));
    for (const Rect& side : {Rect{0, 0, kFrame, h},
                             Rect{w - kFrame, 0, kFrame, h},
                             Rect{0, 0, w, kFrame},
                             Rect{0, h - kFrame, w, kFrame}})
      pen.rect(side, frame);
    mottle(canvas, {0.02F, canvas->px(0.03F), 0.85F}, random);
  };
}

/// A sum of three waves between about -1 and 1.
struct Waves {
  std::array<float, 3> phases, rates;

  explicit Waves(Random* random) {
    for (std::size_t i = 0; i < 3; ++i) {
      phases[i] = random->uniform(0.0F, kTwoPi);
      rates[i] = random->uniform(3.0F, 5.0F) * std::pow(2.3F, static_cast<float>(i));
    }
  }
  float operator()(float x) const {
    return 0.55F * std::sin(rates[0] * x + phases[0]) + 0.3F * std::sin(rates[1] * x + phases[1]) +
           0.15F * std::sin(rates[2] * x + phases[2]);
  }
};

void paintMountains(Field* field, Random* random) {
  field->sky(hex(0xF2A65E), hex(0xFBE3B5));
  field->pen().oval(field->at(random->uniform(0.25F, 0.75F), 0.33F),
                    Vec2f::Constant(0.11F * field->size()),
                    hex(0xFFF4D6));
  const std::array colors{
      hex(0xC98D7B), hex(0x94697A), hex(0x5E5575), hex(0x37476B), hex(0x1D2F45)};
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const Waves waves(random);
    const float base = 0.42F + 0.12F * static_cast<float>(i);
    field->hills([&](float x) { return base + 0.09F * waves(x); }, colors[i]);
  }
  for (int i = 0; i < 14; ++i) {  // firs
    const float x = random->uniform(), size = random->uniform(0.03F, 0.07F) * field->size();
    field->pen().triangle(
        field->at(x, random->uniform(0.84F, 0.96F)), {0.45F * size, 1.4F * size}, hex(0x0F1E2B));
  }
}

void paintForms(Field* field, Random* random) {
  const std::array colors{
      hex(0xD1432F), hex(0xE9B23C), hex(0x2B5D8A), hex(0x23302F), hex(0x6FA08B), hex(0xE6805A)};
  field->rect({0, 0, 1, 1}, hex(0xEFE4CF));
  for (int i = 0; i < 16; ++i) {
    const Rgb color = pick(colors, random);
    const Vec2f center = field->at(random->uniform(0.1F, 0.9F), random->uniform(0.1F, 0.9F));
    const float size = random->uniform(0.06F, 0.22F) * field->size();
    switch (random->below(4)) {
      case 0:
        field->pen().oval(center, Vec2f::Constant(size), color);
        field->pen().oval(center, Vec2f::Constant(0.55F * size), pick(colors, random));
        break;
      case 1:
        field->pen().triangle(center, {size, size}, color);
        break;
      case 2:
        field->pen().rect({center.x() - size, center.y() - 0.4F * size, 2 * size, 0.8F * size},
                          color);
        break;
      default: {
        const float angle = random->uniform(0.0F, kTwoPi);
        const Vec2f way = 2.2F * size * Vec2f(std::cos(angle), std::sin(angle));
        field->pen().line(center - way, center + way, 0.012F, hex(0x23302F));
      }
    }
  }
}

void paintPlant(Field* field, Random* random) {
  field->rect({0, 0, 1, 1}, hex(0xF6F1E3));
  const std::array greens{hex(0x2F5D43), hex(0x4C7A52), hex(0x7C9A5E), hex(0x254A3D)};
  for (int stem = 0; stem < 3; ++stem) {
    const float x0 = 0.5F + 0.05F * static_cast<float>(stem - 1);
    const float x1 = 0.5F + random->uniform(0.15F, 0.3F) * static_cast<float>(stem - 1);
    const Vec2f root = field->at(x0, 0.95F), tip = field->at(x1, 0.12F + 0.05F * (stem == 1));
    field->pen().line(root, tip, 0.006F, greens[3]);
    for (int k = 1; k < 9; ++k) {
      const Vec2f stalk = root + 0.115F * static_cast<float>(k) * (tip - root);
      const float reach = (0.26F - 0.02F * static_cast<float>(k)) * field->size();
      for (const float side : {-1.0F, 1.0F}) {
        field->pen().petal(stalk,
                           stalk + Vec2f(side * reach, -random->uniform(0.3F, 0.8F) * reach),
                           0.3F * reach,
                           pick(greens, random));
      }
    }
  }
}

void paintCity(Field* field, Random* random) {
  field->sky(hex(0x141B3C), hex(0x5A3A66));
  for (int i = 0; i < 60; ++i)
    field->pen().oval(field->at(random->uniform(), random->uniform(0.0F, 0.5F)),
                      Vec2f::Constant(random->uniform(0.001F, 0.0025F)),
                      hex(0xF5F0DC));
  field->pen().oval(field->at(0.78F, 0.2F), Vec2f::Constant(0.07F * field->size()), hex(0xF4E9C2));
  for (float x = 0.0F; x < 1.0F;) {
    const float w = random->uniform(0.07F, 0.15F), top = random->uniform(0.3F, 0.7F);
    field->rect({x, top, w, 1.0F - top}, mix(hex(0x0C1224), hex(0x26305A), random->uniform()));
    for (float y = top + 0.03F; y < 0.95F; y += 0.05F) {
      for (float wx = x + 0.012F; wx < x + w - 0.02F; wx += 0.028F) {
        if (random->uniform() < 0.55F)
          field->rect({wx, y, 0.016F, 0.026F},
                      mix(hex(0xFFCF70), hex(0xFFF3C4), random->uniform()));
      }
    }
    x += w;
  }
}

void paintFruit(Field* field, Random* random) {
  field->sky(hex(0x31474A), hex(0x587571));
  field->rect({0.0F, 0.68F, 1.0F, 0.32F}, hex(0x7B4A2B));
  field->rect({0.0F, 0.68F, 1.0F, 0.03F}, hex(0xA56A3D));
  const float s = field->size();
  field->pen().oval(field->at(0.3F, 0.55F), {0.11F * s, 0.2F * s}, hex(0x24506B));
  field->pen().oval(field->at(0.27F, 0.5F), {0.02F * s, 0.1F * s}, hex(0x8FB6C6));
  for (int k = 0; k < 7; ++k) {
    const float angle = -0.5F + 0.17F * static_cast<float>(k) - 1.2F;
    const Vec2f neck = field->at(0.3F, 0.38F);
    const Vec2f flower = neck + 0.3F * s * Vec2f(std::cos(angle), std::sin(angle));
    field->pen().line(neck, flower, 0.005F, hex(0x3F6B45));
    field->pen().oval(flower, Vec2f::Constant(0.05F * s), hex(0xE7C34B));
    field->pen().oval(flower, Vec2f::Constant(0.022F * s), hex(0x7A4520));
  }
  for (int k = 0; k < 5; ++k) {
    const Vec2f center =
        field->at(0.52F + 0.09F * static_cast<float>(k), k % 2 == 0 ? 0.74F : 0.68F);
    const float r = random->uniform(0.065F, 0.085F) * s;
    const Rgb color = k % 2 == 0 ? hex(0xC8402D) : hex(0xE08B2D);
    field->pen().oval(center, {r, r}, 0.75F * color);
    field->pen().oval(center - Vec2f(0.15F * r, 0.2F * r), {0.75F * r, 0.7F * r}, color);
    field->pen().oval(center - Vec2f(0.35F * r, 0.4F * r), {0.18F * r, 0.14F * r}, hex(0xFBE6CF));
  }
}

/// A crown of many leaves.
void paintTree(Field* field, const Vec2f& foot, float height, Random* random) {
  const std::array greens{hex(0x4F7F3A), hex(0x6F9E46), hex(0x3C6A35), hex(0x8DB356)};
  field->pen().line(foot, foot - Vec2f(0.0F, 0.6F * height), 0.05F * height, hex(0x5B4632));
  for (int k = 0; k < 150; ++k) {
    const float angle = random->uniform(0.0F, kTwoPi), r = std::sqrt(random->uniform());
    const Vec2f leaf(0.32F * r * std::cos(angle), 0.3F * r * std::sin(angle) - 0.72F);
    field->pen().oval(foot + height * leaf,
                      height * random->uniform(0.02F, 0.06F) * Vec2f(1.0F, 0.8F),
                      pick(greens, random));
  }
}

void paintGarden(Field* field, Random* random) {
  field->sky(hex(0x9CC7EE), hex(0xEAF4FB));
  for (int k = 0; k < 40; ++k) {  // clouds
    const float x = 0.1F + 0.2F * static_cast<float>(k % 5) + random->uniform(-0.07F, 0.07F);
    field->pen().oval(field->at(x, 0.2F + 0.03F * static_cast<float>(k % 4)),
                      {random->uniform(0.2F, 0.5F), random->uniform(0.06F, 0.15F)},
                      mix(hex(0xFFFFFF), hex(0xE3EDF5), random->uniform()));
  }
  for (const auto& [base, color] : {std::pair(0.5F, hex(0x8FB0A8)),
                                    std::pair(0.55F, hex(0x7CA06D)),
                                    std::pair(0.62F, hex(0x8DB35A))}) {
    const Waves waves(random);
    field->hills([&, base = base](float x) { return base + 0.03F * waves(x); }, color);
  }
  for (const float x : {0.08F, 0.24F, 0.41F, 0.55F, 0.7F, 0.83F, 0.95F})
    paintTree(
        field, field->at(x, random->uniform(0.66F, 0.8F)), random->uniform(1.5F, 3.2F), random);
  for (float x = 0.0F; x < 1.0F; x += 0.012F)  // a fence
    field->rect({x, 0.8F, 0.007F, 0.09F}, hex(0xF5F2EA));
  field->rect({0.0F, 0.825F, 1.0F, 0.008F}, hex(0xF5F2EA));
}

}  // namespace

Painter mountains(const Rgb& frame) { return framed(frame, paintMountains); }
Painter abstractForms(const Rgb& frame) { return framed(frame, paintForms); }
Painter botanical(const Rgb& frame) { return framed(frame, paintPlant); }
Painter cityAtNight(const Rgb& frame) { return framed(frame, paintCity); }
Painter stillLife(const Rgb& frame) { return framed(frame, paintFruit); }

Painter gardenView() {
  return [](ColorCanvas* canvas, Random* random) {
    const Pen pen(canvas);
    Field field(canvas, {0.0F, 0.0F, pen.width(), pen.height()});
    paintGarden(&field, random);
    mottle(canvas, {0.03F, canvas->px(0.2F), 0.8F}, random);
  };
}

}  // namespace glide::synthetic
