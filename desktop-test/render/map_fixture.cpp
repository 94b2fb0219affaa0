#include "render/map_fixture.h"

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <utility>

namespace glide::test {
namespace {

Matrix4 columnMajor(const glm::mat4& matrix) {
  Matrix4 values{};
  std::copy_n(glm::value_ptr(matrix), values.size(), values.begin());
  return values;
}

}  // namespace

MapRenderer MapRendererTest::makeRenderer() {
  Result<MapRenderer> renderer = MapRenderer::create(GlStatePolicy::preserve);
  EXPECT_TRUE(renderer.ok()) << renderer.error().message;
  return std::move(*renderer);
}

MapRenderer MapRendererTest::rendererOf(const RoomMap& room) {
  MapRenderer renderer = makeRenderer();
  renderer.setMap(room.map);
  for (const FrameResult& frame : room.frames) renderer.addFrame(frame);
  return renderer;
}

ViewCamera cornerView(const Viewport& viewport) {
  return viewFrom({-2.6F, -2.6F, -2.2F}, {0.0F, 0.1F, 1.3F}, viewport);
}

ViewCamera viewFrom(const std::array<float, 3>& eye,
                    const std::array<float, 3>& target,
                    const Viewport& viewport) {
  constexpr float kFieldOfView = 0.9F, kNear = 0.05F, kFar = 100.0F;  // radians, scene units
  constexpr glm::vec3 kUp(0.0F, -1.0F, 0.0F);
  const float aspect = static_cast<float>(viewport.width) / static_cast<float>(viewport.height);
  return {columnMajor(glm::lookAt(glm::make_vec3(eye.data()), glm::make_vec3(target.data()), kUp)),
          columnMajor(glm::perspective(kFieldOfView, aspect, kNear, kFar))};
}

std::array<int, 3> pixelAt(const RgbPicture& picture, int x, int y) {
  const std::uint8_t* p = picture.pixels.data() + 3 * (y * picture.width + x);
  return {p[0], p[1], p[2]};
}

int countOf(const RgbPicture& picture, const Color& color, int tolerance) {
  int count = 0;
  for (int i = 0; i < picture.width * picture.height; ++i) {
    const std::array<int, 3> pixel = pixelAt(picture, i % picture.width, i / picture.width);
    bool is_near = true;
    for (std::size_t c = 0; c < pixel.size(); ++c)
      is_near &= std::abs(static_cast<float>(pixel[c]) - 255.0F * color[c]) <=
                 static_cast<float>(tolerance);
    count += is_near ? 1 : 0;
  }
  return count;
}

}  // namespace glide::test
