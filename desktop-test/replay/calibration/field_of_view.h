#pragma once

#include "replay/calibration/calibration.h"

#include <string>

namespace glide::replay {

/// Whether -c names a field of view ("fov:69") instead of a file.
bool isFieldOfView(const std::string& text);

/// The pinhole of a camera of which only the field of view along the longer side of the image is
/// known, as data sheets of phones tell it: square pixels, centre in the middle, no distortion. For
/// a first look at one's own video. invalid_argument unless "fov:" is followed by 10 to 150
/// degrees.
Result<Calibration> calibrationOfField(const std::string& text, int width, int height);

}  // namespace glide::replay
