#include "synthetic/living_room/painters.h"

#include <algorithm>
#include <cmath>

// Sizes are in metres: what such things look like, nothing is derived from them.
namespace glide::synthetic {

namespace {

/// Noise that is drawn out along one axis of the canvas: -1..1, about.
Canvas streaks(const ColorCanvas& canvas, bool is_along_rows, Random* random) {
  constexpr int kStretch = 24;
  const int w = canvas.width(), h = canvas.height();
  Canvas noise;
  noise.albedo.resize(is_along_rows ? w / kStretch + 2 : w, is_along_rows ? h : h / kStretch + 2);
  fill(&noise, 0.0F);
  addNoise(&noise, {0.45F, canvas.px(0.06F), 0.8F}, random);
  Canvas drawn;
  drawn.albedo.resize(w, h);
  for (int y = 0; y < h; ++y) {
    for (int x = 0; x < w; ++x) {
      const int cell = (is_along_rows ? x : y) / kStretch;
      const float share = static_cast<float>((is_along_rows ? x : y) % kStretch) / kStretch;
      const ImageF& n = noise.albedo;
      const float a = is_along_rows ? n.row(y)[cell] : n.row(cell)[x];
      const float b = is_along_rows ? n.row(y)[cell + 1] : n.row(cell + 1)[x];
      drawn.albedo.row(y)[x] = a + share * (b - a);
    }
  }
  return drawn;
}

void addGrain(ColorCanvas* canvas, const Wood& tones, Random* random) {
  const bool is_along_rows = canvas->width() >= canvas->height();
  const Canvas grain = streaks(*canvas, is_along_rows, random);
  for (int y = 0; y < canvas->height(); ++y) {
    for (int x = 0; x < canvas->width(); ++x) {
      const float share = std::clamp(0.5F + 0.55F * grain.albedo.row(y)[x], 0.0F, 1.0F);
      canvas->color.row(y)[x] = mix(tones.light, tones.dark, share);
    }
  }
}

void addKnots(ColorCanvas* canvas, const Wood& tones, Random* random) {
  constexpr float kPerSquareMetre = 2.5F;
  Pen pen(canvas);
  const bool is_along_rows = canvas->width() >= canvas->height();
  const int count = static_cast<int>(kPerSquareMetre * pen.width() * pen.height());
  for (int i = 0; i < count; ++i) {
    const Vec2f center(random->uniform() * pen.width(), random->uniform() * pen.height());
    for (const float size : {0.014F, 0.009F, 0.004F}) {
      const Vec2f radii(is_along_rows ? 1.7F * size : size, is_along_rows ? size : 1.7F * size);
      pen.oval(center, radii, mix(tones.dark, tones.light, size / 0.02F) * 0.8F);
    }
  }
}

}  // namespace

Painter plain(const Rgb& color) {
  return [color](ColorCanvas* canvas, Random* random) {
    fill(canvas, color);
    mottle(canvas, {0.02F, canvas->px(0.15F), 0.8F}, random);
  };
}

Painter plaster(const Rgb& color) {
  return [color](ColorCanvas* canvas, Random* random) {
    fill(canvas, color);
    mottle(canvas, {0.018F, canvas->px(0.6F), 0.78F}, random);
  };
}

Painter wallpaper(const Rgb& ground, const Rgb& twig) {
  return [ground, twig](ColorCanvas* canvas, Random* random) {
    constexpr float kColumn = 0.17F, kRow = 0.24F;
    fill(canvas, ground);
    Pen pen(canvas);
    int column = 0;
    for (float x = 0.5F * kColumn; x < pen.width(); x += kColumn, ++column) {
      for (float y = column % 2 == 0 ? 0.0F : 0.5F * kRow; y < pen.height() + kRow; y += kRow) {
        const float lean = column % 2 == 0 ? 0.02F : -0.02F;
        pen.line({x - lean, y}, {x + lean, y - 0.9F * kRow}, 0.005F, twig);
        for (int k = 0; k < 4; ++k) {
          const Vec2f stalk(x - lean + 0.5F * lean * static_cast<float>(k),
                            y - 0.2F * kRow * static_cast<float>(k));
          const float side = k % 2 == 0 ? 1.0F : -1.0F;
          const Vec2f tip = stalk + Vec2f(side * 0.055F, -0.035F - random->uniform(0.0F, 0.01F));
          pen.petal(stalk, tip, 0.022F, mix(twig, ground, random->uniform(0.0F, 0.35F)));
        }
      }
    }
    mottle(canvas, {0.02F, canvas->px(0.4F), 0.8F}, random);
  };
}

Painter wood(const Wood& tones) {
  return [tones](ColorCanvas* canvas, Random* random) {
    addGrain(canvas, tones, random);
    addKnots(canvas, tones, random);
    mottle(canvas, {0.03F, canvas->px(0.3F), 0.75F}, random);
  };
}

Painter planks(const Wood& tones) {
  return [tones](ColorCanvas* canvas, Random* random) {
    constexpr float kBoard = 0.13F;
    addGrain(canvas, tones, random);
    addKnots(canvas, tones, random);
    const Rgb gap = 0.35F * tones.dark;
    const float board = canvas->px(kBoard), width = static_cast<float>(canvas->width());
    for (float y = 0.0F; y < static_cast<float>(canvas->height()); y += board) {
      for (float x = -canvas->px(random->uniform(0.0F, 1.2F)); x < width;) {
        const float length = canvas->px(random->uniform(0.7F, 1.7F));
        tint(canvas, {x, y, length, board}, random->uniform(0.78F, 1.08F) * Rgb(1.0F, 1.0F, 0.99F));
        drawRect(canvas, {x, y, 1.6F, board}, gap);
        x += length;
      }
      drawRect(canvas, {0.0F, y, width, 1.6F}, gap);
    }
    mottle(canvas, {0.025F, canvas->px(0.8F), 0.75F}, random);
  };
}

Painter paintedBricks(const Rgb& color) {
  return [color](ColorCanvas* canvas, Random* random) {
    constexpr float kLength = 0.21F, kHeight = 0.065F, kJoint = 0.01F;
    fill(canvas, 0.72F * color);
    Pen pen(canvas);
    int row = 0;
    for (float y = 0.0F; y < pen.height(); y += kHeight + kJoint, ++row) {
      for (float x = row % 2 == 0 ? 0.0F : -0.5F * kLength; x < pen.width(); x += kLength + kJoint)
        pen.rect({x, y, kLength, kHeight}, random->uniform(0.86F, 1.04F) * color);
    }
    mottle(canvas, {0.04F, canvas->px(0.1F), 0.85F}, random);
  };
}

Painter panelDoor(const Rgb& color) {
  return [color](ColorCanvas* canvas, Random* random) {
    fill(canvas, color);
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    for (const float x : {0.1F * w, 0.54F * w}) {
      for (const Vec2f& span : {Vec2f(0.06F, 0.4F), Vec2f(0.53F, 0.4F)}) {
        const Rect panel{x, span.x() * h, 0.36F * w, span.y() * h};
        pen.rect(panel, 0.7F * color);
        pen.rect({panel.x + 0.012F, panel.y + 0.012F, panel.width - 0.018F, panel.height - 0.018F},
                 1.06F * color);
        pen.rect({panel.x + 0.04F, panel.y + 0.04F, panel.width - 0.08F, panel.height - 0.08F},
                 0.9F * color);
      }
    }
    pen.oval({0.93F * w, 0.52F * h}, {0.025F, 0.05F}, hex(0x8A7340));
    pen.oval({0.93F * w, 0.5F * h}, {0.014F, 0.014F}, hex(0xD9BC6B));
    mottle(canvas, {0.015F, canvas->px(0.3F), 0.8F}, random);
  };
}

Painter radiator() {
  return [](ColorCanvas* canvas, Random* random) {
    constexpr float kRib = 0.06F;
    fill(canvas, hex(0xE6E4DE));
    Pen pen(canvas);
    for (float x = 0.0F; x < pen.width(); x += kRib) {
      pen.rect({x, 0.03F, 0.018F, pen.height() - 0.06F}, hex(0x8E8B84));
      pen.rect({x + 0.02F, 0.03F, 0.008F, pen.height() - 0.06F}, hex(0xF7F5EF));
    }
    mottle(canvas, {0.01F, canvas->px(0.2F), 0.8F}, random);
  };
}

Painter ceramic(const Rgb& ground, const Rgb& band) {
  return [ground, band](ColorCanvas* canvas, Random* random) {
    fill(canvas, ground);
    Pen pen(canvas);
    const float h = pen.height();
    pen.rect({0.0F, 0.22F * h, pen.width(), 0.1F * h}, band);
    pen.rect({0.0F, 0.38F * h, pen.width(), 0.03F * h}, band);
    pen.rect({0.0F, 0.75F * h, pen.width(), 0.05F * h}, 0.8F * band);
    mottle(canvas, {0.03F, canvas->px(0.05F), 0.8F}, random);
  };
}

}  // namespace glide::synthetic
