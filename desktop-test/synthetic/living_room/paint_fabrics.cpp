#include "synthetic/living_room/painters.h"

#include <algorithm>
#include <array>
#include <cmath>

// Sizes are in metres: what such things look like, nothing is derived from them.
namespace glide::synthetic {

namespace {

constexpr float kTwoPi = 6.2831853F;

/// The unevenness of cloth.
void wear(ColorCanvas* canvas, Random* random) {
  mottle(canvas, {0.035F, canvas->px(0.03F), 0.9F}, random);
  mottle(canvas, {0.02F, canvas->px(0.4F), 0.6F}, random);
}

void lozenge(ColorCanvas* canvas, const Vec2f& center, float half, const Rgb& color) {
  const float k = canvas->texels_per_m;
  Shape shape = shapeAt(ShapeKind::rectangle, k * center, k * Vec2f(half, half));
  shape.angle = 0.125F * kTwoPi;
  draw(canvas, shape, color);
}

}  // namespace

Painter weave(const Rgb& warp, const Rgb& weft) {
  return [warp, weft](ColorCanvas* canvas, Random* random) {
    constexpr float kThread = 0.012F;
    const int cell = std::max(2, static_cast<int>(canvas->px(kThread)));
    for (int y = 0; y < canvas->height(); ++y) {
      for (int x = 0; x < canvas->width(); ++x) {
        const bool is_warp = ((x + y) / cell + (x - y + (1 << 16)) / cell) % 2 == 0;
        canvas->color.row(y)[x] = is_warp ? warp : weft;
      }
    }
    wear(canvas, random);
  };
}

Painter zigzag(const Rgb& ground, const Rgb& line) {
  return [ground, line](ColorCanvas* canvas, Random* random) {
    constexpr float kStep = 0.05F, kPitch = 0.075F;
    fill(canvas, ground);
    Pen pen(canvas);
    for (float y = 0.0F; y < pen.height() + kPitch; y += kPitch) {
      int k = 0;
      for (float x = -kStep; x < pen.width() + kStep; x += kStep, ++k) {
        const float from = k % 2 == 0 ? 0.0F : kStep, to = kStep - from;
        pen.line({x, y - from}, {x + kStep, y - to}, 0.014F, line);
      }
    }
    wear(canvas, random);
  };
}

Painter dots(const Rgb& ground, const Rgb& dot) {
  return [ground, dot](ColorCanvas* canvas, Random* random) {
    constexpr float kPitch = 0.07F;
    fill(canvas, ground);
    Pen pen(canvas);
    int row = 0;
    for (float y = 0.5F * kPitch; y < pen.height(); y += kPitch, ++row) {
      for (float x = row % 2 == 0 ? 0.5F * kPitch : kPitch; x < pen.width(); x += kPitch)
        pen.oval({x, y}, Vec2f::Constant(0.013F + random->uniform(0.0F, 0.006F)), dot);
    }
    wear(canvas, random);
  };
}

Painter stripes(const Rgb& ground, const Rgb& stripe) {
  return [ground, stripe](ColorCanvas* canvas, Random* random) {
    constexpr float kPitch = 0.085F;
    fill(canvas, ground);
    Pen pen(canvas);
    for (float x = 0.3F * kPitch; x < pen.width(); x += kPitch) {
      pen.rect({x, 0.0F, 0.03F, pen.height()}, stripe);
      pen.rect({x + 0.04F, 0.0F, 0.006F, pen.height()}, 0.7F * stripe);
    }
    wear(canvas, random);
  };
}

namespace {

const std::array kKilim{
    hex(0xA63A2B), hex(0x1F3F5B), hex(0xE3D2A8), hex(0xC98A2E), hex(0x3E6B5A), hex(0x5B2333)};

/// A row of triangles along each long side.
void fringeOfTriangles(Pen* pen, float inset, float size, const Rgb& color) {
  for (float x = inset + size; x < pen->width() - inset; x += 2.0F * size) {
    pen->triangle({x, inset + size}, {size, size}, color);
    pen->triangle({x, pen->height() - inset - size}, {size, size}, color);
  }
}

void lozenges(ColorCanvas* canvas, Random* random) {
  constexpr float kPitch = 0.34F;
  const Pen pen(canvas);
  int row = 0;
  for (float y = 0.42F; y < pen.height() - 0.3F; y += 0.5F * kPitch, ++row) {
    for (float x = row % 2 == 0 ? 0.45F : 0.45F + 0.5F * kPitch; x < pen.width() - 0.35F;
         x += kPitch) {
      const int first = random->below(static_cast<int>(kKilim.size()));
      float half = 0.085F;
      for (int ring = 0; ring < 4; ++ring, half -= 0.022F) {
        const auto index = static_cast<std::size_t>(first + 2 * ring + ring / 2) % kKilim.size();
        lozenge(canvas, {x, y}, half, kKilim[index]);
      }
    }
  }
}

}  // namespace

Painter rug() {
  return [](ColorCanvas* canvas, Random* random) {
    fill(canvas, kKilim[2]);
    Pen pen(canvas);
    const std::array<float, 5> insets{0.03F, 0.08F, 0.1F, 0.24F, 0.27F};
    const std::array<int, 5> colors{1, 2, 0, 2, 5};
    for (std::size_t i = 0; i < insets.size(); ++i) {
      const float inset = insets[i];
      pen.rect({inset, inset, pen.width() - 2 * inset, pen.height() - 2 * inset},
               kKilim[static_cast<std::size_t>(colors[i])]);
      if (i == 2) fringeOfTriangles(&pen, inset + 0.01F, 0.055F, kKilim[3]);
    }
    lozenges(canvas, random);
    wear(canvas, random);
    mottle(canvas, {0.09F, canvas->px(0.03F), 0.9F}, random);
  };
}

Painter curtain(const Rgb& cloth, const Rgb& stripe) {
  return [cloth, stripe](ColorCanvas* canvas, Random* random) {
    constexpr float kBand = 0.3F;
    fill(canvas, cloth);
    Pen pen(canvas);
    for (float y = 0.1F; y < pen.height(); y += kBand) {
      pen.rect({0.0F, y, pen.width(), 0.05F}, stripe);
      pen.rect({0.0F, y + 0.065F, pen.width(), 0.012F}, 0.75F * stripe);
    }
    wear(canvas, random);
  };
}

Painter wicker(const Rgb& color) {
  return [color](ColorCanvas* canvas, Random* random) {
    constexpr float kReed = 0.02F;
    fill(canvas, 0.45F * color);
    Pen pen(canvas);
    int row = 0;
    for (float y = 0.0F; y < pen.height(); y += kReed, ++row) {
      for (float x = row % 2 == 0 ? 0.0F : -0.025F; x < pen.width(); x += 0.05F) {
        pen.petal({x, y + 0.5F * kReed},
                  {x + 0.045F, y + 0.5F * kReed},
                  0.9F * kReed,
                  random->uniform(0.8F, 1.15F) * color);
      }
    }
  };
}

}  // namespace glide::synthetic
