#include "bench/gpu/bandwidth.h"

#include "gpu/gl_objects.h"

#include "base/stopwatch.h"

#include <algorithm>

namespace glide::gpubench {
namespace {

constexpr std::int64_t kBytes = std::int64_t{64} << 20;  // beyond any last-level cache
constexpr int kTries = 6;

}  // namespace

Result<double> measureBandwidth() {
  const GlBuffer from = GlBuffer::allocate(kBytes, GL_STATIC_COPY);
  const GlBuffer to = GlBuffer::allocate(kBytes, GL_STATIC_COPY);
  glBindBuffer(GL_COPY_READ_BUFFER, from.get());
  glBindBuffer(GL_COPY_WRITE_BUFFER, to.get());
  double best_ms = 1e9;
  bool is_done = true;
  for (int i = 0; i < kTries; ++i) {
    Stopwatch watch;
    glCopyBufferSubData(GL_COPY_READ_BUFFER, GL_COPY_WRITE_BUFFER, 0, 0, kBytes);
    is_done = is_done && GlSync::insert().wait(kGpuTimeoutNs);
    best_ms = std::min(best_ms, watch.lapMs());
  }
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  glBindBuffer(GL_COPY_WRITE_BUFFER, 0);
  if (!from.isComplete() || !to.isComplete() || glGetError() != GL_NO_ERROR) {
    return Error{ErrorCode::gl, "measuring the bandwidth: GL refuses a copy of 64 MiB"};
  }
  if (!is_done) return Error{ErrorCode::gl, "measuring the bandwidth: the GPU does not answer"};
  return 2.0 * static_cast<double>(kBytes) / (best_ms * 1e6);
}

}  // namespace glide::gpubench
