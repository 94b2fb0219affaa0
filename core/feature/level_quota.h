#pragma once

#include <span>
#include <vector>

namespace glide {

/// How many of `count` features each level gives: shares fall by `scale_factor` from level to
/// level, and what a level lacks (it found only `found[level]`) goes to the others in the same
/// proportion.
std::vector<int> levelQuotas(int count, double scale_factor, std::span<const int> found);

}  // namespace glide
