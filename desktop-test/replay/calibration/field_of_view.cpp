#include "replay/calibration/field_of_view.h"

#include "replay/common/text.h"

#include <algorithm>
#include <cmath>

namespace glide::replay {
namespace {

constexpr char kPrefix[] = "fov:";
constexpr double kNarrowest_deg = 10.0, kWidest_deg = 150.0;  // beyond, no pinhole is near
constexpr double kRadPerDeg = 3.14159265358979323846 / 180.0;

}  // namespace

bool isFieldOfView(const std::string& text) { return text.rfind(kPrefix, 0) == 0; }

Result<Calibration> calibrationOfField(const std::string& text, int width, int height) {
  const std::optional<double> fov_deg = parseNumber(text.substr(sizeof kPrefix - 1));
  if (!fov_deg || *fov_deg < kNarrowest_deg || *fov_deg > kWidest_deg) {
    return Error{ErrorCode::invalid_argument,
                 text + ": write fov: and 10 to 150 degrees along the longer side, as in fov:69"};
  }
  // Pixel (0, 0) is the centre of the first pixel: the image reaches from -0.5 to size - 0.5.
  const double focal = 0.5 * std::max(width, height) / std::tan(0.5 * *fov_deg * kRadPerDeg);
  Calibration calibration;
  calibration.camera.width = width;
  calibration.camera.height = height;
  calibration.camera.fx = calibration.camera.fy = focal;
  calibration.camera.cx = 0.5 * (width - 1);
  calibration.camera.cy = 0.5 * (height - 1);
  calibration.origin = text;
  return calibration;
}

}  // namespace glide::replay
