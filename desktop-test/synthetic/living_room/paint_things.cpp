#include "synthetic/living_room/painters.h"

#include <algorithm>
#include <array>
#include <cmath>

// Sizes are in metres: what such things look like, nothing is derived from them.
namespace glide::synthetic {

namespace {

constexpr float kTwoPi = 6.2831853F;

const std::array kCovers{hex(0x8E2F2A),
                         hex(0x27495E),
                         hex(0xD9C9A3),
                         hex(0x3C5B43),
                         hex(0xC7802F),
                         hex(0x4A3B5C),
                         hex(0xE3DFD4),
                         hex(0x1E2B33),
                         hex(0xA8553A),
                         hex(0x5D8A94),
                         hex(0xB7A04A),
                         hex(0x6B2338)};

/// Lines of letters that nobody can read, from the first line down.
void print(Pen* pen, const Rect& block, float line, Random* random) {
  for (float y = block.y; y + line < block.y + block.height; y += 1.7F * line) {
    for (float x = block.x; x < block.x + block.width;) {
      const float word = std::min(line * random->uniform(1.5F, 5.0F), block.x + block.width - x);
      pen->rect({x, y, word, 0.75F * line}, hex(0x3A3835));
      x += word + 0.8F * line;
    }
  }
}

void paintSpine(Pen* pen, const Rect& spine, Random* random) {
  const Rgb cover = pick(kCovers, random), print = pick(kCovers, random);
  pen->rect(spine, cover);
  pen->rect({spine.x, spine.y, 0.12F * spine.width, spine.height}, 0.7F * cover);
  pen->rect({spine.x + 0.85F * spine.width, spine.y, 0.15F * spine.width, spine.height},
            0.6F * cover);
  const float inset = 0.2F * spine.width, body = spine.width - 2.0F * inset;
  for (const float y : {0.06F, 0.9F})
    pen->rect({spine.x + inset, spine.y + y * spine.height, body, 0.012F}, print);
  const float begin = random->uniform(0.15F, 0.3F), end = random->uniform(0.5F, 0.8F);
  for (float y = begin; y < end; y += 0.045F) {
    pen->rect({spine.x + inset + random->uniform(0.0F, 0.2F) * body,
               spine.y + y * spine.height,
               random->uniform(0.5F, 0.8F) * body,
               0.026F * spine.height},
              print);
  }
}

}  // namespace

Painter bookSpines() {
  return [](ColorCanvas* canvas, Random* random) {
    fill(canvas, hex(0x15110E));
    Pen pen(canvas);
    for (float x = 0.0F; x < pen.width();) {
      const float w = std::min(random->uniform(0.018F, 0.045F), pen.width() - x);
      const float h = pen.height() * random->uniform(0.9F, 1.0F);
      if (w > 0.008F) paintSpine(&pen, {x, pen.height() - h, w - 0.001F, h}, random);
      x += w;
    }
    mottle(canvas, {0.03F, canvas->px(0.03F), 0.85F}, random);
  };
}

Painter bookCover() {
  return [](ColorCanvas* canvas, Random* random) {
    const Rgb cover = pick(kCovers, random), figure = pick(kCovers, random);
    fill(canvas, cover);
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    pen.rect({0.08F * w, 0.1F * h, 0.84F * w, 0.22F * h}, figure);
    print(&pen, {0.14F * w, 0.14F * h, 0.7F * w, 0.14F * h}, 0.03F * h, random);
    pen.oval({0.5F * w, 0.65F * h}, {0.3F * w, 0.2F * h}, figure);
    pen.oval({0.5F * w, 0.65F * h}, {0.16F * w, 0.11F * h}, mix(cover, figure, 0.3F));
    mottle(canvas, {0.02F, canvas->px(0.03F), 0.8F}, random);
  };
}

Painter bookPages() {
  return [](ColorCanvas* canvas, Random* random) {
    fill(canvas, hex(0xE9E0CA));
    Pen pen(canvas);
    for (float y = 0.0F; y < pen.height(); y += 0.004F)
      pen.rect({0.0F, y, pen.width(), 0.0015F}, random->uniform(0.7F, 0.95F) * hex(0xD8CCB0));
  };
}

Painter page() {
  return [](ColorCanvas* canvas, Random* random) {
    fill(canvas, hex(0xF4F1E8));
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    pen.rect({0.12F * w, 0.08F * h, 0.5F * w, 0.035F * h}, hex(0x23364A));
    print(&pen, {0.12F * w, 0.18F * h, 0.76F * w, 0.4F * h}, 0.014F * h, random);
    pen.rect({0.12F * w, 0.62F * h, 0.34F * w, 0.24F * h}, pick(kCovers, random));
    print(&pen, {0.52F * w, 0.62F * h, 0.36F * w, 0.26F * h}, 0.014F * h, random);
  };
}

Painter pointCloudScreen() {
  return [](ColorCanvas* canvas, Random* random) {
    fill(canvas, hex(0x15181D));
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    const Rect view{0.015F, 0.015F, w - 0.03F, h - 0.03F};
    pen.rect(view, hex(0x0E2233));
    pen.rect({view.x, view.y, 0.24F * view.width, view.height}, hex(0x1D2C3B));
    print(&pen,
          {view.x + 0.01F, view.y + 0.02F, 0.2F * view.width, 0.5F * view.height},
          0.01F,
          random);
    for (int k = 0; k < 700; ++k) {  // a room of points
      const float x = random->uniform(), y = random->uniform();
      const float lift = 0.2F * std::sin(6.0F * x) * (1.0F - y);
      pen.oval({view.x + (0.28F + 0.68F * x) * view.width,
                view.y + (0.25F + 0.6F * y + lift) * view.height},
               Vec2f::Constant(0.0016F),
               mix(hex(0x4FC3F7), hex(0xB9F6CA), x));
    }
    for (int k = 0; k < 26; ++k) {  // and a path through it
      const float angle = 0.2F * static_cast<float>(k);
      pen.oval({view.x + (0.62F + 0.2F * std::cos(angle)) * view.width,
                view.y + (0.55F + 0.16F * std::sin(angle)) * view.height},
               Vec2f::Constant(0.004F),
               k % 5 == 0 ? hex(0x2B6CFF) : hex(0xFF8C00));
    }
  };
}

Painter keyboard() {
  return [](ColorCanvas* canvas, Random*) {
    fill(canvas, hex(0x2C2D30));
    Pen pen(canvas);
    const float key = 0.019F;
    for (float y = 0.008F; y + key < pen.height(); y += key) {
      for (float x = 0.008F; x + key < pen.width(); x += key)
        pen.rect({x, y, 0.8F * key, 0.8F * key}, hex(0xC9CACC));
    }
  };
}

Painter clockFace() {
  return [](ColorCanvas* canvas, Random*) {
    fill(canvas, hex(0x2B2A28));
    Pen pen(canvas);
    const Vec2f center(0.5F * pen.width(), 0.5F * pen.height());
    const float r = 0.5F * pen.width();
    pen.oval(center, Vec2f::Constant(0.92F * r), hex(0xF5F1E6));
    const auto at = [&](float turn, float share) {
      const float angle = kTwoPi * (turn - 0.25F);
      return Vec2f(center + share * r * Vec2f(std::cos(angle), std::sin(angle)));
    };
    for (int k = 0; k < 60; ++k) {
      const float turn = static_cast<float>(k) / 60.0F;
      const bool is_hour = k % 5 == 0;
      pen.line(at(turn, is_hour ? 0.72F : 0.8F),
               at(turn, 0.86F),
               is_hour ? 0.009F : 0.003F,
               hex(0x2B2A28));
    }
    pen.line(at(0.2F, -0.12F), at(0.2F, 0.5F), 0.012F, hex(0x2B2A28));
    pen.line(at(0.9F, -0.15F), at(0.9F, 0.75F), 0.008F, hex(0x2B2A28));
    pen.oval(center, Vec2f::Constant(0.05F * r), hex(0xB03A2E));
  };
}

Painter corkBoard() {
  return [](ColorCanvas* canvas, Random* random) {
    constexpr float kPitch = 0.16F;
    fill(canvas, hex(0xB98A56));
    mottle(canvas, {0.1F, canvas->px(0.012F), 0.9F}, random);
    Pen pen(canvas);
    const std::array notes{
        hex(0xF6E27A), hex(0xF4F1E8), hex(0xF2A7A0), hex(0xA8D5E5), hex(0xBFE0A5)};
    for (float y = 0.03F; y + 0.12F < pen.height(); y += kPitch) {
      for (float x = 0.03F; x + 0.1F < pen.width(); x += 0.8F * kPitch) {
        const Rect note{x + random->uniform(0.0F, 0.015F),
                        y + random->uniform(0.0F, 0.02F),
                        random->uniform(0.075F, 0.11F),
                        random->uniform(0.08F, 0.12F)};
        pen.rect({note.x + 0.004F, note.y + 0.004F, note.width, note.height}, hex(0x7F5B35));
        pen.rect(note, pick(notes, random));
        print(&pen,
              {note.x + 0.01F, note.y + 0.02F, note.width - 0.02F, note.height - 0.03F},
              0.006F,
              random);
        pen.oval({note.x + 0.5F * note.width, note.y + 0.008F}, {0.006F, 0.006F}, hex(0xC0392B));
      }
    }
    for (const Rect& side : {Rect{0, 0, 0.02F, pen.height()},
                             Rect{pen.width() - 0.02F, 0, 0.02F, pen.height()},
                             Rect{0, 0, pen.width(), 0.02F},
                             Rect{0, pen.height() - 0.02F, pen.width(), 0.02F}})
      pen.rect(side, hex(0x6B4A2C));
  };
}

Painter lampshade(const Rgb& glow) {
  return [glow](ColorCanvas* canvas, Random* random) {
    fillDown(canvas, canvas->whole(), glow, 0.86F * glow);
    Pen pen(canvas);
    for (const float y : {0.0F, pen.height() - 0.012F})
      pen.rect({0.0F, y, pen.width(), 0.012F}, 0.55F * glow);
    for (float x = 0.0F; x < pen.width(); x += 0.022F)
      pen.rect({x, 0.012F, 0.004F, pen.height() - 0.024F}, 0.9F * glow);
    mottle(canvas, {0.015F, canvas->px(0.02F), 0.9F}, random);
  };
}

Painter leaf(const Rgb& green) {
  return [green](ColorCanvas* canvas, Random* random) {
    fill(canvas, random->uniform(0.8F, 1.15F) * green);
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    for (float y = 0.1F * h; y < h; y += 0.12F * h) {
      pen.line({0.5F * w, y}, {0.0F, y - 0.16F * h}, 0.002F, 1.25F * green);
      pen.line({0.5F * w, y}, {w, y - 0.16F * h}, 0.002F, 1.25F * green);
    }
    pen.rect({0.48F * w, 0.0F, 0.04F * w, h}, 1.35F * green);
  };
}

Painter soil() {
  return [](ColorCanvas* canvas, Random* random) {
    fill(canvas, hex(0x3B2A1E));
    mottle(canvas, {0.3F, canvas->px(0.02F), 0.95F}, random);
  };
}

Painter magazine() {
  return [](ColorCanvas* canvas, Random* random) {
    const Rgb cover = pick(kCovers, random);
    fill(canvas, cover);
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    pen.rect({0.06F * w, 0.05F * h, 0.88F * w, 0.14F * h}, hex(0xF2EEE2));
    pen.rect({0.1F * w, 0.075F * h, 0.6F * w, 0.09F * h}, hex(0xB4302A));
    for (int k = 0; k < 12; ++k) {
      pen.oval({random->uniform(0.15F, 0.85F) * w, random->uniform(0.35F, 0.85F) * h},
               Vec2f::Constant(random->uniform(0.03F, 0.12F) * w),
               pick(kCovers, random));
    }
    print(&pen, {0.1F * w, 0.88F * h, 0.5F * w, 0.09F * h}, 0.02F * h, random);
  };
}

Painter loudspeaker() {
  return [](ColorCanvas* canvas, Random* random) {
    fill(canvas, hex(0x4A3527));
    Pen pen(canvas);
    const float w = pen.width(), h = pen.height();
    const auto cone = [&](float y, float r) {
      const Vec2f center(0.5F * w, y);
      pen.oval(center, Vec2f::Constant(r), hex(0x1B1B1C));
      pen.oval(center, Vec2f::Constant(0.85F * r), hex(0x3A3A3C));
      pen.oval(center, Vec2f::Constant(0.75F * r), hex(0x232325));
      pen.oval(center, Vec2f::Constant(0.3F * r), hex(0x6E6E70));
    };
    cone(0.24F * h, 0.2F * w);
    cone(0.65F * h, 0.36F * w);
    mottle(canvas, {0.03F, canvas->px(0.05F), 0.85F}, random);
  };
}

Painter record() {
  return [](ColorCanvas* canvas, Random*) {
    fill(canvas, hex(0xB9B4A8));
    Pen pen(canvas);
    const Vec2f center(0.42F * pen.width(), 0.5F * pen.height());
    const float r = 0.42F * pen.height();
    for (int k = 0; k < 9; ++k)
      pen.oval(center,
               Vec2f::Constant(r * (1.0F - 0.07F * static_cast<float>(k))),
               k % 2 == 0 ? hex(0x161616) : hex(0x2A2A2A));
    pen.oval(center, Vec2f::Constant(0.34F * r), hex(0xC8452F));
    pen.oval(center, Vec2f::Constant(0.04F * r), hex(0xD8D8D8));
    pen.line({0.88F * pen.width(), 0.15F * pen.height()},
             {0.6F * pen.width(), 0.6F * pen.height()},
             0.012F,
             hex(0x54514C));
  };
}

}  // namespace glide::synthetic
