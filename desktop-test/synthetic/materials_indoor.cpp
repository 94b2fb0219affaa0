#include "synthetic/materials_internal.h"

#include <algorithm>

// Sizes are in metres, reflectances in 0..1: what such things look like, nothing is derived from
// them.
namespace glide::synthetic {

void paintPicture(Canvas* canvas, const Rect& rect, Random* random) {
  const float frame = std::min(canvas->px(0.025F), 0.1F * std::min(rect.width, rect.height));
  drawRect(canvas, rect, random->uniform(0.05F, 0.25F));
  const Rect inner{rect.x + frame, rect.y + frame, rect.width - 2 * frame, rect.height - 2 * frame};
  drawRect(canvas, inner, random->uniform(0.4F, 0.8F));
  const float size = std::min(inner.width, inner.height);
  Strewing figures{inner, std::max(3.0F, canvas->px(0.012F)), 0.4F * size, 0.35F};
  // Figures are placed by their centre: keep those inside of the frame.
  const float margin = 0.2F * size;
  figures.region = {
      inner.x + margin, inner.y + margin, inner.width - 2 * margin, inner.height - 2 * margin};
  strew(canvas, figures, random);
}

void paintPage(Canvas* canvas, const Rect& rect, Random* random) {
  drawRect(canvas, rect, random->uniform(0.75F, 0.92F));
  const float line = std::max(4.0F, 0.035F * rect.height);
  const float left = rect.x + 0.1F * rect.width, right = rect.x + 0.9F * rect.width;
  drawRect(
      canvas, {left, rect.y + line, random->uniform(0.3F, 0.7F) * rect.width, 1.2F * line}, 0.1F);
  for (float y = rect.y + 4.0F * line; y < rect.y + rect.height - 2.0F * line; y += line) {
    const bool is_gap = random->uniform() < 0.12F;
    for (float x = left; !is_gap && x < right;) {
      const float word = std::min(line * random->uniform(0.5F, 3.0F), right - x);
      drawRect(canvas, {x, y, word, 0.45F * line}, random->uniform(0.05F, 0.35F));
      x += word + line * random->uniform(0.3F, 0.6F);
    }
  }
}

namespace {

/// Notes and pictures at random places of a grid, so that they never overlap.
void hangPictures(Canvas* canvas, Random* random) {
  const float cell = canvas->px(0.75F);
  for (float y = canvas->px(0.3F); y + cell < static_cast<float>(canvas->height()); y += cell) {
    for (float x = canvas->px(0.15F); x + cell < static_cast<float>(canvas->width()); x += cell) {
      const float w = cell * random->uniform(0.35F, 0.8F), h = cell * random->uniform(0.35F, 0.8F);
      const Rect rect{x + (cell - w) * random->uniform(), y + (cell - h) * random->uniform(), w, h};
      const float what = random->uniform();
      if (what < 0.6F) paintPicture(canvas, rect, random);
      if (what > 0.8F)
        paintPage(canvas, {rect.x, rect.y, canvas->px(0.21F), canvas->px(0.3F)}, random);
    }
  }
}

/// Long streaks along the first axis.
void addGrain(Canvas* canvas, const Rect& rect, Random* random) {
  const int streaks = static_cast<int>(rect.height / std::max(1.0F, canvas->px(0.012F)));
  for (int i = 0; i < streaks; ++i) {
    Shape streak;
    streak.kind = ShapeKind::ellipse;
    streak.half_w = canvas->px(random->uniform(0.03F, 0.25F));
    streak.half_h = std::max(1.0F, canvas->px(random->uniform(0.0015F, 0.004F)));
    streak.x = rect.x + random->uniform() * rect.width;
    streak.y = rect.y + streak.half_h + random->uniform() * (rect.height - 2.0F * streak.half_h);
    streak.value = random->uniform(0.1F, 0.55F);
    streak.opacity = random->uniform(0.2F, 0.6F);
    draw(canvas, streak);
  }
}

}  // namespace

void paintWall(Canvas* canvas, Random* random) {
  fill(canvas, random->uniform(0.5F, 0.62F));
  addNoise(canvas, {0.05F, canvas->px(1.0F), 0.75F}, random);
  strew(canvas,
        {whole(*canvas), canvas->px(0.015F), canvas->px(0.06F), 0.02F, 0.2F, 0.8F, 0.7F},
        random);
  hangPictures(canvas, random);
  const float height = static_cast<float>(canvas->height());
  drawRect(canvas,
           {0.0F, height - canvas->px(0.1F), static_cast<float>(canvas->width()), canvas->px(0.1F)},
           0.25F);
}

void paintCeiling(Canvas* canvas, Random* random) {
  fill(canvas, 0.7F);
  const float panel = canvas->px(0.6F);
  for (float y = 0.0F; y < static_cast<float>(canvas->height()); y += panel) {
    for (float x = 0.0F; x < static_cast<float>(canvas->width()); x += panel) {
      drawRect(canvas, {x, y, panel - 4.0F, panel - 4.0F}, random->uniform(0.6F, 0.75F));
    }
  }
  strew(canvas,
        {whole(*canvas), canvas->px(0.01F), canvas->px(0.04F), 0.04F, 0.2F, 0.6F, 0.8F},
        random);
  addNoise(canvas, {0.03F, canvas->px(0.5F), 0.8F}, random);
}

void paintPlanks(Canvas* canvas, Random* random) {
  const float board = canvas->px(0.14F);
  for (float y = 0.0F; y < static_cast<float>(canvas->height()); y += board) {
    for (float x = -canvas->px(random->uniform(0.0F, 1.0F));
         x < static_cast<float>(canvas->width());) {
      const float length = canvas->px(random->uniform(0.5F, 1.6F));
      const Rect plank{x, y, length - 2.0F, board - 2.0F};
      drawRect(canvas, {x, y, length, board}, 0.08F);
      drawRect(canvas, plank, random->uniform(0.25F, 0.5F));
      addGrain(canvas, plank, random);
      x += length;
    }
  }
  addNoise(canvas, {0.05F, canvas->px(0.5F), 0.8F}, random);
}

void paintWood(Canvas* canvas, Random* random) {
  fill(canvas, random->uniform(0.3F, 0.55F));
  addGrain(canvas, whole(*canvas), random);
  addNoise(canvas, {0.07F, canvas->px(0.3F), 0.8F}, random);
  strew(canvas,
        {whole(*canvas), canvas->px(0.012F), canvas->px(0.1F), 0.05F, 0.1F, 0.8F, 0.8F},
        random);
}

namespace {

void paintSpine(Canvas* canvas, const Rect& spine, Random* random) {
  drawRect(canvas, spine, random->uniform(0.12F, 0.85F));
  const int bands = 1 + random->below(3);
  for (int band = 0; band < bands; ++band) {
    const float h = spine.height * random->uniform(0.03F, 0.2F);
    const float y = spine.y + random->uniform() * (spine.height - h);
    const float inset = random->uniform(0.0F, 0.25F) * spine.width;
    drawRect(
        canvas, {spine.x + inset, y, spine.width - 2.0F * inset, h}, random->uniform(0.1F, 0.95F));
  }
}

}  // namespace

void paintBooks(Canvas* canvas, Random* random) {
  fill(canvas, 0.04F);
  const float board = canvas->px(0.025F), shelf = canvas->px(0.33F);
  const float width = static_cast<float>(canvas->width());
  for (float y = 0.0F; y < static_cast<float>(canvas->height()); y += shelf) {
    for (float x = board; x < width - board;) {
      const float w = canvas->px(random->uniform(0.015F, 0.06F));
      const float h = (shelf - board) * random->uniform(0.6F, 0.95F);
      const bool is_gap = random->uniform() < 0.06F;
      if (!is_gap)
        paintSpine(canvas, {x, y + shelf - h, std::min(w, width - board - x), h}, random);
      x += is_gap ? 2.0F * w : w + 1.0F;
    }
    drawRect(canvas, {0.0F, y, width, board}, 0.45F);
  }
  addNoise(canvas, {0.02F, canvas->px(0.1F), 0.9F}, random);
}

void paintCardboard(Canvas* canvas, Random* random) {
  fill(canvas, random->uniform(0.35F, 0.5F));
  addNoise(canvas, {0.05F, canvas->px(0.2F), 0.85F}, random);
  const float w = static_cast<float>(canvas->width()), h = static_cast<float>(canvas->height());
  drawRect(canvas, {0.0F, h * random->uniform(0.45F, 0.55F), w, canvas->px(0.05F)}, 0.65F);
  paintPage(
      canvas,
      {w * random->uniform(0.05F, 0.4F), h * random->uniform(0.05F, 0.2F), 0.4F * w, 0.5F * h},
      random);
  strew(canvas,
        {{0.1F * w, 0.7F * h, 0.8F * w, 0.2F * h},
         canvas->px(0.01F),
         canvas->px(0.05F),
         0.3F,
         0.05F,
         0.3F},
        random);
}

void paintFabric(Canvas* canvas, Random* random) {
  fill(canvas, random->uniform(0.25F, 0.5F));
  strew(canvas,
        {whole(*canvas), canvas->px(0.012F), canvas->px(0.2F), 0.3F, 0.1F, 0.8F, 0.8F},
        random);
  addNoise(canvas, {0.04F, 8.0F, 0.95F}, random);
}

void paintDesk(Canvas* canvas, Random* random) {
  paintWood(canvas, random);
  const float cell = canvas->px(0.28F);
  for (float y = 0.0F; y + cell < static_cast<float>(canvas->height()); y += cell) {
    for (float x = 0.0F; x + cell < static_cast<float>(canvas->width()); x += cell) {
      const Rect rect{x + canvas->px(random->uniform(0.0F, 0.1F)),
                      y + canvas->px(random->uniform(0.0F, 0.06F)),
                      canvas->px(random->uniform(0.12F, 0.2F)),
                      canvas->px(random->uniform(0.12F, 0.24F))};
      const float what = random->uniform();
      if (what < 0.45F) paintPage(canvas, rect, random);
      if (what > 0.75F) paintPicture(canvas, rect, random);
    }
  }
  strew(
      canvas, {whole(*canvas), canvas->px(0.006F), canvas->px(0.08F), 0.05F, 0.05F, 0.95F}, random);
}

}  // namespace glide::synthetic
