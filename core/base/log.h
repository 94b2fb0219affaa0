#pragma once

#include <functional>
#include <string_view>

namespace glide {

enum class LogLevel { debug, info, warning, error };

/// Where messages go; empty means nowhere. Passed down from the session, never global.
using LogSink = std::function<void(LogLevel, std::string_view)>;

}  // namespace glide
