#include "replay/common/text.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <sstream>

namespace glide::replay {
namespace {

constexpr std::int64_t kNsPerSecond = 1'000'000'000;
constexpr int kDecimalsOfNs = 9;
constexpr std::size_t kMaxSecondDigits = 9;  // int64 nanoseconds reach to 9.2e9 s

std::string_view trimmed(std::string_view text) {
  constexpr std::string_view kBlank = " \t\r\n";
  const std::size_t first = text.find_first_not_of(kBlank);
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(kBlank) - first + 1);
}

bool isDigits(std::string_view text) {
  return text.find_first_not_of("0123456789") == std::string_view::npos;
}

}  // namespace

Result<std::string> readFile(const std::filesystem::path& file) {
  if (std::filesystem::is_directory(file)) return errorIn(file, "is a folder, not a file");
  std::ifstream stream(file, std::ios::binary);
  if (!stream) return errorIn(file, "cannot be opened");
  std::ostringstream text;
  text << stream.rdbuf();
  if (stream.bad()) return errorIn(file, "cannot be read");
  return text.str();
}

Result<std::vector<TextLine>> readDataLines(const std::filesystem::path& file) {
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  std::vector<TextLine> lines;
  std::istringstream stream(*text);
  int number = 0;
  for (std::string line; std::getline(stream, line);) {
    ++number;
    const std::string_view data = trimmed(line);
    if (!data.empty() && data.front() != '#') lines.push_back({number, std::string(data)});
  }
  return lines;
}

Status writeFile(const std::filesystem::path& file, std::string_view text) {
  std::ofstream stream(file, std::ios::binary);
  stream.write(text.data(), static_cast<std::streamsize>(text.size()));
  stream.close();
  if (!stream) return errorIn(file, "cannot be written");
  return Unit{};
}

std::vector<std::string_view> splitFields(std::string_view text, std::string_view separators) {
  std::vector<std::string_view> fields;
  std::size_t begin = text.find_first_not_of(separators);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
    fields.push_back(text.substr(begin, end - begin));
    begin = text.find_first_not_of(separators, end);
  }
  return fields;
}

std::optional<double> parseNumber(std::string_view text) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  double value = 0.0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size() || !std::isfinite(value)) {
    return std::nullopt;
  }
  return value;
}

std::optional<std::int64_t> parseInteger(std::string_view text) {
  std::int64_t value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return value;
}

std::optional<std::int64_t> parseSeconds(std::string_view text) {
  const bool is_negative = !text.empty() && text.front() == '-';
  const std::string_view digits = is_negative ? text.substr(1) : text;
  const std::size_t point = std::min(digits.find('.'), digits.size());
  const std::string_view whole = digits.substr(0, point);
  const std::string_view rest = digits.substr(std::min(point + 1, digits.size()));
  if (!isDigits(whole) || !isDigits(rest)) {  // an exponent, or no number at all
    const std::optional<double> value = parseNumber(text);
    if (!value || std::abs(*value) >= 1e9) return std::nullopt;
    return std::llround(*value * static_cast<double>(kNsPerSecond));
  }
  if (whole.size() + rest.size() == 0 || whole.size() > kMaxSecondDigits + 1) return std::nullopt;
  std::string fraction(rest.substr(0, kDecimalsOfNs));
  fraction.resize(kDecimalsOfNs, '0');
  const std::int64_t seconds = whole.empty() ? 0 : parseInteger(whole).value_or(0);
  if (seconds >= std::int64_t{9'000'000'000}) return std::nullopt;
  const std::int64_t t_ns = seconds * kNsPerSecond + parseInteger(fraction).value_or(0);
  return is_negative ? -t_ns : t_ns;
}

std::string secondsText(std::int64_t t_ns) {
  const std::int64_t magnitude = std::abs(t_ns);
  char text[40];
  std::snprintf(text,
                sizeof text,
                "%s%lld.%09lld",
                t_ns < 0 ? "-" : "",
                static_cast<long long>(magnitude / kNsPerSecond),
                static_cast<long long>(magnitude % kNsPerSecond));
  return text;
}

double toSeconds(std::int64_t t_ns) { return std::strtod(secondsText(t_ns).c_str(), nullptr); }

Error errorAt(const std::filesystem::path& file, int line, const std::string& message) {
  return {ErrorCode::io, file.string() + ":" + std::to_string(line) + ": " + message};
}

Error errorIn(const std::filesystem::path& file, const std::string& message) {
  return {ErrorCode::io, file.string() + ": " + message};
}

}  // namespace glide::replay
