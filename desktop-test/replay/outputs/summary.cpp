#include "replay/outputs/summary.h"

#include "replay/common/terminal.h"

#include "glide/enum_names.h"

#include <fmt/format.h>

namespace glide::replay {
namespace {

/// Text in a colour, where colours are wanted.
class Painter {
 public:
  explicit Painter(bool has_color) : has_color_(has_color) {}
  std::string operator()(std::string_view text, Ink ink) const {
    return InkedText(has_color_).add(text, ink).text();
  }

 private:
  const bool has_color_;
};

std::string row(const std::string& label, const std::string& text) {
  return fmt::format("  {:<14} {}\n", label, text);
}

std::string header(const RunRecord& run, const Painter& painted) {
  const Config& config = run.config;
  const std::string& renderer = run.backend.renderer;
  std::string tracker(enumName(config.tracker));
  if (config.tracker == TrackerMode::hybrid) {
    tracker += fmt::format(" on {}{}, patch {}, {} levels",
                           enumName(run.backend.backend),
                           renderer.empty() ? "" : " (" + renderer + ")",
                           config.direct.patch_size,
                           config.direct.levels);
  }
  return fmt::format("\n{}  {}x{}  |  {}  |  {}, {}\n\n",
                     painted(run.source.name, Ink::strong),
                     run.source.width,
                     run.source.height,
                     tracker,
                     config.execution == Execution::inline_ ? "deterministic" : "threaded",
                     run.pace == Pace::lossless ? "lossless" : "realtime");
}

std::string frameRows(const RunRecord& run, const FrameCounts& counts, const Painter& painted) {
  std::string text = row(
      "frames",
      fmt::format(
          "{} in: {} tracked, {}, {} initialising{}",
          counts.in,
          counts.tracked,
          painted(fmt::format("{} lost", counts.lost), counts.lost > 0 ? Ink::alarm : Ink::plain),
          counts.initializing,
          run.pace == Pace::realtime ? fmt::format("; {} dropped", counts.dropped) : ""));
  for (const Skip& skip : run.skips) text += row("", describe(skip, run.source.listed));
  if (!counts.first_pose_index) {
    return text +
           row("tracked", painted("never initialised: " + initializationHint(run), Ink::alarm));
  }
  text += row("tracked",
              fmt::format("{:.1f} % of the frames since the first pose, which is at frame {}",
                          100.0 * counts.tracked_ratio,
                          *counts.first_pose_index));
  return text +
         row("direct share",
             fmt::format("{:.1f} %  ({}, {})",
                         100.0 * counts.direct_share,
                         painted(fmt::format("{} direct", counts.direct), Ink::direct),
                         painted(fmt::format("{} indirect", counts.indirect), Ink::indirect)));
}

std::string meters(const std::optional<AbsoluteError>& error) {
  return error ? fmt::format("{:.4f}", error->rmse_m) : "-";
}

std::string accuracyRows(const FrameCounts& counts, const std::optional<Accuracy>& accuracy) {
  if (counts.tracked == 0) return "";
  if (!accuracy) return row("accuracy", "no ground truth");
  if (!accuracy->final_error) {
    return row("accuracy",
               fmt::format("{} poses have a ground truth, too few to align", accuracy->matched));
  }
  std::string text = row("ATE rmse, m",
                         fmt::format("final {}   live {}   keyframes {}   (max {:.4f}, {} poses)",
                                     meters(accuracy->final_error),
                                     meters(accuracy->live_error),
                                     meters(accuracy->keyframe_error),
                                     accuracy->final_error->max_m,
                                     accuracy->matched));
  if (!accuracy->relative_error) return text;
  return text + row("RPE over 1 s",
                    fmt::format("{:.4f} m, {:.3f} deg",
                                accuracy->relative_error->trans_m,
                                accuracy->relative_error->rot_deg));
}

std::string spreadText(const std::string& name, const std::optional<Spread>& spread) {
  if (!spread) return name + " -";
  return fmt::format("{} {:.2f} / {:.2f}", name, spread->median, spread->p95);
}

std::string lensRow(const RunRecord& run) {
  if (!run.map->corrected_camera) return "";
  const std::vector<double>& given = run.config.camera.coefficients;
  return row("lens",
             fmt::format("k1 corrected from {:.4f} to {:.4f}",
                         given.empty() ? 0.0 : given.front(),
                         run.map->corrected_camera->coefficients.front()));
}

std::string costRows(const RunRecord& run, const Painter& painted) {
  const auto direct = updateSpread(run, TrackerKind::direct);
  const auto indirect = updateSpread(run, TrackerKind::indirect);
  const std::string ratio =
      direct && indirect && direct->median > 0.0
          ? fmt::format("   (direct {:.1f} x faster)", indirect->median / direct->median)
          : "";
  std::string text = row("ms median/p95",
                         painted(spreadText("direct", direct), Ink::direct) + "   " +
                             painted(spreadText("indirect", indirect), Ink::indirect) + "   " +
                             spreadText("all", updateSpread(run, std::nullopt)) + ratio);
  int keyframes = 0;
  for (const MapView::Keyframe& keyframe : run.map->keyframes) keyframes += !keyframe.retired;
  const std::string resets =
      run.map->resets > 0 ? fmt::format(", started over {} times", run.map->resets) : "";
  text += row(
      "map",
      fmt::format("{} keyframes, {} landmarks{}", keyframes, run.map->landmarks.size(), resets));
  return text + lensRow(run) + row("wall", fmt::format("{:.1f} s", run.wall_s));
}

}  // namespace

std::string initializationHint(const RunRecord& run) {
  if (run.frames.empty()) return "no frame";
  const InitializationProgress& progress = run.frames.back().result.initialization;
  switch (progress.status) {
    case InitializationStatus::waiting_for_image:
      return "too few features (dark, blurred or blank images)";
    case InitializationStatus::too_few_matches:
      return fmt::format("too few matches ({}) with the first view", progress.matches);
    case InitializationStatus::too_little_motion:
      return fmt::format("too little motion (parallax {:.2f} deg): move the camera sideways",
                         progress.parallax_deg);
    case InitializationStatus::pure_rotation:
      return "the camera turned but did not move: move it sideways";
    case InitializationStatus::ambiguous:
      return "two explanations fit equally well: keep moving";
    case InitializationStatus::done:
      break;
  }
  return "the map was given up";
}

std::string summaryText(const SummaryInput& input) {
  const Painter painted(input.has_color);
  return header(input.run, painted) + frameRows(input.run, input.counts, painted) +
         accuracyRows(input.counts, input.accuracy) + costRows(input.run, painted) +
         row("output", input.output.string());
}

}  // namespace glide::replay
