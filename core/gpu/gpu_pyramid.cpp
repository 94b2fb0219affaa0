#include "gpu/gpu_pyramid.h"

#include <algorithm>

namespace glide {
namespace {

constexpr int kStripColumns = 2;   // outputs of a strip in a row, fixed in the shader
constexpr int kTileHeight = 16;    // outputs of a tile in a column, fixed in the shader
constexpr int kMaxStripRows = 8;   // longer strips save no more fetches worth the name
constexpr int kMinStripRows = 2;   // shorter ones fetch twice what they need
constexpr int kBusyStrips = 2048;  // small levels take shorter strips, so that a GPU has work

// Uniform location of strip_rows and of finer_height.
constexpr GLint kParameter = 0;

std::string_view shaderName(PyramidKernel kernel) {
  switch (kernel) {
    case PyramidKernel::tile:
      return "pyramid_tile.comp";
    case PyramidKernel::two_pass:
      return "pyramid_blur_rows.comp";
    case PyramidKernel::strip:
      break;
  }
  return "pyramid_strip.comp";
}

int stripRows(const GlTexture& level) {
  const int strips_of_a_row = level.width() * level.height() / kStripColumns;
  return std::clamp(strips_of_a_row / kBusyStrips, kMinStripRows, kMaxStripRows);
}

/// Texture unit 0 fetches `from`, image unit 0 stores into `to`.
void bindPass(const GlTexture& from, const GlTexture& to) {
  glBindTexture(GL_TEXTURE_2D, from.get());
  glBindImageTexture(0, to.get(), 0, GL_FALSE, 0, GL_WRITE_ONLY, GL_R32F);
}

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

PyramidKernel pyramidKernel(const GpuTuning& tuning) {
  return tuning.plan == GpuPlan::paper ? PyramidKernel::two_pass : tuning.pyramid;
}

Result<PyramidPass> PyramidPass::create(const GpuTuning& tuning,
                                        const GpuPyramid& pyramid,
                                        const ProgramCache& programs) {
  const PyramidKernel kernel = pyramidKernel(tuning);
  const int group_rows = tuning.group_size / kGroupWidth;
  const ShaderDefines defines{{"GROUP_ROWS", group_rows}};
  Result<ComputeProgram> program = ComputeProgram::create(shaderName(kernel), defines, programs);
  if (!program) return program.error();
  PyramidPass pass(kernel, group_rows, std::move(*program));
  if (kernel != PyramidKernel::two_pass) return pass;
  Result<ComputeProgram> columns =
      ComputeProgram::create("pyramid_blur_columns.comp", defines, programs);
  if (!columns) return columns.error();
  const GlTexture& level0 = pyramid.levels.front();
  pass.second_ = SecondPass{std::move(*columns),
                            GlTexture::allocate(GL_R32F, level0.width(), level0.height())};
  return pass;
}

void PyramidPass::run(const GpuPyramid& pyramid, GpuCommands& commands) const {
  glActiveTexture(GL_TEXTURE0);
  program_.use();
  for (std::size_t l = 1; l < pyramid.levels.size(); ++l) {
    const GlTexture& finer = pyramid.levels[l - 1];
    if (second_) {
      runTwoPass(finer, pyramid.levels[l], commands);
    } else {
      runFused(finer, pyramid.levels[l], commands);
    }
  }
}

void PyramidPass::runFused(const GlTexture& finer,
                           const GlTexture& coarser,
                           GpuCommands& commands) const {
  bindPass(finer, coarser);
  if (kernel_ == PyramidKernel::tile) {
    commands.dispatch(groupCount(coarser.width(), kGroupWidth),
                      groupCount(coarser.height(), kTileHeight));
  } else {
    const int strip_rows = stripRows(coarser);
    glUniform1i(kParameter, strip_rows);
    commands.dispatch(groupCount(coarser.width(), kGroupWidth * kStripColumns),
                      groupCount(coarser.height(), group_rows_ * strip_rows));
  }
  commands.barrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // the next level and the aligner fetch it
}

void PyramidPass::runTwoPass(const GlTexture& finer,
                             const GlTexture& coarser,
                             GpuCommands& commands) const {
  program_.use();
  bindPass(finer, second_->blurred_rows);
  commands.dispatch(groupCount(finer.width(), kGroupWidth),
                    groupCount(finer.height(), group_rows_));
  commands.barrier(GL_TEXTURE_FETCH_BARRIER_BIT);  // the second pass fetches the blurred rows

  second_->blur_columns.use();
  bindPass(second_->blurred_rows, coarser);
  glUniform1i(kParameter, finer.height());
  commands.dispatch(groupCount(coarser.width(), kGroupWidth),
                    groupCount(coarser.height(), group_rows_));
  // The next level and the aligner fetch it; the next level's blurred rows overwrite these.
  commands.barrier(GL_TEXTURE_FETCH_BARRIER_BIT | GL_SHADER_IMAGE_ACCESS_BARRIER_BIT);
}

bool GpuPyramid::isComplete() const {
  return std::all_of(
      levels.begin(), levels.end(), [](const GlTexture& level) { return level.isComplete(); });
}

void GpuPyramid::abandon() {
  for (GlTexture& level : levels) level.abandon();
}

void PyramidPass::abandon() {
  program_.abandon();
  if (second_) abandonAll(second_->blur_columns, second_->blurred_rows);
}

}  // namespace glide
