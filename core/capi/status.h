#pragma once

#include "glide/glide_types.h"
#include "glide/result.h"

#include <exception>
#include <string_view>

namespace glide {

/// What glide_last_error() of this thread will say; cut off where it gets long.
void setLastError(std::string_view message);

/// Remembers why for glide_last_error(), and returns `status`.
glide_status refuse(glide_status status, std::string_view why);
glide_status refuse(const Error& error);

/// refuse() of GLIDE_ERROR_INVALID_ARGUMENT.
glide_status refuseArgument(std::string_view why);

/// GLIDE_OK with the type of a status.
inline constexpr glide_status kDone = GLIDE_OK;

/// The number that C callers get for an error.
glide_status statusOf(ErrorCode code);

/// Runs a function that returns a glide_status; nothing that it throws leaves.
template <class Function>
glide_status guarded(Function&& function) noexcept {
  try {
    return function();
  } catch (const std::exception& exception) {
    return refuse(GLIDE_ERROR_FATAL, exception.what());
  } catch (...) {
    return refuse(GLIDE_ERROR_FATAL, "unknown exception");
  }
}

}  // namespace glide
