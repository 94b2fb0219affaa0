#pragma once

#include "glide/config.h"
#include "glide/result.h"

#include <string_view>

namespace glide {

/// Sets the field of that dotted name ("direct.patch_size") from a text: a number, the name of an
/// enum's value, numbers between spaces or commas. invalid_argument says what does not fit, and for
/// an unknown name which one is most like it. Ranges are validate()'s business.
GLIDE_API Status setField(Config& config, std::string_view name, std::string_view text);

/// The same from "direct.patch_size=11"; the message begins with the name.
GLIDE_API Status applySetting(Config& config, std::string_view setting);

}  // namespace glide
