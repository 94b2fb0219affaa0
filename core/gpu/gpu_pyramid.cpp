#include "gpu/gpu_pyramid.h"

namespace glide {
namespace {

constexpr int kGroupWidth = 32;  // local_size_x of the kernel
constexpr int kStripRows = 4;  // outputs per invocation: 10 fetches each, plus 15 a strip to start

}  // namespace

GpuPyramid GpuPyramid::allocate(int width, int height, int levels) {
  GpuPyramid pyramid;
  for (int l = 0; l < levels; ++l) {
    pyramid.levels.push_back(GlTexture::allocate(GL_R32F, width, height));
    width = (width + 1) / 2;
    height = (height + 1) / 2;
  }
  return pyramid;
}

Result<PyramidPass> PyramidPass::create(int group_size) {
  Result<ComputeProgram> down = ComputeProgram::create(
      "pyramid_down.comp", {{"GROUP_ROWS", group_size / kGroupWidth}, {"STRIP_ROWS", kStripRows}});
  if (!down) return down.error();
  return PyramidPass(std::move(*down), group_size);
}

void PyramidPass::run(const GpuPyramid& pyramid, GpuCommands& commands) const {
  down_.use();
  glActiveTexture(GL_TEXTURE0);
  const int rows_per_group = group_size_ / kGroupWidth * kStripRows;
  for (std::size_t l = 1; l < pyramid.levels.size(); ++l) {
    const GlTexture& coarser = pyramid.levels[l];
    glBindTexture(GL_TEXTURE_2D, pyramid.levels[l - 1].get());
    glBindImageTexture(0, coarser.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
    commands.dispatch(groupCount(coarser.width(), kGroupWidth),
                      groupCount(coarser.height(), rows_per_group));
    commands.barrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // the next level and the aligner fetch it
  }
}

}  // namespace glide
