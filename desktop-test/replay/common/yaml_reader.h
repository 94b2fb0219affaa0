#pragma once

#include "glide/result.h"

#include <yaml-cpp/yaml.h>

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glide::replay {

/// A YAML (or JSON) document whose errors name file, line and field. OpenCV's "%YAML:1.0" first
/// line is accepted. Getters return the value, or nothing after remembering the first error; so a
/// reader asks for all its fields and then looks at error() once.
class YamlReader {
 public:
  /// io when the file cannot be read or is no YAML map.
  static Result<YamlReader> open(const std::filesystem::path& file);

  const YAML::Node& root() const { return root_; }

  /// The value of a required number, text or list of `count` numbers.
  std::optional<double> number(const YAML::Node& map, const std::string& key);
  std::optional<std::string> text(const YAML::Node& map, const std::string& key);
  std::optional<std::vector<double>> numbers(const YAML::Node& map, const std::string& key);
  std::optional<std::vector<double>> numbers(const YAML::Node& map,
                                             const std::string& key,
                                             std::size_t count);
  /// A required whole number.
  std::optional<int> integer(const YAML::Node& map, const std::string& key);

  /// Remembers an error at a node unless there is one already. A key that is not in the file has no
  /// line of its own: pass the map that should have it.
  void fail(const YAML::Node& node, const std::string& field, const std::string& message);

  const std::optional<Error>& error() const { return error_; }

 private:
  YamlReader(std::filesystem::path file, const YAML::Node& root);
  /// The child, or nothing after an error "missing".
  std::optional<YAML::Node> required(const YAML::Node& map, const std::string& key);

  std::filesystem::path file_;
  YAML::Node root_;
  std::optional<Error> error_;
};

/// A scalar node as a finite number.
std::optional<double> asNumber(const YAML::Node& node);

}  // namespace glide::replay
