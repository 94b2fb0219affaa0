// glide-gpu-bench: times the stages of a direct frame on OpenGL ES 3.1 by the paper's plan and
// ours. Exit status: 0 ok, 1 usage, 2 the plot cannot be written, 3 no GL, 5 a sweep grows faster
// than the work.
#include "bench/gpu/command_line.h"
#include "bench/gpu/measure.h"
#include "bench/gpu/report.h"
#include "bench/gpu/sweep.h"
#include "bench/gpu/sweep_plot.h"
#include "support/egl_context.h"

#include <cstdio>
#include <exception>
#include <iostream>

namespace {

using namespace glide;
using namespace glide::gpubench;

constexpr int kIndent = 1;

int fail(int status, const std::string& message) {
  std::fprintf(stderr, "glide bench gpu: %s\n", message.c_str());
  return status;
}

int runOnce(const GlCaps& caps, const Options& options) {
  const BenchScene scene = makeBenchScene(options.workload);
  const Result<Measurement> measurement = measure(caps, options, scene);
  if (!measurement) return fail(kExitNoGl, measurement.error().message);
  if (options.json) {
    std::cout << toJson(*measurement).dump(kIndent) << '\n';
  } else {
    std::cout << toMarkdown(*measurement);
  }
  return kExitOk;
}

int runSweep(const GlCaps& caps, const Options& options) {
  const Result<Sweep> sweep = measureSweep(caps, options);
  if (!sweep) return fail(kExitNoGl, sweep.error().message);
  if (options.json) {
    std::cout << toJson(*sweep).dump(kIndent) << '\n';
  } else {
    std::cout << toMarkdown(*sweep);
  }
  if (!options.plot.empty() && !writePlot(*sweep, options.plot)) {
    return fail(kExitCannotWrite, options.plot + ": cannot be written");
  }
  return sweep->isLinear() ? kExitOk : kExitNotLinear;
}

int run(const Options& options) {
  const Result<test::EglContext> context = test::EglContext::create(test::EglDebug::off);
  if (!context) return fail(kExitNoGl, context.error().message);
  Result<GlCaps> caps = GlCaps::query();
  if (!caps) return fail(kExitNoGl, caps.error().message);
  if (options.clock == Clock::fence) caps->has_timer_query = false;
  return options.sweep ? runSweep(*caps, options) : runOnce(*caps, options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto parsed = parseCommandLine(argc, argv);
    if (const int* status = std::get_if<int>(&parsed)) return *status;
    return run(std::get<Options>(parsed));
  } catch (const std::exception& error) {
    return fail(kExitNoGl, error.what());
  }
}
