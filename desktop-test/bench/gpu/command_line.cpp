#include "bench/gpu/command_line.h"

#include <CLI/CLI.hpp>

#include <cstdio>
#include <map>

namespace glide::gpubench {
namespace {

const std::map<std::string, std::vector<GpuPlan>> kPlans{
    {"paper", {GpuPlan::paper}},
    {"fused", {GpuPlan::fused}},
    {"both", {GpuPlan::paper, GpuPlan::fused}},
};
const std::map<std::string, Clock> kClocks{{"auto", Clock::automatic}, {"fence", Clock::fence}};

constexpr int kSmallestSide = 32, kLargestSide = 8192;  // px
constexpr int kMostFrames = 100'000;
/// A sweep has ten workloads: fewer frames of each, unless told otherwise.
constexpr int kSweepFrames = 32;

CLI::Validator plain(CLI::Validator validator) { return validator.description(""); }

void addSize(CLI::App* app, Workload* workload) {
  app->add_option_function<std::string>(
         "--size",
         [workload](const std::string& text) {
           char rest = '\0';
           int& width = workload->width;
           int& height = workload->height;
           const auto fits = [](int side) { return side >= kSmallestSide && side <= kLargestSide; };
           if (std::sscanf(text.c_str(), "%dx%d%c", &width, &height, &rest) != 2 || !fits(width) ||
               !fits(height)) {
             throw CLI::ValidationError(
                 "--size", "'" + text + "' is not of the form WxH with 32 to 8192 px a side");
           }
         },
         "images (default: 752x480)")
      ->type_name("WxH");
}

void addWorkload(CLI::App* app, Workload* workload) {
  addSize(app, workload);
  app->add_option("--points", workload->points, "points per reference, 15..4096 (default: 1000)")
      ->check(plain(CLI::Range(15, 4096)))
      ->type_name("N");
  const auto is_odd = [](const std::string& text) {
    const int size = std::atoi(text.c_str());
    return size % 2 == 1 && size >= 5 && size <= 15 ? "" : "'" + text + "' is not odd, 5..15";
  };
  app->add_option("--patch", workload->patch, "patch side, odd, 5..15 px (default: 11)")
      ->check(CLI::Validator(is_odd, ""))
      ->type_name("N");
  app->add_option("--levels", workload->levels, "pyramid levels, 1..8 (default: 6)")
      ->check(plain(CLI::Range(1, 8)))
      ->type_name("N");
}

template <class Value>
void addChoice(CLI::App* app,
               const std::string& flag,
               const std::map<std::string, Value>& choices,
               Value* value,
               const std::string& help) {
  app->add_option_function<std::string>(
         flag, [value, &choices](const std::string& name) { *value = choices.at(name); }, help)
      ->check(plain(CLI::IsMember(choices)));
}

void addRun(CLI::App* app, Options* options) {
  addChoice(app, "--plan", kPlans, &options->plans, "paper, fused or both (default: both)");
  addChoice(app,
            "--timer",
            kClocks,
            &options->clock,
            "auto: timer queries where the driver has them;\nfence: wall clock (default: auto)");
  app->add_flag("--tune",
                options->tune,
                "let the autotuner choose the fused plan's group sizes and kernels\n"
                "(default: what a device runs that is not tuned)");
  app->add_flag("--json", options->json, "JSON on stdout instead of Markdown");
  app->add_flag("--sweep",
                options->sweep,
                "frame cost against points (250..4000) and patch (5..13);\n"
                "exits with 5 where it grows faster than the work");
  app->add_option("--plot", options->plot, "a sweep's curves as a PNG file")
      ->take_last()
      ->type_name("FILE");
}

}  // namespace

std::variant<Options, int> parseCommandLine(int argc, const char* const* argv) {
  Options options;
  options.plans = kPlans.at("both");
  CLI::App app("Time the stages of a direct frame on OpenGL ES 3.1, by the paper's plan and ours.",
               "glide bench gpu");
  addWorkload(&app, &options.workload);
  CLI::Option* frames = app.add_option("--frames",
                                       options.workload.frames,
                                       "frames that medians are over (default: 50; sweep: 32)")
                            ->check(plain(CLI::Range(1, kMostFrames)))
                            ->type_name("N");
  addRun(&app, &options);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& stop) {
    return app.exit(stop) == 0 ? kExitOk : kExitUsage;
  }
  if (options.sweep && frames->count() == 0) options.workload.frames = kSweepFrames;
  return options;
}

}  // namespace glide::gpubench
