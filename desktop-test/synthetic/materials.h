#pragma once

#include "synthetic/canvas.h"

namespace glide::synthetic {

/// What a surface looks like.
enum class Material {
  wall,       ///< plaster with framed pictures, notes and switches
  ceiling,    ///< plaster with panels
  planks,     ///< wooden floor
  wood,       ///< furniture
  books,      ///< a filled book shelf
  cardboard,  ///< boxes with labels
  fabric,     ///< patterned cloth
  picture,    ///< one framed picture
  paper,      ///< printed page
  desk,       ///< table top strewn with pages, notes and small things, all flat
  bricks,     ///< masonry
  window,     ///< panes that reflect something
  asphalt,    ///< street with markings and repairs
  metal,      ///< painted steel with seams
  sky,        ///< clouds
};

/// Paints the whole canvas.
void paint(Material material, Canvas* canvas, Random* random);

}  // namespace glide::synthetic
