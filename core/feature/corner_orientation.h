#pragma once

#include "feature/corner.h"
#include "feature/descriptor_pattern.h"

#include "image/image.h"

#include <span>

namespace glide {

/// Directions from corners to the intensity centroids around them, radians in (-pi, pi] (Rosin
/// 1999; Rublee et al. 2011, section 3.2). Weights fall to zero at kPatchRadius, so that what
/// enters the disc there does not turn the direction: 2 % more correct matches on EuRoC MH01 than
/// with a sharp disc. Corners are kPatchRadius + 1 px or more from the borders; `angles` has the
/// length of `corners`.
void cornerAngles(const ImageViewU8& image,
                  std::span<const Corner> corners,
                  std::span<float> angles);

}  // namespace glide
