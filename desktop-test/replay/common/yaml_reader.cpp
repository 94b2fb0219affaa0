#include "replay/common/yaml_reader.h"

#include "replay/common/text.h"

#include <cmath>
#include <utility>

namespace glide::replay {
namespace {

/// OpenCV writes "%YAML:1.0", which no YAML standard knows. The line stays, empty, for the numbers.
std::string withoutOpenCvHeader(std::string text) {
  if (text.rfind("%YAML:", 0) == 0) text.erase(0, std::min(text.find('\n'), text.size()));
  return text;
}

}  // namespace

YamlReader::YamlReader(std::filesystem::path file, const YAML::Node& root)
    : file_(std::move(file)), root_(root) {}

Result<YamlReader> YamlReader::open(const std::filesystem::path& file) {
  const Result<std::string> text = readFile(file);
  if (!text) return text.error();
  try {
    const YAML::Node root = YAML::Load(withoutOpenCvHeader(*text));
    if (!root.IsMap()) return errorIn(file, "is not a YAML map of fields");
    return YamlReader(file, root);
  } catch (const YAML::Exception& fault) {
    return errorAt(file, fault.mark.line + 1, fault.msg);
  }
}

void YamlReader::fail(const YAML::Node& node,
                      const std::string& field,
                      const std::string& message) {
  if (error_) return;
  error_ = errorAt(file_, node.Mark().line + 1, field + ": " + message);
}

std::optional<YAML::Node> YamlReader::required(const YAML::Node& map, const std::string& key) {
  const YAML::Node child = map[key];
  if (child.IsDefined() && !child.IsNull()) return child;
  fail(child.IsDefined() ? child : map, key, "is missing");
  return std::nullopt;
}

std::optional<double> YamlReader::number(const YAML::Node& map, const std::string& key) {
  const std::optional<YAML::Node> node = required(map, key);
  if (!node) return std::nullopt;
  const std::optional<double> value = asNumber(*node);
  if (!value) {
    const std::string shown = node->IsScalar() ? "'" + node->Scalar() + "'" : "a list or map";
    fail(*node, key, shown + " is not a number");
  }
  return value;
}

std::optional<int> YamlReader::integer(const YAML::Node& map, const std::string& key) {
  const std::optional<double> value = number(map, key);
  if (!value) return std::nullopt;
  if (*value != std::floor(*value) || std::abs(*value) > 1e9) {
    fail(map[key], key, "must be a whole number");
    return std::nullopt;
  }
  return static_cast<int>(*value);
}

std::optional<std::string> YamlReader::text(const YAML::Node& map, const std::string& key) {
  const std::optional<YAML::Node> node = required(map, key);
  if (!node) return std::nullopt;
  if (node->IsScalar()) return node->Scalar();
  fail(*node, key, "must be a single word");
  return std::nullopt;
}

std::optional<std::vector<double>> YamlReader::numbers(const YAML::Node& map,
                                                       const std::string& key) {
  const std::optional<YAML::Node> node = required(map, key);
  if (!node) return std::nullopt;
  if (!node->IsSequence()) {
    fail(*node, key, "must be a list of numbers");
    return std::nullopt;
  }
  std::vector<double> values;
  for (const YAML::Node& item : *node) {
    const std::optional<double> value = asNumber(item);
    if (!value) {
      fail(item, key, "has an entry that is not a number");
      return std::nullopt;
    }
    values.push_back(*value);
  }
  return values;
}

std::optional<std::vector<double>> YamlReader::numbers(const YAML::Node& map,
                                                       const std::string& key,
                                                       std::size_t count) {
  std::optional<std::vector<double>> values = numbers(map, key);
  if (values && values->size() != count) {
    fail(map[key],
         key,
         "has " + std::to_string(values->size()) + " numbers, expected " + std::to_string(count));
    return std::nullopt;
  }
  return values;
}

std::optional<double> asNumber(const YAML::Node& node) {
  return node.IsScalar() ? parseNumber(node.Scalar()) : std::nullopt;
}

}  // namespace glide::replay
