#include "gl_limits/floors.h"

#include <algorithm>
#include <iterator>

namespace glide::gl_limits {
namespace {

struct Floor {
  GLenum pname;
  int value;
};

constexpr Floor kFloors[] = {
    {GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS, kGroupInvocations},
    {GL_MAX_COMPUTE_SHARED_MEMORY_SIZE, kSharedBytes},
    {GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS, kStorageBlocks},
    {GL_MAX_COMBINED_SHADER_STORAGE_BLOCKS, kStorageBlocks},
    {GL_MAX_SHADER_STORAGE_BUFFER_BINDINGS, kStorageBindings},
    {GL_MAX_VERTEX_SHADER_STORAGE_BLOCKS, 0},
    {GL_MAX_FRAGMENT_SHADER_STORAGE_BLOCKS, 0},
    {GL_MAX_SHADER_STORAGE_BLOCK_SIZE, static_cast<int>(kStorageBytes)},
    {GL_MAX_COMPUTE_IMAGE_UNIFORMS, kImageUniforms},
    {GL_MAX_COMBINED_IMAGE_UNIFORMS, kImageUniforms},
    {GL_MAX_VERTEX_IMAGE_UNIFORMS, 0},
    {GL_MAX_FRAGMENT_IMAGE_UNIFORMS, 0},
    {GL_MAX_IMAGE_UNITS, kImageUnits},
    {GL_MAX_COMPUTE_TEXTURE_IMAGE_UNITS, kComputeTextures},
    {GL_MAX_COMPUTE_UNIFORM_BLOCKS, kUniformBlocks},
    {GL_MAX_UNIFORM_BUFFER_BINDINGS, kUniformBindings},
    {GL_MAX_UNIFORM_BLOCK_SIZE, 16384},
    {GL_MAX_COMPUTE_UNIFORM_COMPONENTS, 512},
    {GL_MAX_UNIFORM_LOCATIONS, 1024},
    {GL_MAX_COMPUTE_ATOMIC_COUNTERS, 8},
    {GL_MAX_COMPUTE_ATOMIC_COUNTER_BUFFERS, 1},
    {GL_MAX_TEXTURE_SIZE, kTextureSize},
    // These two are the most that a device may ask for.
    {GL_SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, 256},
    {GL_UNIFORM_BUFFER_OFFSET_ALIGNMENT, 256},
    {GL_NUM_PROGRAM_BINARY_FORMATS, 0},
};

constexpr std::string_view kHidden[] = {"GL_EXT_disjoint_timer_query",
                                        "GL_OES_EGL_image_external_essl3",
                                        "GL_OES_texture_float_linear"};

}  // namespace

std::optional<int> floorOf(GLenum pname) {
  for (const Floor& floor : kFloors) {
    if (floor.pname == pname) return floor.value;
  }
  return std::nullopt;
}

bool isHidden(std::string_view extension) {
  return std::find(std::begin(kHidden), std::end(kHidden), extension) != std::end(kHidden);
}

}  // namespace glide::gl_limits
