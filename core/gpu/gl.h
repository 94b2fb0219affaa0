#pragma once

#include "glide/result.h"

#include <GLES3/gl31.h>
// Extension tokens and types need the core header first.
#include <GLES2/gl2ext.h>

#include <optional>
#include <string_view>

namespace glide {

/// Reads and drops every pending GL error of the current context.
void drainGlErrors();

/// The first pending GL error, named together with `pass`; drops the others.
std::optional<Error> takeGlError(std::string_view pass);

/// Once per pass, only where asserts are on: aborts on a GL error, which then is a bug of ours (the
/// pass began with drainGlErrors). With NDEBUG it does nothing: glGetError stalls some drivers.
void assertNoGlError(std::string_view pass);

/// Start of a pass that ends with assertNoGlError: drops errors that the app has left pending.
void beginGlPass();

}  // namespace glide
