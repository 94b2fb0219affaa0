#include "synthetic/materials.h"

#include "synthetic/materials_internal.h"

namespace glide::synthetic {

void paint(Material material, Canvas* canvas, Random* random) {
  switch (material) {
    case Material::wall:
      return paintWall(canvas, random);
    case Material::ceiling:
      return paintCeiling(canvas, random);
    case Material::planks:
      return paintPlanks(canvas, random);
    case Material::wood:
      return paintWood(canvas, random);
    case Material::books:
      return paintBooks(canvas, random);
    case Material::cardboard:
      return paintCardboard(canvas, random);
    case Material::fabric:
      return paintFabric(canvas, random);
    case Material::picture:
      return paintPicture(canvas, whole(*canvas), random);
    case Material::paper:
      return paintPage(canvas, whole(*canvas), random);
    case Material::desk:
      return paintDesk(canvas, random);
    case Material::bricks:
      return paintBricks(canvas, random);
    case Material::window:
      return paintWindow(canvas, random);
    case Material::asphalt:
      return paintAsphalt(canvas, random);
    case Material::metal:
      return paintMetal(canvas, random);
    case Material::sky:
      return paintSky(canvas, random);
  }
}

}  // namespace glide::synthetic
