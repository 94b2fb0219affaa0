#include "synthetic/renderer.h"

#include <algorithm>
#include <cassert>
#include <cmath>

namespace glide::synthetic {

namespace {

constexpr int kTileSize = 16;   // px: small enough that a tile sees one to three surfaces
constexpr int kSubsamples = 4;  // per side of a pixel on an edge
// Share of a radian by which outlines may be off: rounding, and the camera's travel while the rows
// are read out.
constexpr float kMargin = 0.002F, kRollingMargin = 0.06F;

Vec3f unitOrZero(const Vec3f& v) {
  const float norm = v.norm();
  return norm > 0.0F ? Vec3f(v / norm) : Vec3f(Vec3f::Zero());
}

/// As ITU-R BT.601 weighs colours, and OpenCV with it.
void toLuma(const ImageRgb& color, ImageF* luma) {
  const Vec3f weights(0.299F, 0.587F, 0.114F);
  for (int y = 0; y < color.height(); ++y) {
    const Vec3f* in = color.row(y);
    float* out = luma->row(y);
    for (int x = 0; x < color.width(); ++x) out[x] = weights.dot(in[x]);
  }
}

}  // namespace

Renderer::Renderer(const CameraModel& camera) : width_(camera.width()), height_(camera.height()) {
  bearings_.resize(at(0, height_), Vec3f::Zero());
  pixel_angles_.resize(bearings_.size(), 0.0F);
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const auto bearing = camera.unproject(Vec2d(x, y));
      if (bearing) bearings_[at(x, y)] = bearing->cast<float>();
    }
  }
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      const int nx = x + 1 < width_ ? x + 1 : x - 1;
      pixel_angles_[at(x, y)] = (bearings_[at(nx, y)] - bearings_[at(x, y)]).norm();
    }
  }
  for (int y = 0; y < height_; y += kTileSize) {
    for (int x = 0; x < width_; x += kTileSize) tiles_.push_back(makeTile(x, y));
  }
}

Renderer::Tile Renderer::makeTile(int x0, int y0) const {
  Tile tile{x0, y0, std::min(x0 + kTileSize, width_), std::min(y0 + kTileSize, height_)};
  Vec3f sum = Vec3f::Zero();
  const auto forEachPixel = [&](const auto& visit) {
    for (int y = tile.y0; y < tile.y1; ++y) {
      for (int x = tile.x0; x < tile.x1; ++x) visit(bearings_[at(x, y)]);
    }
  };
  forEachPixel([&](const Vec3f& bearing) { sum += bearing; });
  tile.axis_cam = unitOrZero(sum);
  forEachPixel([&](const Vec3f& bearing) {
    tile.sin_half_angle = std::max(tile.sin_half_angle, tile.axis_cam.cross(bearing).norm());
  });
  return tile;
}

void Renderer::render(const Scene& scene, std::span<const SE3d> T_world_cam_rows, Rendering* out) {
  assert(T_world_cam_rows.size() == 1 ||
         T_world_cam_rows.size() == static_cast<std::size_t>(height_));
  out->radiance.resize(width_, height_);
  out->range.resize(width_, height_);
  seen_.assign(bearings_.size(), nullptr);
  prepareViews(T_world_cam_rows);
  prepareOutlines(scene);
  if (!scene.has_color) return renderTiles(&out->radiance, &out->range);
  out->color.resize(width_, height_);
  renderTiles(&out->color, &out->range);
  toLuma(out->color, &out->radiance);
}

template <class Value>
void Renderer::renderTiles(Image<Value>* radiance, ImageF* range) {
  for (const Tile& tile : tiles_) renderTile(tile, radiance, range);
  for (const Tile& tile : tiles_) smoothTile(tile, radiance);
}

void Renderer::prepareViews(std::span<const SE3d> T_world_cam_rows) {
  views_.clear();
  for (const SE3d& T_world_cam : T_world_cam_rows) {
    views_.push_back({T_world_cam.rotation().cast<float>(), T_world_cam.t.cast<float>()});
  }
}

