#include "gpu/gpu_commands.h"

#include "gpu/gpu_timer.h"

namespace glide {

void GpuCommands::beginStage(GpuStage stage) {
  stage_ = stage;
  current() = {};
  if (timer_ != nullptr) timer_->begin(stage);
}

void GpuCommands::endStage() {
  if (timer_ != nullptr) timer_->end(stage_);
}

void GpuCommands::beginLevel(int level) {
  if (timer_ != nullptr) timer_->beginLevel(level);
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
