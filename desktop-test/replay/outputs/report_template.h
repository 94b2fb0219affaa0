#pragma once

#include <string_view>

namespace glide::replay {

/// The page of desktop-test/report, made when this program was built: HTML with everything in it
/// but the run's data. Empty when there was no npm to make it.
std::string_view reportTemplate();

}  // namespace glide::replay
