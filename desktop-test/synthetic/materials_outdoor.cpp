#include "synthetic/materials_internal.h"

#include <algorithm>
#include <cmath>

// Sizes are in metres, reflectances in 0..1: what such things look like, nothing is derived from
// them.
namespace glide::synthetic {

void paintBricks(Canvas* canvas, Random* random) {
  fill(canvas, 0.6F);
  const float w = canvas->px(0.3F), h = canvas->px(0.12F),
              joint = std::max(1.0F, canvas->px(0.015F));
  int course = 0;
  for (float y = 0.0F; y < static_cast<float>(canvas->height()); y += h, ++course) {
    const float start = course % 2 == 0 ? 0.0F : -0.5F * w;
    for (float x = start; x < static_cast<float>(canvas->width()); x += w) {
      drawRect(canvas, {x, y, w - joint, h - joint}, random->uniform(0.22F, 0.5F));
    }
  }
  strew(canvas,
        {whole(*canvas), canvas->px(0.1F), canvas->px(1.6F), 0.05F, 0.15F, 0.75F, 0.6F},
        random);
  addNoise(canvas, {0.06F, canvas->px(2.0F), 0.8F}, random);
}

void paintWindow(Canvas* canvas, Random* random) {
  fill(canvas, 0.16F);
  strew(canvas,
        {whole(*canvas), canvas->px(0.08F), canvas->px(0.8F), 0.25F, 0.05F, 0.5F, 0.7F},
        random);
  addNoise(canvas, {0.05F, canvas->px(1.0F), 0.6F}, random);
  const float w = static_cast<float>(canvas->width()), h = static_cast<float>(canvas->height());
  const float bar = canvas->px(0.07F);
  for (const float x : {0.0F, 0.5F * (w - bar), w - bar})
    drawRect(canvas, {x, 0.0F, bar, h}, 0.75F);
  for (const float y : {0.0F, 0.35F * h, h - bar}) drawRect(canvas, {0.0F, y, w, bar}, 0.75F);
}

void paintAsphalt(Canvas* canvas, Random* random) {
  fill(canvas, 0.3F);
  addNoise(canvas, {0.05F, canvas->px(3.0F), 0.85F}, random);
  strew(canvas,
        {whole(*canvas), canvas->px(0.05F), canvas->px(1.2F), 0.06F, 0.15F, 0.45F, 0.8F},
        random);
  const float w = static_cast<float>(canvas->width()), h = static_cast<float>(canvas->height());
  for (float x = 0.0F; x < w; x += canvas->px(2.0F)) {
    drawRect(
        canvas, {x, 0.5F * h, canvas->px(random->uniform(0.9F, 1.2F)), canvas->px(0.12F)}, 0.8F);
  }
}

void paintMetal(Canvas* canvas, Random* random) {
  fill(canvas, random->uniform(0.2F, 0.7F));
  const float w = static_cast<float>(canvas->width()), h = static_cast<float>(canvas->height());
  drawRect(canvas, {0.0F, 0.1F * h, w, 0.35F * h}, random->uniform(0.05F, 0.2F));
  for (float x = 0.2F * w; x < w; x += w * random->uniform(0.2F, 0.35F)) {
    drawRect(canvas, {x, 0.0F, std::max(2.0F, canvas->px(0.02F)), h}, 0.05F);
  }
  strew(canvas,
        {whole(*canvas), canvas->px(0.04F), canvas->px(0.4F), 0.06F, 0.05F, 0.9F, 0.9F},
        random);
  addNoise(canvas, {0.02F, canvas->px(0.5F), 0.8F}, random);
}

void paintSky(Canvas* canvas, Random* random) {
  fill(canvas, 0.75F);
  addNoise(canvas, {0.12F, 0.5F * static_cast<float>(canvas->height()), 0.55F}, random);
}

}  // namespace glide::synthetic
