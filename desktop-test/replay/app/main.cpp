#include "replay/app/config_io.h"
#include "replay/app/job.h"
#include "replay/app/options.h"

#include <exception>
#include <iostream>
#include <utility>

namespace glide::replay {
namespace {

/// Writes everything that can be written of a run.
std::optional<Failure> endRun(Job& job) {
  std::optional<Failure> first;
  for (auto* step : {saveMap, evaluateRun, writeOutputs}) {
    std::optional<Failure> failure = step(job);
    if (!first) first = std::move(failure);
  }
  return first ? first : judgeRun(job);
}

std::optional<Failure> runSteps(Job& job) {
  for (auto* step : {openInputs, startSession, openOutput, loadMap, makeWatchers, runFrames}) {
    if (auto failure = step(job)) return failure;
  }
  return endRun(job);
}

int fail(const Failure& failure, RunLog& log) {
  log.say("glide replay: " + failure.message);
  return failure.code;
}

int run(int argc, const char* const* argv) {
  std::variant<Options, int> parsed = parseOptions(argc, argv);
  if (const int* code = std::get_if<int>(&parsed)) return *code;
  Job job;
  job.options = std::get<Options>(std::move(parsed));
  std::string command;
  for (int i = 0; i < argc; ++i) command += (i > 0 ? " " : "") + std::string(argv[i]);
  job.log.note("command: " + command);
  if (const auto failure = buildConfig(job)) return fail(*failure, job.log);
  if (job.options.print_config) {
    std::cout << configYaml(job.config);
    return kOk;
  }
  const auto failure = runSteps(job);
  return failure ? fail(*failure, job.log) : kOk;
}

}  // namespace
}  // namespace glide::replay

int main(int argc, char** argv) {
  try {
    return glide::replay::run(argc, argv);
  } catch (const std::exception& fault) {  // OpenCV, or no memory
    std::cerr << "glide replay: " << fault.what() << "\n";
    return glide::replay::kUnreadableInput;
  }
}
