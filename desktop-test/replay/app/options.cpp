#include "replay/app/options.h"

#include "replay/outputs/render_path.h"

#include "glide/version.h"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <utility>

namespace glide::replay {
namespace {

/// What CLI11 fills and only later becomes Options.
struct Raw {
  Options options;
  std::optional<std::string> backend, tracker, patch, levels, max_direct_frames;
  std::vector<std::string> settings;
  bool deterministic = false;
  bool localize_only = false;
  bool report = true;
  const CLI::Option* report_flag = nullptr;
};

std::string renderProblem(const std::string& path) {
  return problemOfRenderPath(path).value_or("");
}

/// A validator whose own description stays out of --help; type_name() says it shorter.
CLI::Validator plain(CLI::Validator validator) { return validator.description(""); }

void addInputs(CLI::App& app, Raw& raw) {
  Options& options = raw.options;
  app.add_option("SOURCE",
                 options.source,
                 "TUM RGB-D folder, EuRoC ASL folder, video file or folder of images;\n"
                 "a prefix tum: euroc: video: images: forces the kind")
      ->type_name("");
  app.add_option("-c,--calibration",
                 options.calibration,
                 "EuRoC, Kalibr, ORB-SLAM, stella or own YAML, a preset\n"
                 "freiburg1|2|3, or fov:DEG, the field of view along the\n"
                 "longer side (default: what lies beside the source)")
      ->type_name("FILE|PRESET|fov:DEG");
  app.add_option("--gt", options.groundtruth, "ground truth, TUM text or EuRoC csv")
      ->type_name("FILE");
  app.add_option("--start", options.selection.start_s, "seconds to skip at the start")
      ->check(plain(CLI::NonNegativeNumber))
      ->type_name("S");
  app.add_option("--duration", options.selection.duration_s, "seconds to replay")
      ->check(plain(CLI::PositiveNumber))
      ->type_name("S");
  app.add_option("--stride", options.selection.stride, "use every N-th frame")
      ->check(plain(CLI::Range(1, 1000000)))
      ->type_name("N");
  app.add_option("--max-frames", options.selection.max_frames, "stop after N frames")
      ->check(plain(CLI::Range(1, 1000000000)))
      ->type_name("N");
  app.add_option("--fps",
                 options.fps,
                 "frame rate of an image folder or video (default: from file\n"
                 "names or container, else 30)")
      ->check(plain(CLI::Range(0.01, 10000.0)))
      ->type_name("F");
}

void addTracking(CLI::App& app, Raw& raw) {
  Options& options = raw.options;
  app.add_option(
         "--backend",
         raw.backend,
         "where the direct tracker runs; auto: gles on hardware GL, else cpu\n(default: auto)")
      ->check(plain(CLI::IsMember({"auto", "gles", "cpu"})))
      ->type_name("auto|gles|cpu");
  const std::map<std::string, InputKind> inputs = {{"luma", InputKind::luma},
                                                   {"texture", InputKind::texture},
                                                   {"external", InputKind::external}};
  app.add_option("--input",
                 options.input,
                 "how the session gets the images: pixels, an RGBA8 texture, or an\n"
                 "external texture as of an Android camera (default: luma)")
      ->transform(plain(CLI::CheckedTransformer(inputs)))
      ->type_name("luma|texture|external");
  app.add_option("--tracker", raw.tracker, "hybrid, or indirect for every frame (default: hybrid)")
      ->check(plain(CLI::IsMember({"hybrid", "indirect"})))
      ->type_name("hybrid|indirect");
  app.add_flag("--deterministic",
               raw.deterministic,
               "mapping inline: the same bytes on every run (default: threads)");
  const std::map<std::string, Pace> paces = {{"lossless", Pace::lossless},
                                             {"realtime", Pace::realtime}};
  app.add_option("--pace",
                 options.pace,
                 "lossless: the next frame waits until the mapper has room;\n"
                 "realtime: by timestamps, late frames drop (default: lossless)")
      ->transform(plain(CLI::CheckedTransformer(paces)))
      ->type_name("lossless|realtime");
}

void addConfig(CLI::App& app, Raw& raw) {
  Options& options = raw.options;
  app.add_option("--patch", raw.patch, "patch size of the direct tracker, px, odd")->type_name("N");
  app.add_option("--levels", raw.levels, "pyramid levels of the direct tracker")->type_name("N");
  app.add_option("--max-direct-frames", raw.max_direct_frames, "direct frames per reference")
      ->type_name("N");
  app.add_option("--set", raw.settings, "any config field, e.g. direct.max_rms=20; repeatable")
      ->type_name("KEY=VALUE")
      ->take_all()
      ->expected(1);
  app.add_option("--config", options.config_file, "YAML or JSON file of config fields")
      ->type_name("FILE");
  app.add_flag("--print-config", options.print_config, "print the config as YAML and stop");
}

void addMaps(CLI::App& app, Raw& raw) {
  Options& options = raw.options;
  auto* map_in = app.add_option("--map-in", options.map_in, "start in the map of this file")
                     ->type_name("FILE");
  app.add_option("--map-out", options.map_out, "save the map to this file at the end")
      ->type_name("FILE");
  app.add_flag("--localize-only",
               raw.localize_only,
               "only find the camera in the map of --map-in, do not extend it")
      ->needs(map_in);
}

void addPictures(CLI::App& app, Raw& raw) {
  Options& options = raw.options;
  app.add_option("--render",
                 options.render,
                 "draw the replay into a video (.mp4, .mkv, .avi) or a folder of\n"
                 "numbered PNGs: the camera's view and the map in 3-D")
      ->check(plain(CLI::Validator(renderProblem, "")))
      ->type_name("FILE|DIR");
  const std::map<std::string, RenderView> views = {
      {"split", RenderView::split}, {"map", RenderView::map}, {"ar", RenderView::ar}};
  app.add_option("--render-view",
                 options.render_view,
                 "split (default), map: the map alone, or ar: the camera's\n"
                 "picture with cubes that stand in the scene")
      ->transform(plain(CLI::CheckedTransformer(views)))
      ->type_name("split|map|ar");
  app.add_flag("--viewer",
               options.viewer,
               "show the same in a window: space pauses, . steps, f follows or\n"
               "holds, the mouse turns and zooms, q ends the replay");
  raw.report_flag = app.add_flag("--report,!--no-report",
                                 raw.report,
                                 "write report.html, a page with the map in 3-D and "
                                 "charts\n(default: where npm was there to build the page)");
}

void addOutputs(CLI::App& app, Raw& raw) {
  Options& options = raw.options;
  app.add_option("-o,--output", options.output, "output folder (default: out/<name>-<time>)")
      ->type_name("DIR");
  const std::map<std::string, TrajectoryFrame> frames = {{"cam", TrajectoryFrame::camera},
                                                         {"body", TrajectoryFrame::body}};
  app.add_option("--trajectory-frame",
                 options.trajectory_frame,
                 "whose poses the trajectories tell; body needs T_BS in the\n"
                 "calibration and ground truth for its scale (default: cam)")
      ->transform(plain(CLI::CheckedTransformer(frames)))
      ->type_name("cam|body");
  const std::map<std::string, Progress> progress = {
      {"auto", Progress::automatic}, {"plain", Progress::plain}, {"none", Progress::none}};
  app.add_option("--progress",
                 options.progress,
                 "auto: a bar on a terminal, else plain lines (default: auto)")
      ->transform(plain(CLI::CheckedTransformer(progress)))
      ->type_name("auto|plain|none");
  app.add_flag("--json", options.json, "print stats.json on stdout; all else goes to stderr");
  app.add_option("--require-tracked",
                 options.require_tracked,
                 "exit with 5 when the tracked ratio is lower")
      ->check(plain(CLI::Range(0.0, 1.0)))
      ->type_name("R");
}

/// The named shortcuts are settings too; --set comes last and wins.
Options toOptions(Raw raw) {
  Options options = std::move(raw.options);
  const std::pair<const char*, std::optional<std::string>> shortcuts[] = {
      {"backend", raw.backend},
      {"tracker", raw.tracker},
      {"direct.patch_size", raw.patch},
      {"direct.levels", raw.levels},
      {"direct.max_direct_frames", raw.max_direct_frames}};
  for (const auto& [key, value] : shortcuts) {
    if (value) options.settings.push_back(std::string(key) + "=" + *value);
  }
  if (raw.report_flag->count() > 0) options.report = raw.report;
  if (raw.deterministic) options.settings.emplace_back("execution=inline");
  if (raw.localize_only) options.settings.emplace_back("mode=localization_only");
  options.settings.insert(options.settings.end(), raw.settings.begin(), raw.settings.end());
  return options;
}

constexpr const char* kFooter =
    "Exit status: 0 ok, 1 usage, 2 unreadable input, 3 GL asked for and unavailable,\n"
    "4 never initialised, 5 below --require-tracked, 130 interrupted: Ctrl-C ends a replay after\n"
    "the current frame and writes what was tracked so far; a second one ends it at once.";

}  // namespace

std::variant<Options, int> parseOptions(int argc, const char* const* argv) {
  Raw raw;
  CLI::App app("Replay a sequence through GLidE-SLAM and write trajectory, statistics and log.",
               "glide replay");
  app.footer(kFooter);
  app.get_formatter()->column_width(36);
  app.set_version_flag("--version",
                       std::to_string(GLIDE_VERSION_MAJOR) + "." +
                           std::to_string(GLIDE_VERSION_MINOR) + "." +
                           std::to_string(GLIDE_VERSION_PATCH));
  addInputs(app, raw);
  addTracking(app, raw);
  addConfig(app, raw);
  addMaps(app, raw);
  addOutputs(app, raw);
  addPictures(app, raw);
  try {
    app.parse(argc, argv);
    if (raw.options.source.empty() && !raw.options.print_config) {
      throw CLI::RequiredError("SOURCE");
    }
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? kOk : kUsage;
  }
  return toOptions(std::move(raw));
}

}  // namespace glide::replay
