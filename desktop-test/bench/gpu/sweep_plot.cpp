#include "bench/gpu/sweep_plot.h"

#include "bench/gpu/report.h"
#include "plot/line_plot.h"

namespace glide::gpubench {

bool writePlot(const Sweep& sweep, const std::string& file) {
  plot::Panel points{
      "ms a frame over points, patch " + std::to_string(sweep.workload.patch), "", {}};
  plot::Panel patches{"ms a frame over pixels of a patch (side 5 to 13), " +
                          std::to_string(sweep.workload.points) + " points",
                      "",
                      {}};
  for (std::size_t plan = 0; plan < sweep.plans.size(); ++plan) {
    plot::Curve by_points{planName(sweep.plans[plan]), {}};
    plot::Curve by_patch = by_points;
    for (const SweepPoint& at : sweep.points) {
      by_points.points.push_back({static_cast<double>(at.points), at.frame_ms[plan]});
    }
    for (const SweepPoint& at : sweep.patches) {
      by_patch.points.push_back({1.0 * at.patch * at.patch, at.frame_ms[plan]});
    }
    points.curves.push_back(std::move(by_points));
    patches.curves.push_back(std::move(by_patch));
  }
  return plot::write({points, patches}, file);
}

}  // namespace glide::gpubench
