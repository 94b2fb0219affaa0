#pragma once

#include "synthetic/canvas.h"

/// Painters of the materials, shared by the files that implement paint().
namespace glide::synthetic {

inline Rect whole(const Canvas& canvas) {
  return {0.0F, 0.0F, static_cast<float>(canvas.width()), static_cast<float>(canvas.height())};
}

/// A picture with a frame that fills `rect`.
void paintPicture(Canvas* canvas, const Rect& rect, Random* random);
/// A sheet with a heading and lines of print that fills `rect`.
void paintPage(Canvas* canvas, const Rect& rect, Random* random);

void paintWall(Canvas* canvas, Random* random);
void paintCeiling(Canvas* canvas, Random* random);
void paintPlanks(Canvas* canvas, Random* random);
void paintWood(Canvas* canvas, Random* random);
void paintBooks(Canvas* canvas, Random* random);
void paintCardboard(Canvas* canvas, Random* random);
void paintFabric(Canvas* canvas, Random* random);
void paintDesk(Canvas* canvas, Random* random);

void paintBricks(Canvas* canvas, Random* random);
void paintWindow(Canvas* canvas, Random* random);
void paintAsphalt(Canvas* canvas, Random* random);
void paintMetal(Canvas* canvas, Random* random);
void paintSky(Canvas* canvas, Random* random);

}  // namespace glide::synthetic
