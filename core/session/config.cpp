#include "glide/config.h"

#include "geometry/camera_model.h"

#include "glide/config_fields.h"
#include "glide/enum_names.h"

#include <optional>
#include <sstream>
#include <string>
#include <type_traits>
#include <vector>

namespace glide {
namespace {

std::string shown(double value) {
  std::ostringstream text;
  text << value;
  return text.str();
}

/// Remembers the first field that is out of its range.
class RangeCheck {
 public:
  template <class T>
  void operator()(const FieldInfo& field, const T& value) {
    if (fault_) return;
    if constexpr (std::is_enum_v<T>) {
      if (enumName(value) == "?") fault_ = std::string(field.name) + " is not a known value";
    } else if constexpr (std::is_arithmetic_v<T>) {
      checkNumber(field, static_cast<double>(value));
    }
  }
  const std::optional<std::string>& fault() const { return fault_; }

 private:
  void checkNumber(const FieldInfo& field, double value) {
    if (value >= field.min && value <= field.max) return;  // false for NaN
    fault_ = std::string(field.name) + " = " + shown(value) + " is outside " + shown(field.min) +
             ".." + shown(field.max);
    if (!field.unit.empty()) *fault_ += " " + std::string(field.unit);
  }

  std::optional<std::string> fault_;
};

/// Conditions that no single field's range can express.
std::optional<std::string> relationFault(const Config& config) {
  if (config.direct.patch_size % 2 == 0) return "direct.patch_size must be odd";
  if (config.direct.min_points > config.direct.max_points) {
    return "direct.min_points exceeds direct.max_points";
  }
  if (config.features.fast_threshold_low > config.features.fast_threshold) {
    return "features.fast_threshold_low exceeds features.fast_threshold";
  }
  if (config.keyframes.min_interval > config.keyframes.max_interval) {
    return "keyframes.min_interval exceeds keyframes.max_interval";
  }
  if (config.initialization.min_landmarks > config.initialization.min_matches) {
    return "initialization.min_landmarks exceeds initialization.min_matches";
  }
  return std::nullopt;
}

}  // namespace

Status validate(const Config& config) {
  RangeCheck check;
  forEachField(config, check);
  std::optional<std::string> fault = check.fault();
  if (!fault) fault = relationFault(config);
  if (fault) return Error{ErrorCode::invalid_argument, *fault};
  const Result<CameraModel> camera = CameraModel::create(config.camera);
  if (!camera) return camera.error();
  return Unit{};
}

}  // namespace glide
