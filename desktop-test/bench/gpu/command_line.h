#pragma once

#include "gpu/gpu_tuning.h"

#include <string>
#include <variant>
#include <vector>

namespace glide::gpubench {

/// Which clock the stages are timed by.
enum class Clock {
  automatic,  ///< Timer queries where the driver has them, else fences.
  fence,      ///< Wall clock up to a fence at each stage's end.
};

/// What one measurement is of.
struct Workload {
  int width = 752, height = 480;  ///< px
  int points = 1000;              ///< per reference
  int patch = 11;                 ///< px, odd
  int levels = 6;                 ///< of the pyramid
  int frames = 50;                ///< that medians are over
};

struct Options {
  Workload workload;
  std::vector<GpuPlan> plans;
  GpuTuning fused;    ///< of GpuPlan::fused
  bool tune = false;  ///< the fused plan is tuned first, as a session does
  Clock clock = Clock::automatic;
  bool json = false;
  bool sweep = false;
  std::string plot;  ///< PNG file of a sweep; none when empty
};

inline constexpr int kExitOk = 0, kExitUsage = 1, kExitCannotWrite = 2, kExitNoGl = 3;
inline constexpr int kExitGlFails = 4;  ///< for instance a shader that does not build, or no pose
inline constexpr int kExitNotLinear = 5;

/// The options, or the exit status of a program that has nothing to do (--help, wrong usage), which
/// it has said why.
std::variant<Options, int> parseCommandLine(int argc, const char* const* argv);

}  // namespace glide::gpubench
