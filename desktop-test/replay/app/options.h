#pragma once

#include "replay/outputs/render_view.h"
#include "replay/outputs/run_record.h"
#include "replay/readers/frame_source.h"

#include <filesystem>
#include <optional>
#include <string>
#include <variant>
#include <vector>

namespace glide::replay {

/// How the session gets the images.
enum class InputKind { luma, texture, external };
enum class Progress { automatic, plain, none };
enum class TrajectoryFrame { camera, body };

/// The command line, as given.
struct Options {
  std::string source;
  std::string calibration;  ///< file or preset; empty: what lies beside the source
  std::optional<std::filesystem::path> output;
  std::optional<std::filesystem::path> groundtruth;
  FrameSelection selection;
  std::optional<double> fps;
  Pace pace = Pace::lossless;
  InputKind input = InputKind::luma;
  TrajectoryFrame trajectory_frame = TrajectoryFrame::camera;
  Progress progress = Progress::automatic;
  bool json = false;
  std::optional<bool> report;  ///< none: report.html where this program can write it
  std::optional<double> require_tracked;
  bool print_config = false;
  std::optional<std::filesystem::path> config_file;
  std::optional<std::filesystem::path> map_in;   ///< loaded before the first frame
  std::optional<std::filesystem::path> map_out;  ///< written at the end
  std::optional<std::filesystem::path> render;   ///< video file or folder of pictures
  RenderView render_view = RenderView::split;    ///< of the pictures and the window
  bool viewer = false;                           ///< show it in a window
  std::vector<std::string> settings;             ///< key=value, the named shortcuts first, in order
};

/// What the process ends with, as CLI.md lists them.
enum ExitCode : int {
  kOk = 0,
  kUsage = 1,
  kUnreadableInput = 2,
  kNoGl = 3,
  kNeverInitialised = 4,
  kTrackedTooLittle = 5,
  kInterrupted = 130,  ///< as a shell says of a program that Ctrl-C ended: 128 + SIGINT
};

/// The options, or the exit code when the process should end now (help, version, usage error; the
/// text is already printed).
std::variant<Options, int> parseOptions(int argc, const char* const* argv);

}  // namespace glide::replay
