#pragma once

#include "support/golden_image.h"
#include "support/room_map.h"

#include "gpu/gl_test.h"

#include "glide/map_renderer.h"
#include "glide/render_target.h"

#include <array>
#include <string>

namespace glide::test {

/// From `eye` at `target`, both in the map's world, upright.
ViewCamera viewFrom(const std::array<float, 3>& eye,
                    const std::array<float, 3>& target,
                    const Viewport& viewport);
/// The room (room_map.h) from above one of its corners.
ViewCamera cornerView(const Viewport& viewport);

/// Tests that draw maps: a renderer in the program's context, and pictures of it.
class MapRendererTest : public GlTest {
 protected:
  static MapRenderer makeRenderer();
  /// A renderer that has been given the whole room.
  static MapRenderer rendererOf(const RoomMap& room);

  /// Goldens are of llvmpipe: other rasterisers put edges elsewhere.
  bool hasGoldens() const { return caps().renderer.find("llvmpipe") != std::string::npos; }
};

/// Nearly white, as the report's page.
inline constexpr Color kPaper{0.965F, 0.97F, 0.98F, 1.0F};

/// Red, green and blue of a pixel; the uppermost row is 0.
std::array<int, 3> pixelAt(const RgbPicture& picture, int x, int y);

/// How many pixels are within `tolerance` of `color` on every channel.
int countOf(const RgbPicture& picture, const Color& color, int tolerance);

}  // namespace glide::test
