#pragma once

#include "glide/result.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glide::replay {

/// A line of a text file with its number, counted from one.
struct TextLine {
  int number = 0;
  std::string text;
};

/// The lines of a file that carry data: neither blank nor a comment (#). Line ends may be CRLF.
/// io when the file cannot be read.
Result<std::vector<TextLine>> readDataLines(const std::filesystem::path& file);

/// The whole file; io when it cannot be read.
Result<std::string> readFile(const std::filesystem::path& file);

/// Writes the whole file; io when that fails.
Status writeFile(const std::filesystem::path& file, std::string_view text);

/// The non-empty pieces of a text between any of the separator characters.
std::vector<std::string_view> splitFields(std::string_view text, std::string_view separators);

/// A finite number that fills the whole text, in the C locale.
std::optional<double> parseNumber(std::string_view text);
std::optional<std::int64_t> parseInteger(std::string_view text);

/// Decimal seconds to nanoseconds without a detour through double ("1403636584.763555584").
/// Digits beyond the ninth decimal are cut off.
std::optional<std::int64_t> parseSeconds(std::string_view text);

/// Nanoseconds as seconds with nine decimals; the inverse of parseSeconds.
std::string secondsText(std::int64_t t_ns);

/// The double next to t_ns / 1e9: what other tools read from secondsText(t_ns).
double toSeconds(std::int64_t t_ns);

/// An io error "FILE:LINE: message".
Error errorAt(const std::filesystem::path& file, int line, const std::string& message);
/// An io error "FILE: message".
Error errorIn(const std::filesystem::path& file, const std::string& message);

}  // namespace glide::replay
