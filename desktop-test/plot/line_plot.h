#pragma once

#include <string>
#include <vector>

namespace glide::plot {

struct Point {
  double x = 0.0, y = 0.0;
};

/// Points joined by lines, with a name where there are several.
struct Curve {
  std::string name;
  std::vector<Point> points;
};

/// Curves over common axes, which start at zero.
struct Panel {
  std::string title;
  std::string x_unit;  ///< behind the numbers of the horizontal axis, for instance " min"
  std::vector<Curve> curves;
};

/// The panels one above the other, as a PNG; whether it could be written.
bool write(const std::vector<Panel>& panels, const std::string& file);

}  // namespace glide::plot
