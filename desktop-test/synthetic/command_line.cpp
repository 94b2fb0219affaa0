#include "synthetic/command_line.h"

#include <CLI/CLI.hpp>

#include <cmath>
#include <cstdio>
#include <map>
#include <string>

namespace glide::synthetic {

namespace {

const std::map<std::string, SceneKind> kScenes{{"room", SceneKind::room},
                                               {"facade", SceneKind::facade},
                                               {"desk", SceneKind::desk},
                                               {"corridor", SceneKind::corridor},
                                               {"hall", SceneKind::hall},
                                               {"arcade", SceneKind::arcade},
                                               {"living-room", SceneKind::living_room}};
const std::map<std::string, Layout> kLayouts{{"tum", Layout::tum}, {"euroc", Layout::euroc}};
const std::map<std::string, DistortionModel> kCameras{
    {"pinhole", DistortionModel::none},
    {"radtan", DistortionModel::radial_tangential},
    {"fisheye", DistortionModel::kannala_brandt4}};
const std::map<std::string, MotionKind> kMotions{{"handheld", MotionKind::handheld},
                                                 {"sweep", MotionKind::sweep},
                                                 {"orbit", MotionKind::orbit},
                                                 {"corridor", MotionKind::corridor},
                                                 {"walk", MotionKind::walk},
                                                 {"rotation", MotionKind::rotation},
                                                 {"static", MotionKind::still}};

/// The names of a choice, for the help text.
template <class Value>
std::string names(const std::map<std::string, Value>& choices) {
  std::string list;
  for (const auto& [name, value] : choices) list += (list.empty() ? "" : "|") + name;
  return list;
}

template <class Value>
void addChoice(CLI::App* app,
               const std::string& flag,
               const std::map<std::string, Value>& choices,
               Value* value,
               const std::string& help) {
  app->add_option_function<std::string>(
         flag, [value, &choices](const std::string& name) { *value = choices.at(name); }, help)
      ->check(CLI::IsMember(choices))
      ->type_name(names(choices))
      ->option_text(names(choices));
}

/// Two numbers as A:B.
struct Range {
  double first = 0.0, last = 0.0;
};

void addRange(CLI::App* app,
              const std::string& flag,
              const std::string& help,
              const std::function<void(Range)>& use) {
  app->add_option_function<std::string>(
         flag,
         [use, flag](const std::string& text) {
           Range range;
           char rest = '\0';
           if (std::sscanf(text.c_str(), "%lf:%lf%c", &range.first, &range.last, &rest) != 2) {
             throw CLI::ValidationError(flag, "'" + text + "' is not of the form A:B");
           }
           use(range);
         },
         help)
      ->option_text("A:B");
}

void addMilliseconds(CLI::App* app,
                     const std::string& flag,
                     const std::string& help,
                     double* seconds) {
  app->add_option_function<double>(
         flag, [seconds](double ms) { *seconds = ms / 1000.0; }, help)
      ->option_text("MS");
}

void addSceneOptions(CLI::App* app, Command* command) {
  SequenceOptions& sequence = command->sequence;
  addChoice(app, "--scene", kScenes, &sequence.scene, "what is seen (default room)");
  addChoice(app, "--layout", kLayouts, &command->format.layout, "files to write (default tum)");
  app->add_option("--frames", sequence.frames, "number of images; 0 = the whole walk")
      ->capture_default_str();
  app->add_option("--fps", sequence.fps, "images per second")->capture_default_str();
  app->add_option("--seed", sequence.seed, "textures and noise; the same seed gives the same bytes")
      ->capture_default_str();
  app->add_flag("--color", command->format.in_color, "images in colour (--scene living-room)");
  app->add_flag("--overwrite", command->overwrite, "write into a folder that is not empty");
  app->add_flag("--quiet", command->quiet, "no progress");
}

void addMotionOptions(CLI::App* app, Motion* motion) {
  addChoice(app, "--motion", kMotions, &motion->kind, "how the camera moves (default handheld)");
  app->add_option("--speed", motion->speed, "factor on the motion's speed")->capture_default_str();
  app->add_option(
         "--turn-first", motion->turn_first_s, "seconds of pure rotation before the motion")
      ->capture_default_str();
  addRange(app, "--pause", "the camera stands still from A to B seconds", [motion](Range range) {
    motion->pause_begin_s = range.first;
    motion->pause_end_s = range.last;
  });
}

const std::map<std::string, KidnapView> kKidnapViews{
    {"", KidnapView::black}, {":black", KidnapView::black}, {":foreign", KidnapView::foreign}};

void addKidnap(CLI::App* app, Kidnap* kidnap) {
  app->add_option_function<std::string>(
         "--kidnap",
         [kidnap](const std::string& text) {
           int length = 0;
           const int fields =
               std::sscanf(text.c_str(), "%d:%d%n", &kidnap->begin, &kidnap->end, &length);
           const auto view =
               kKidnapViews.find(fields == 2 ? text.substr(static_cast<std::size_t>(length)) : "?");
           if (view == kKidnapViews.end()) {
             throw CLI::ValidationError("--kidnap",
                                        "'" + text + "' is not of the form A:B[:black|foreign]");
           }
           kidnap->view = view->second;
         },
         "images A to B - 1 are black or of another place; then the camera is back on its earlier "
         "path, a little beside it")
      ->option_text("A:B[:black|foreign]");
}

void addSensorOptions(CLI::App* app, Sensor* sensor) {
  app->add_option("--noise", sensor->noise, "sensor noise, standard deviation in grey levels")
      ->capture_default_str();
  addMilliseconds(app,
                  "--blur",
                  "shutter time: motion blur over so many milliseconds (default 0)",
                  &sensor->shutter_s);
  app->add_option("--blur-samples", sensor->shutter_samples, "renderings averaged per image")
      ->capture_default_str();
  addRange(app,
           "--gain-ramp",
           "exposure gain of the first and the last image (default 1:1)",
           [sensor](Range range) {
             sensor->gain_begin = range.first;
             sensor->gain_end = range.last;
           });
  addRange(app,
           "--bias-ramp",
           "grey levels added to the first and the last image",
           [sensor](Range range) {
             sensor->bias_begin = range.first;
             sensor->bias_end = range.last;
           });
  app->add_option("--metering",
                  sensor->metering,
                  "how much the gain follows the brightness of the view: 0 fixed, 1 fully")
      ->capture_default_str();
  app->add_option("--flicker", sensor->flicker, "random change of gain from image to image, share")
      ->capture_default_str();
  addMilliseconds(app,
                  "--rolling-shutter",
                  "readout time from the first to the last row (default 0: global shutter)",
                  &sensor->readout_s);
}

/// "640x480"
struct Size {
  int width = 640, height = 480;
};

void addSize(CLI::App* app, Size* size) {
  app->add_option_function<std::string>(
         "--size",
         [size](const std::string& text) {
           char rest = '\0';
           if (std::sscanf(text.c_str(), "%dx%d%c", &size->width, &size->height, &rest) != 2) {
             throw CLI::ValidationError("--size", "'" + text + "' is not of the form WIDTHxHEIGHT");
           }
         },
         "image size in pixels (default 640x480)")
      ->option_text("WxH");
}

void setFieldOfView(double horizontal_deg, CameraIntrinsics* camera) {
  constexpr double kRadiansPerDegree = 3.141592653589793 / 180.0;
  camera->fx = 0.5 * camera->width / std::tan(0.5 * kRadiansPerDegree * horizontal_deg);
  camera->fy = camera->fx;
}

}  // namespace

std::optional<Command> parseCommandLine(int argc, char** argv, int* exit_status) {
  CLI::App app(
      "Render a textured 3-D scene with exact ground truth as a TUM RGB-D or EuRoC dataset.",
      "glide synth");
  Command command;
  DistortionModel model = DistortionModel::none;
  Size size;
  std::optional<double> field_of_view_deg;
  app.add_option("OUT", command.folder, "folder to write")->required()->option_text(" ");
  addSceneOptions(&app, &command);
  addChoice(&app, "--camera", kCameras, &model, "lens model (default pinhole)");
  addSize(&app, &size);
  app.add_option("--fov",
                 field_of_view_deg,
                 "horizontal field of view of a pinhole camera, degrees (default 63)")
      ->check(CLI::Range(10.0, 150.0).description(""))
      ->option_text("DEG");
  addMotionOptions(&app, &command.sequence.motion);
  addKidnap(&app, &command.sequence.kidnap);
  addSensorOptions(&app, &command.sequence.sensor);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    *exit_status = app.exit(error) == 0 ? 0 : 1;
    return std::nullopt;
  }
  if (field_of_view_deg && model != DistortionModel::none) {
    *exit_status = 1;
    std::fprintf(stderr, "glide synth: --fov: only with --camera pinhole\n");
    return std::nullopt;
  }
  command.sequence.camera = makeCamera(model, size.width, size.height);
  if (field_of_view_deg) setFieldOfView(*field_of_view_deg, &command.sequence.camera);
  return command;
}

}  // namespace glide::synthetic
