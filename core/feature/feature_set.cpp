#include "feature/feature_set.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <cstddef>
#include <utility>

namespace glide {
namespace {

/// Cell side in px: a projection window of 15..50 px then touches a few cells per side, and a cell
/// holds about one of 1000 features.
constexpr float kCellSize = 16.0F;
/// A few features in a large image get larger cells: the grid must not outgrow what it holds. At
/// this number the cells of 1000 features grow beyond 2048x2048 px only.
constexpr float kMaxCellsPerFeature = 16.0F;

float cellSize(std::size_t features, int width, int height) {
  const float cells = kMaxCellsPerFeature * static_cast<float>(std::max<std::size_t>(features, 1));
  const float w = static_cast<float>(width);
  const float h = static_cast<float>(height);
  return std::max({kCellSize, std::sqrt(w * h / cells), w / cells, h / cells});
}

int cellsAlong(int size, float cell_size) {
  return std::max(1, static_cast<int>(std::ceil(static_cast<float>(size) / cell_size)));
}

/// Cell of a coordinate, clamped into [0, cells - 1] before the conversion so that no value
/// overflows.
int cellOf(float coordinate, float cell_size, int cells) {
  return static_cast<int>(std::clamp(coordinate / cell_size, 0.0F, static_cast<float>(cells - 1)));
}

}  // namespace

FeatureSet::FeatureSet(std::vector<Feature> features,
                       std::vector<Descriptor> descriptors,
                       int width,
                       int height)
    : features_(std::move(features)),
      descriptors_(std::move(descriptors)),
      width_(width),
      height_(height),
      cell_size_(cellSize(features_.size(), width, height)),
      columns_(cellsAlong(width, cell_size_)),
      rows_(cellsAlong(height, cell_size_)) {
  assert(features_.size() == descriptors_.size());
  std::vector<int> cell_of_feature(features_.size());
  cell_start_.assign(static_cast<std::size_t>(columns_ * rows_) + 1, 0);
  for (std::size_t i = 0; i < features_.size(); ++i) {
    const Vec2f& uv = features_[i].uv;
    cell_of_feature[i] =
        cellOf(uv.y(), cell_size_, rows_) * columns_ + cellOf(uv.x(), cell_size_, columns_);
    ++cell_start_[static_cast<std::size_t>(cell_of_feature[i]) + 1];
  }
  for (std::size_t c = 1; c < cell_start_.size(); ++c) cell_start_[c] += cell_start_[c - 1];
  cell_items_.resize(features_.size());
  std::vector<int> next(cell_start_.begin(), cell_start_.end() - 1);
  for (std::size_t i = 0; i < features_.size(); ++i) {
    int& slot = next[static_cast<std::size_t>(cell_of_feature[i])];
    cell_items_[static_cast<std::size_t>(slot++)] = static_cast<int>(i);
  }
}

FeatureSet FeatureSet::withPatches(std::vector<FeaturePatch> patches) && {
  assert(patches.size() == features_.size());
  patches_ = std::move(patches);
  return std::move(*this);
}

FeatureSet FeatureSet::withMoved(std::span<const FeatureMove> moves) const {
  std::vector<Feature> features = features_;
  std::vector<FeaturePatch> patches = patches_;
  for (const FeatureMove& move : moves) {
    const std::size_t i = static_cast<std::size_t>(move.feature);
    features[i].uv = move.uv;
    patches[i].offset = move.patch_offset;
  }
  return FeatureSet(std::move(features), descriptors_, width_, height_)
      .withPatches(std::move(patches));
}

void FeatureSet::query(const Query& query, std::vector<int>* out) const {
  out->clear();
  const bool finite = std::isfinite(query.uv.x()) && std::isfinite(query.uv.y());
  if (features_.empty() || !finite || !(query.radius_px >= 0.0F)) return;
  const float r = query.radius_px;
  const int first_column = cellOf(query.uv.x() - r, cell_size_, columns_);
  const int last_column = cellOf(query.uv.x() + r, cell_size_, columns_);
  const int last_row = cellOf(query.uv.y() + r, cell_size_, rows_);
  for (int row = cellOf(query.uv.y() - r, cell_size_, rows_); row <= last_row; ++row) {
    // The cells of a row lie one after the other, so their items are one range.
    const std::size_t cell = static_cast<std::size_t>(row * columns_);
    const int begin = cell_start_[cell + static_cast<std::size_t>(first_column)];
    const int end = cell_start_[cell + static_cast<std::size_t>(last_column) + 1];
    for (int k = begin; k < end; ++k) {
      const int index = cell_items_[static_cast<std::size_t>(k)];
      const Feature& f = features_[static_cast<std::size_t>(index)];
      if (f.level < query.min_level || f.level > query.max_level) continue;
      if (std::abs(f.uv.x() - query.uv.x()) > r || std::abs(f.uv.y() - query.uv.y()) > r) continue;
      out->push_back(index);
    }
  }
  std::sort(out->begin(), out->end());
}

}  // namespace glide
