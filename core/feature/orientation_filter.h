#pragma once

#include "feature/matcher.h"

#include <vector>

namespace glide {

/// Removes matches whose change of orientation is far from the most frequent one: between two views
/// of a scene the image turns by about one angle.
void keepConsistentRotation(const FeatureSet& a, const FeatureSet& b, std::vector<Match>* matches);

}  // namespace glide
