#include "replay/app/config_io.h"

#include "replay/common/yaml_reader.h"

#include "glide/config_fields.h"
#include "glide/config_text.h"
#include "glide/enum_names.h"

#include <fmt/format.h>

#include <optional>
#include <string_view>
#include <type_traits>

namespace glide::replay {
namespace {

template <class E>
std::string allNames(E) {
  std::string names;
  for (const EnumName<E>& entry : enumNames(E{})) {
    names += (names.empty() ? "" : ", ") + std::string(entry.name);
  }
  return names;
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
    const Status set = text ? setField(config, name, *text)
                            : Status(Error{ErrorCode::io, "must be a value or a list"});
    if (!set) yaml.fail(entry.first, name, set.error().message);
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
