#include "replay/app/config_io.h"

#include "replay/common/text.h"
#include "replay/common/yaml_reader.h"

#include "glide/config_fields.h"
#include "glide/enum_names.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <string_view>
#include <type_traits>

namespace glide::replay {
namespace {

constexpr std::size_t kMaxSuggestionDistance = 4;  // edits; farther names would only confuse

using Fault = std::optional<std::string>;

template <class E>
std::string allNames(E) {
  std::string names;
  for (const EnumName<E>& entry : enumNames(E{})) {
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  return names;
}

Fault parseInto(const std::string& text, double& target) {
  const std::optional<double> value = parseNumber(text);
  if (!value) return "'" + text + "' is not a number";
  target = *value;
  return std::nullopt;
}

Fault parseInto(const std::string& text, int& target) {
  const std::optional<std::int64_t> value = parseInteger(text);
  if (!value || std::abs(*value) > std::numeric_limits<int>::max()) {
    return "'" + text + "' is not a whole number";
  }
  target = static_cast<int>(*value);
  return std::nullopt;
}

Fault parseInto(const std::string& text, std::vector<double>& target) {
  target.clear();
  for (const std::string_view item : splitFields(text, "[], ")) {
    const std::optional<double> value = parseNumber(item);
    if (!value) return "'" + std::string(item) + "' is not a number";
    target.push_back(*value);
  }
  return std::nullopt;
}

Fault parseInto(const std::string& text, std::string& target) {
  target = text;
  return std::nullopt;
}

template <class E, std::enable_if_t<std::is_enum_v<E>, int> = 0>
Fault parseInto(const std::string& text, E& target) {
  const std::optional<E> value = enumFromName<E>(text);
  if (!value) return "'" + text + "' is none of " + allNames(target);
  target = *value;
  return std::nullopt;
}

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

std::string unknownField(const std::string& name) {
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
  const std::string hint = best.empty() ? "--print-config lists all" : "did you mean " + best + "?";
  return "no config field of this name; " + hint;
}

Fault setField(const std::string& name, const std::string& text, Config& config) {
  bool is_known = false;
  Fault fault;
  forEachField(config, [&](const FieldInfo& field, auto& target) {
    if (field.name != name) return;
    is_known = true;
    fault = parseInto(text, target);
  });
  return is_known ? fault : unknownField(name);
}

/// A YAML value as the text that --set would take.
std::optional<std::string> settingText(const YAML::Node& value) {
  if (value.IsScalar()) return value.Scalar();
  if (!value.IsSequence()) return std::nullopt;
  std::string text;
  for (const YAML::Node& item : value) {
    if (!item.IsScalar()) return std::nullopt;
    text += item.Scalar() + " ";
  }
  return text;
}

void applyNode(const YAML::Node& map, const std::string& prefix, YamlReader& yaml, Config& config) {
  for (const auto& entry : map) {
    const std::string name = prefix + entry.first.as<std::string>("");
    if (entry.second.IsMap()) {
      applyNode(entry.second, name + ".", yaml, config);
      continue;
    }
    const std::optional<std::string> text = settingText(entry.second);
    const Fault fault = text ? setField(name, *text, config) : Fault("must be a value or a list");
    if (fault) yaml.fail(entry.first, name, *fault);
  }
}

template <class T>
std::string valueText(const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return std::string(enumName(value));
  } else if constexpr (std::is_arithmetic_v<T>) {
    return fmt::format("{}", value);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return value.empty() ? "\"\"" : value;
  } else {
    return fmt::format("[{}]", fmt::join(value, ", "));
  }
}

template <class T>
std::string rangeText(const FieldInfo& field, const T& value) {
  if constexpr (std::is_enum_v<T>) {
    return allNames(value);
  } else if constexpr (std::is_arithmetic_v<T>) {
    return fmt::format(
        "{}{}{:g}..{:g}", field.unit, field.unit.empty() ? "" : ", ", field.min, field.max);
  } else if constexpr (std::is_same_v<T, std::string>) {
    return "text";
  } else {
    return "as many as the model says";
  }
}

}  // namespace

Status applySetting(const std::string& key_value, Config& config) {
  const std::size_t equals = key_value.find('=');
  if (equals == std::string::npos) {
    return Error{ErrorCode::invalid_argument, "'" + key_value + "' is not of the form key=value"};
  }
  const std::string key = key_value.substr(0, equals);
  const Fault fault = setField(key, key_value.substr(equals + 1), config);
  if (fault) return Error{ErrorCode::invalid_argument, key + ": " + *fault};
  return Unit{};
}

Status applyConfigFile(const std::filesystem::path& file, Config& config) {
  Result<YamlReader> yaml = YamlReader::open(file);
  if (!yaml) return yaml.error();
  applyNode(yaml->root(), "", *yaml, config);
  if (yaml->error()) return *yaml->error();
  return Unit{};
}

std::string configYaml(const Config& config) {
  std::string text, section;
  const bool has_camera = config.camera.fx > 0.0;
  forEachField(config, [&](const FieldInfo& field, const auto& value) {
    if (!has_camera && field.name.rfind("camera.", 0) == 0) return;
    const std::size_t dot = field.name.find('.');
    const bool is_nested = dot != std::string_view::npos;
    const std::string parent(is_nested ? field.name.substr(0, dot) : "");
    if (parent != section && is_nested) text += parent + ":\n";
    section = parent;
    const std::string_view leaf = is_nested ? field.name.substr(dot + 1) : field.name;
    const std::string line = fmt::format("{}{}: {}", is_nested ? "  " : "", leaf, valueText(value));
    text += fmt::format("{:<40} # {}\n", line, rangeText(field, value));
  });
  return text;
}

}  // namespace glide::replay
