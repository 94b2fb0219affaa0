#include "glide/config_text.h"

#include "glide/config_fields.h"
#include "glide/enum_names.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <locale>
#include <numeric>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace glide {
namespace {

constexpr std::size_t kMaxSuggestionDistance = 4;  // edits; farther names would only confuse

using Fault = std::optional<std::string>;

std::string quoted(std::string_view text) { return "'" + std::string(text) + "'"; }

/// A number that fills the whole text, in the C locale whatever the app's is.
template <class T>
std::optional<T> parse(std::string_view text) {
  std::istringstream stream{std::string(text)};
  stream.imbue(std::locale::classic());
  T value{};
  stream >> std::noskipws >> value;
  if (stream.fail() || stream.peek() != std::istringstream::traits_type::eof()) return std::nullopt;
  return value;
}

Fault parseInto(std::string_view text, double& target) {
  const std::optional<double> value = parse<double>(text);
  if (!value || !std::isfinite(*value)) return quoted(text) + " is not a number";
  target = *value;
  return std::nullopt;
}

Fault parseInto(std::string_view text, int& target) {
  const std::optional<int> value = parse<int>(text);
  if (!value) return quoted(text) + " is not a whole number";
  target = *value;
  return std::nullopt;
}

Fault parseInto(std::string_view text, std::vector<double>& target) {
  constexpr std::string_view kSeparators = "[], ";
  std::vector<double> values;
  while (!text.empty()) {
    const std::size_t length = std::min(text.find_first_of(kSeparators), text.size());
    double value = 0.0;
    if (length > 0) {
      if (Fault fault = parseInto(text.substr(0, length), value)) return fault;
      values.push_back(value);
    }
    text.remove_prefix(std::min(length + 1, text.size()));
  }
  target = std::move(values);
  return std::nullopt;
}

Fault parseInto(std::string_view text, std::string& target) {
  target = std::string(text);
  return std::nullopt;
}

template <class E, std::enable_if_t<std::is_enum_v<E>, int> = 0>
Fault parseInto(std::string_view text, E& target) {
  const std::optional<E> value = enumFromName<E>(text);
  if (!value) {
    std::string names;
    for (const EnumName<E>& entry : enumNames(E{})) {
      names += (names.empty() ? "" : ", ") + std::string(entry.name);
    }
    return quoted(text) + " is none of " + names;
  }
  target = *value;
  return std::nullopt;
}

/// Levenshtein's.
std::size_t editDistance(std::string_view a, std::string_view b) {
  std::vector<std::size_t> row(b.size() + 1);
  std::iota(row.begin(), row.end(), std::size_t{0});
  for (std::size_t i = 1; i <= a.size(); ++i) {
    std::size_t diagonal = std::exchange(row[0], i);
    for (std::size_t j = 1; j <= b.size(); ++j) {
      const std::size_t replaced = diagonal + (a[i - 1] == b[j - 1] ? 0 : 1);
      diagonal = row[j];
      row[j] = std::min({replaced, row[j] + 1, row[j - 1] + 1});
    }
  }
  return row.back();
}

std::string unknownField(std::string_view name) {
  std::string best;
  std::size_t best_distance = kMaxSuggestionDistance + 1;
  const Config config;
  forEachField(config, [&](const FieldInfo& field, const auto&) {
    const std::size_t dot = field.name.find('.');
    const std::string_view leaf =
        dot == std::string_view::npos ? field.name : field.name.substr(dot + 1);
    const std::size_t distance = leaf == name ? 0 : editDistance(name, field.name);
    if (distance >= best_distance) return;
    best_distance = distance;
    best = field.name;
  });
  const std::string hint =
      best.empty() ? "./glide replay --print-config lists all" : "did you mean " + best + "?";
  return "no config field of this name; " + hint;
}

}  // namespace

Status setField(Config& config, std::string_view name, std::string_view text) {
  bool is_known = false;
  Fault fault;
  forEachField(config, [&](const FieldInfo& field, auto& target) {
    if (field.name != name) return;
    is_known = true;
    fault = parseInto(text, target);
  });
  if (!is_known) fault = unknownField(name);
  if (fault) return Error{ErrorCode::invalid_argument, *std::move(fault)};
  return Unit{};
}

Status applySetting(Config& config, std::string_view setting) {
  const std::size_t equals = setting.find('=');
  if (equals == std::string_view::npos) {
    return Error{ErrorCode::invalid_argument, quoted(setting) + " is not of the form name=value"};
  }
  const std::string_view name = setting.substr(0, equals);
  Status set = setField(config, name, setting.substr(equals + 1));
  if (!set) return Error{set.error().code, std::string(name) + ": " + set.error().message};
  return set;
}

}  // namespace glide
