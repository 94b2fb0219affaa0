#pragma once

#include "synthetic/living_room/color_canvas.h"

// What the things of a living room look like in white light.
namespace glide::synthetic {

/// Two tones of a wood: the ground and the grain.
struct Wood {
  Rgb light, dark;
};
inline const Wood kOak{hex(0xC79A63), hex(0x9A6B3A)};
inline const Wood kWalnut{hex(0x7A5236), hex(0x4A2F1E)};
inline const Wood kBirch{hex(0xE0C9A0), hex(0xC4A676)};
inline const Wood kBlackened{hex(0x33302D), hex(0x1E1C1A)};

// paint_surfaces.cpp: walls, floors, wood, stone, metal.
/// One colour, a little uneven.
Painter plain(const Rgb& color);
Painter plaster(const Rgb& color);
/// Rows of twigs with leaves.
Painter wallpaper(const Rgb& ground, const Rgb& twig);
/// Grain along the longer side.
Painter wood(const Wood& tones);
Painter planks(const Wood& tones);
Painter paintedBricks(const Rgb& color);
Painter panelDoor(const Rgb& color);
/// Ribs along the columns.
Painter radiator();
Painter ceramic(const Rgb& ground, const Rgb& band);

// paint_fabrics.cpp
Painter weave(const Rgb& warp, const Rgb& weft);
Painter zigzag(const Rgb& ground, const Rgb& line);
Painter dots(const Rgb& ground, const Rgb& dot);
Painter stripes(const Rgb& ground, const Rgb& stripe);
/// A kilim: borders, and lozenges in the middle.
Painter rug();
/// Cloth that hangs in folds.
Painter curtain(const Rgb& cloth, const Rgb& stripe);
Painter wicker(const Rgb& color);

// paint_pictures.cpp: in a frame of the given colour with a mount.
Painter mountains(const Rgb& frame);
Painter abstractForms(const Rgb& frame);
Painter botanical(const Rgb& frame);
Painter cityAtNight(const Rgb& frame);
Painter stillLife(const Rgb& frame);
/// What is seen out of the window.
Painter gardenView();

// paint_things.cpp
/// Spines of books that stand side by side.
Painter bookSpines();
Painter bookCover();
Painter bookPages();
Painter page();
Painter pointCloudScreen();
Painter keyboard();
Painter clockFace();
Painter corkBoard();
Painter lampshade(const Rgb& glow);
Painter leaf(const Rgb& green);
Painter soil();
Painter magazine();
Painter loudspeaker();
Painter record();

}  // namespace glide::synthetic
