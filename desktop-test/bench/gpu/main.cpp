// glide-gpu-bench: times the stages of a direct frame on OpenGL ES 3.1 by the paper's plan and
// ours. Exit status: 0 ok, 1 usage, 2 the plot cannot be written, 3 no GL, or less of it than is
// needed, 4 GL or an alignment fails, 5 a sweep grows faster than the work.
#include "bench/gpu/command_line.h"
#include "bench/gpu/measure.h"
#include "bench/gpu/report.h"
#include "bench/gpu/sweep.h"
#include "bench/gpu/sweep_plot.h"
#include "support/egl_context.h"

#include "gpu/tuning_trial.h"

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

int fail(const Error& error) {
  return fail(error.code == ErrorCode::unsupported ? kExitNoGl : kExitGlFails, error.message);
}

int runOnce(const GlCaps& caps, const Options& options) {
  const BenchScene scene = makeBenchScene(options.workload);
  const Result<Measurement> measurement = measure(caps, options, scene);
  if (!measurement) return fail(measurement.error());
  if (options.json) {
    std::cout << toJson(*measurement).dump(kIndent) << '\n';
  } else {
    std::cout << toMarkdown(*measurement);
  }
  return kExitOk;
}

int runSweep(const GlCaps& caps, const Options& options) {
  const Result<Sweep> sweep = measureSweep(caps, options);
  if (!sweep) return fail(sweep.error());
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

/// What a session would choose on this device.
GpuTuning tunedFor(const GlCaps& caps, const Workload& workload) {
  Config config;
  config.direct = directOf(workload, GpuPlan::fused, Maths::own);
  TuningTrial trial(caps, config, benchCamera(workload.width, workload.height));
  return fastestTuning(trial.probe(ProgramCache{}));
}

int run(Options options) {
  const Result<test::EglContext> context = test::EglContext::create(test::EglDebug::off);
  if (!context) return fail(context.error());
  Result<GlCaps> caps = GlCaps::query();
  if (!caps) return fail(caps.error());
  if (options.clock == Clock::fence) caps->has_timer_query = false;
  if (options.tune) options.fused = tunedFor(*caps, options.workload);
  return options.sweep ? runSweep(*caps, options) : runOnce(*caps, options);
}

}  // namespace

int main(int argc, char** argv) {
  try {
    const auto parsed = parseCommandLine(argc, argv);
    if (const int* status = std::get_if<int>(&parsed)) return *status;
    return run(std::get<Options>(parsed));
  } catch (const std::exception& error) {
    return fail(kExitGlFails, error.what());
  }
}
