#include "capi/status.h"

#include "glide/glide.h"

#include <algorithm>
#include <array>
#include <cstring>

namespace glide {
namespace {

// Without a destructor: the library may be unloaded while threads live on.
thread_local std::array<char, 512> last_error{};

}  // namespace

void setLastError(std::string_view message) {
  const std::size_t length = std::min(message.size(), last_error.size() - 1);
  std::memcpy(last_error.data(), message.data(), length);
  last_error[length] = '\0';
}

glide_status refuse(glide_status status, std::string_view why) {
  setLastError(why);
  return status;
}

glide_status refuseArgument(std::string_view why) {
  return refuse(GLIDE_ERROR_INVALID_ARGUMENT, why);
}

glide_status refuse(const Error& error) { return refuse(statusOf(error.code), error.message); }

glide_status statusOf(ErrorCode code) {
  switch (code) {
    case ErrorCode::invalid_argument:
      return GLIDE_ERROR_INVALID_ARGUMENT;
    case ErrorCode::unsupported:
      return GLIDE_ERROR_UNSUPPORTED_CONFIGURATION;
    case ErrorCode::out_of_order:
      return GLIDE_ERROR_TIMESTAMP_ORDER;
    case ErrorCode::missing_context:
      return GLIDE_ERROR_MISSING_GL_CONTEXT;
    case ErrorCode::io:
      return GLIDE_ERROR_IO;
    case ErrorCode::invalid_data:
      return GLIDE_ERROR_DATA_INVALID_FORMAT;
    case ErrorCode::unknown_version:
      return GLIDE_ERROR_DATA_UNSUPPORTED_VERSION;
    case ErrorCode::gl:
      return GLIDE_ERROR_GL;
    case ErrorCode::no_map:
      return GLIDE_ERROR_NOT_TRACKING;
    case ErrorCode::internal:
      break;
  }
  return GLIDE_ERROR_FATAL;
}

}  // namespace glide

extern "C" {

const char* glide_last_error(void) { return glide::last_error.data(); }

const char* glide_status_string(glide_status status) {
  switch (status) {
    case GLIDE_OK:
      return "done";
    case GLIDE_TRUNCATED:
      return "done, but there is more than fits";
    case GLIDE_ERROR_INVALID_ARGUMENT:
      return "invalid argument";
    case GLIDE_ERROR_FATAL:
      return "internal failure";
    case GLIDE_ERROR_SESSION_PAUSED:
      return "the session is paused";
    case GLIDE_ERROR_NOT_TRACKING:
      return "there is no tracked pose";
    case GLIDE_ERROR_MISSING_GL_CONTEXT:
      return "no OpenGL ES 3.1 context is current";
    case GLIDE_ERROR_UNSUPPORTED_CONFIGURATION:
      return "not supported by this device or build";
    case GLIDE_ERROR_RESOURCE_EXHAUSTED:
      return "out of resources";
    case GLIDE_ERROR_NOT_YET_AVAILABLE:
      return "not there yet";
    case GLIDE_ERROR_DATA_INVALID_FORMAT:
      return "no sound map";
    case GLIDE_ERROR_DATA_UNSUPPORTED_VERSION:
      return "a map of another format version";
    case GLIDE_ERROR_SESSION_CLOSED:
      return "the handle is null or was destroyed";
    case GLIDE_ERROR_WRONG_THREAD:
      return "another thread owns the session's GL objects";
    case GLIDE_ERROR_TIMESTAMP_ORDER:
      return "the timestamp does not increase";
    case GLIDE_ERROR_IO:
      return "reading or writing failed";
    case GLIDE_ERROR_GL:
      return "OpenGL failed";
    default:
      return "unknown status";
  }
}

}  // extern "C"
