#pragma once

namespace glide::test {

/// What the program's glClientWaitSync does: this program has its own, in front of the driver's.
enum class WaitFault {
  none,
  lost,     ///< GL_WAIT_FAILED: the context is lost
  timeout,  ///< GL_TIMEOUT_EXPIRED: the GPU hangs
};

/// From now on, until the next call.
void setWaitFault(WaitFault fault);

}  // namespace glide::test
