#include "gpu/gpu_commands.h"

namespace glide {

void GpuCommands::beginStage(GpuStage stage) {
  stage_ = stage;
  current() = {};
}

void GpuCommands::dispatch(GLuint groups_x, GLuint groups_y) {
  glDispatchCompute(groups_x, groups_y, 1);
  ++current().dispatches;
}

void GpuCommands::barrier(GLbitfield bits) {
  glMemoryBarrier(bits);
  ++current().barriers;
}

}  // namespace glide
