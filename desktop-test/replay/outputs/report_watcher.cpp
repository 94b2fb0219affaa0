#include "replay/outputs/report_watcher.h"

#include "replay/common/text.h"
#include "replay/outputs/report_data.h"
#include "replay/outputs/report_html.h"
#include "replay/outputs/report_template.h"

namespace glide::replay {

Status ReportWatcher::onFrame(const FrameMoment& moment) {
  if (strip_.wantsNext(moment.record.result.stats.keyframe)) {
    strip_.add(thumbnailJpeg(moment.frame));
  }
  return Unit{};
}

Status ReportWatcher::onEnd(const FinishedRun& finished) {
  const auto data = reportData(finished, strip_.pictures());
  return writeFile(finished.output / "report.html", reportHtml(reportTemplate(), data));
}

}  // namespace glide::replay
