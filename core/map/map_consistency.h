#pragma once

#include "map/map.h"

#include <string>

namespace glide {

/// Empty when observations, covisibility and retired keyframes agree with each other; else the
/// first contradiction. Costs as much as rebuilding the covisibility: for tests and debugging.
std::string checkConsistency(const Map& map);

}  // namespace glide
