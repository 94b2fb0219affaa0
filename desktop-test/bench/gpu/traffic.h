#pragma once

#include "bench/gpu/command_line.h"

#include "gpu/gpu_commands.h"
#include "photometric/align_types.h"

#include <array>

namespace glide::gpubench {

/// Bytes that a stage moves between its kernels and memory.
struct Traffic {
  double read = 0.0, written = 0.0;

  double total() const { return read + written; }
};

/// A number for each level, finest first.
using PerLevel = std::array<double, kMaxAlignLevels>;

/// What the traffic of a plan depends on beside the workload.
struct TrafficCase {
  GpuPlan plan = GpuPlan::fused;
  PerLevel points{};      ///< whose patch lies in the reference's level
  PerLevel iterations{};  ///< done
};

/// Width or height of a level of an image that wide or high (image/pyramid.h).
int levelSide(int side, int level);

/// The bytes that the stages of a frame must move, counted from the algorithm: what a command reads
/// of a buffer or an image counts once, however often its invocations fetch it, what it writes
/// once; nothing stays in a cache from one command or iteration to the next. Precompute is per
/// reference.
///
/// A_l: pixels of level l; N_l: points with a patch there; k_l: iterations; p: patch side; 4 bytes
/// a float.
///   upload      read A_0 (the host's image) + A_0 (to convert it), written A_0 + 4 A_0
///   pyramid     fused: a level is one command: read 4 A_l, written 4 A_(l+1);
///               paper: two: the blurred rows, 4 A_l, are written, and their even columns,
///               4 W_(l+1) H_l, read
///   precompute  N_l times: read a position (16) and texels, 4 (p + 3)^2, and written
///               fused: the record (112) and e, gx, gy a pixel, 12 p^2;
///               paper: a position (16) and I0, J a pixel, 28 p^2; H of the point (96) is written
///               and read
///   track       k_l N_l times: read the texels, 4 (p + 1)^2, and
///               fused: position and mean (32) and the cache, 12 p^2; the sums (32) are written and
///               read, the record (112) read, a weight (8) written;
///               paper: the position (16) and the cache, 28 p^2; the point's term (32) is written
///               and read; and k_l times the state, and in the paper's plan the totals
///   readback    the state, read and written once
std::array<Traffic, kGpuStages> countTraffic(const Workload& workload, const TrafficCase& what);

}  // namespace glide::gpubench
