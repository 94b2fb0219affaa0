// glide-report-samples DIR: for each sample run NAME.html, and of the tour the files that its
// report offers.
#include "replay/common/text.h"
#include "replay/evaluation/evaluate.h"
#include "replay/outputs/map_ply.h"
#include "replay/outputs/report_data.h"
#include "replay/outputs/report_html.h"
#include "replay/outputs/report_template.h"
#include "replay/outputs/statistics.h"
#include "report/samples/sample_runs.h"

#include <filesystem>
#include <iostream>

namespace glide::replay {
namespace {

bool writeSample(const std::filesystem::path& folder,
                 const std::string& name,
                 const SampleRun& sample) {
  const RunTrajectories trajectories = buildTrajectories(sample.run);
  const FrameCounts counts = countFrames(sample.run, trajectories);
  std::optional<Accuracy> accuracy;
  if (sample.truth) {
    accuracy = evaluate(*sample.truth, trajectories.camera);
    accuracy->truth_file = "/data/groundtruth.txt";
  }
  const FinishedRun finished{
      sample.run, trajectories, counts, accuracy, sample.truth, folder, sample.colors};
  const std::string html = reportHtml(reportTemplate(), reportData(finished, sample.pictures));
  return writeFile(folder / (name + ".html"), html).ok() &&
         writeFile(folder / (name + ".tum"), tumText(trajectories.camera.recomposed)).ok() &&
         writeFile(folder / (name + ".ply"), mapPly(*sample.run.map, sample.colors)).ok();
}

int run(const std::filesystem::path& folder) {
  if (reportTemplate().empty()) {
    std::cerr << "glide-report-samples: built without the page, which takes npm\n";
    return 1;
  }
  std::filesystem::create_directories(folder);
  const bool is_written = writeSample(folder, "tour", sampleTour()) &&
                          writeSample(folder, "without_map", sampleWithoutMap()) &&
                          writeSample(folder, "given_up", sampleGivenUp()) &&
                          writeSample(folder, "without_frames", sampleWithoutFrames());
  return is_written ? 0 : 1;
}

}  // namespace
}  // namespace glide::replay

int main(int argc, char** argv) {
  if (argc != 2) {
    std::cerr << "usage: glide-report-samples DIR\n";
    return 1;
  }
  return glide::replay::run(argv[1]);
}
