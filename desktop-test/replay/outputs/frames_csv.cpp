#include "replay/outputs/frames_csv.h"

#include "glide/enum_names.h"

#include <fmt/format.h>

#include <iterator>

namespace glide::replay {

std::string framesCsv(const RunRecord& run) {
  std::string text =
      "index,t_ns,state,tracker,switch_reason,update_ms,mapping_ms,pyramid_ms,precompute_ms,"
      "align_ms,features_ms,match_ms,pose_ms,visible,inliers,rms,keyframe,map_revision\n";
  for (const FrameRecord& frame : run.frames) {
    const FrameResult& result = frame.result;
    const FrameStats& stats = result.stats;
    fmt::format_to(std::back_inserter(text),
                   "{},{},{},{},{},",
                   frame.index,
                   result.t_ns,
                   enumName(result.state),
                   enumName(result.tracker),
                   enumName(result.switch_reason));
    fmt::format_to(std::back_inserter(text),
                   "{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},{:.3f},",
                   stats.update_ms,
                   stats.mapping_ms,
                   stats.pyramid_ms,
                   stats.precompute_ms,
                   stats.align_ms,
                   stats.features_ms,
                   stats.match_ms,
                   stats.pose_ms);
    fmt::format_to(std::back_inserter(text),
                   "{},{},{:.6f},{:d},{}\n",
                   stats.visible,
                   stats.inliers,
                   stats.rms,
                   stats.keyframe,
                   result.map_revision);
  }
  return text;
}

}  // namespace glide::replay
