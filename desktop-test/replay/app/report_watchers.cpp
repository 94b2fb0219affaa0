#include "replay/app/report_watchers.h"

#include "replay/outputs/report_template.h"
#include "replay/outputs/report_watcher.h"

#include <memory>
#include <string>

namespace glide::replay {

/// By default no run fails for want of the page.
std::optional<Failure> addReportWatcher(Job& job) {
  if (!job.options.report.value_or(true)) return std::nullopt;
  if (!reportTemplate().empty()) {
    job.watchers.push_back(std::make_unique<ReportWatcher>());
    return std::nullopt;
  }
  const std::string why = "this program was built without the page of report.html, which takes npm";
  if (job.options.report) return Failure{kUsage, "--report: " + why};
  job.log.note("no report.html: " + why);
  return std::nullopt;
}

}  // namespace glide::replay
