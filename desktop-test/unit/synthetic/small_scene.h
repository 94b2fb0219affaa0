#pragma once

#include "synthetic/scene_builder.h"
#include "synthetic/sequence.h"

#include <memory>
#include <utility>

namespace glide::synthetic {

/// A box before a wall, made in milliseconds.
inline std::shared_ptr<const Scene> smallScene() {
  constexpr float kTexels = 150.0F;
  Scene scene;
  Surface wall;
  wall.material = Material::picture;
  wall.texels_per_m = kTexels;
  addSurface({-3.0F, -3.0F, 2.5F}, {6.0F, 0.0F, 0.0F}, {0.0F, 6.0F, 0.0F}, wall, &scene);
  Box box;
  box.center = {0.2F, 0.1F, 1.6F};
  box.size = {0.5F, 0.5F, 0.4F};
  box.yaw = 0.4F;
  box.front = box.side = Material::cardboard;
  addBox(box, kTexels, &scene);
  scene.viewpoint.target = {0.0, 0.0, 2.0};
  finishScene({0.4F, {{{-1.0F, -2.0F, 0.0F}, 0.5F, 0.5F, 2.0F}}}, 3, &scene);
  return std::make_shared<const Scene>(std::move(scene));
}

/// A short sequence in it.
inline SequenceOptions smallSequence(DistortionModel model) {
  SequenceOptions options;
  options.camera = makeCamera(model, 160, 120);
  options.frames = 10;
  return options;
}

}  // namespace glide::synthetic
