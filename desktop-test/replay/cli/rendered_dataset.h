#pragma once

#include <filesystem>

namespace glide::replay {

/// Number of images of the rendered dataset.
inline constexpr int kRenderedFrames = 24;

/// Writes a TUM layout with calibration and exact ground truth: a camera that moves sideways along
/// a textured wall with panels in front of it.
void writeRenderedDataset(const std::filesystem::path& folder);

}  // namespace glide::replay