void Renderer::prepareOutlines(const Scene& scene) {
  const Vec3f center = viewOfRow(height_ / 2).center;
  outlines_.clear();
  for (const Surface& surface : scene.surfaces) {
    const Vec3f u = surface.width * surface.axis_u, v = surface.height * surface.axis_v;
    const Vec3f corner = surface.origin - center;
    const std::array<Vec3f, 4> corners{corner, corner + u, corner + u + v, corner + v};
    Outline outline{&surface, {}};
    for (std::size_t i = 0; i < 4; ++i)
      outline.sides[i] = unitOrZero(corners[i].cross(corners[(i + 1) % 4]));
    outlines_.push_back(outline);
  }
}

void Renderer::selectSurfaces(const Tile& tile) {
  const View& view = viewOfRow((tile.y0 + tile.y1) / 2);
  const Vec3f axis = view.R_world_cam * tile.axis_cam;
  const float outside = -tile.sin_half_angle - (views_.size() == 1 ? kMargin : kRollingMargin);
  selected_.clear();
  caster_.clear();
  for (const Outline& outline : outlines_) {
    const auto& sides = outline.sides;
    if (std::any_of(sides.begin(), sides.end(), [&](const Vec3f& side) {
          return side.dot(axis) < outside;
        }))
      continue;
    selected_.push_back(outline.surface);
    caster_.add(*outline.surface);
  }
}

template <class Value>
void Renderer::renderTile(const Tile& tile, Image<Value>* radiance, ImageF* range) {
  selectSurfaces(tile);
  for (int y = tile.y0; y < tile.y1; ++y) {
    const View& view = viewOfRow(y);
    caster_.moveTo(view.center);
    for (int x = tile.x0; x < tile.x1; ++x) {
      const Vec3f d_world = view.R_world_cam * bearings_[at(x, y)];
      const Hit hit = caster_.trace(d_world);
      radiance->row(y)[x] = caster_.shade<Value>(hit, d_world, pixel_angles_[at(x, y)]);
      range->row(y)[x] = hit.range;
      if (hit.index >= 0) seen_[at(x, y)] = selected_[static_cast<std::size_t>(hit.index)];
    }
  }
}

template <class Value>
void Renderer::smoothTile(const Tile& tile, Image<Value>* radiance) {
  bool is_ready = false;  // most tiles have no edge and need no surfaces
  for (int y = tile.y0; y < tile.y1; ++y) {
    bool is_placed = false;
    for (int x = tile.x0; x < tile.x1; ++x) {
      if (!isEdge(x, y)) continue;
      if (!is_ready) selectSurfaces(tile);
      if (!is_placed) caster_.moveTo(viewOfRow(y).center);
      is_ready = is_placed = true;
      radiance->row(y)[x] = supersample<Value>(x, y);
    }
  }
}

bool Renderer::isEdge(int x, int y) const {
  const Surface* self = seen_[at(x, y)];
  return (x > 0 && seen_[at(x - 1, y)] != self) ||
         (x + 1 < width_ && seen_[at(x + 1, y)] != self) ||
         (y > 0 && seen_[at(x, y - 1)] != self) || (y + 1 < height_ && seen_[at(x, y + 1)] != self);
}

template <class Value>
Value Renderer::supersample(int x, int y) const {
  const int left = std::max(x - 1, 0), right = std::min(x + 1, width_ - 1);
  const int above = std::max(y - 1, 0), below = std::min(y + 1, height_ - 1);
  const Vec3f along_x =
      (bearings_[at(right, y)] - bearings_[at(left, y)]) / static_cast<float>(right - left);
  const Vec3f along_y =
      (bearings_[at(x, below)] - bearings_[at(x, above)]) / static_cast<float>(below - above);
  const Eigen::Matrix3f& R_world_cam = viewOfRow(y).R_world_cam;
  Value sum = black<Value>();
  for (int j = 0; j < kSubsamples; ++j) {
    for (int i = 0; i < kSubsamples; ++i) {
      const float sx = (static_cast<float>(i) + 0.5F) / kSubsamples - 0.5F;
      const float sy = (static_cast<float>(j) + 0.5F) / kSubsamples - 0.5F;
      const Vec3f d_world = R_world_cam * (bearings_[at(x, y)] + sx * along_x + sy * along_y);
      const Hit hit = caster_.trace(d_world);
      sum += caster_.shade<Value>(hit, d_world, pixel_angles_[at(x, y)] / kSubsamples);
    }
  }
  return sum / (kSubsamples * kSubsamples);
}

}  // namespace glide::synthetic
