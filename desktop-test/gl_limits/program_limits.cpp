#include "gl_limits/program_limits.h"

#include "gl_limits/floors.h"

#include <algorithm>
#include <array>

namespace glide::gl_limits {
namespace {

int activeResources(GLuint program, GLenum interface) {
  GLint count = 0;
  glGetProgramInterfaceiv(program, interface, GL_ACTIVE_RESOURCES, &count);
  return count;
}

bool isImage(GLint type) {
  constexpr std::array kTypes{GL_IMAGE_2D,
                              GL_INT_IMAGE_2D,
                              GL_UNSIGNED_INT_IMAGE_2D,
                              GL_IMAGE_3D,
                              GL_INT_IMAGE_3D,
                              GL_UNSIGNED_INT_IMAGE_3D,
                              GL_IMAGE_CUBE,
                              GL_INT_IMAGE_CUBE,
                              GL_UNSIGNED_INT_IMAGE_CUBE,
                              GL_IMAGE_2D_ARRAY,
                              GL_INT_IMAGE_2D_ARRAY,
                              GL_UNSIGNED_INT_IMAGE_2D_ARRAY};
  return std::find(kTypes.begin(), kTypes.end(), type) != kTypes.end();
}

/// Image uniforms, each element of an array for itself.
int imageUniforms(GLuint program) {
  constexpr std::array<GLenum, 2> kWanted{GL_TYPE, GL_ARRAY_SIZE};
  int images = 0;
  for (int i = 0; i < activeResources(program, GL_UNIFORM); ++i) {
    std::array<GLint, 2> values{};
    glGetProgramResourceiv(
        program, GL_UNIFORM, static_cast<GLuint>(i), 2, kWanted.data(), 2, nullptr, values.data());
    if (isImage(values[0])) images += std::max(values[1], 1);
  }
  return images;
}

/// Invocations of a workgroup, and its three sizes.
std::array<int, 4> groupSize(GLuint program) {
  std::array<GLint, 3> size{};
  glGetProgramiv(program, GL_COMPUTE_WORK_GROUP_SIZE, size.data());
  return {size[0] * size[1] * size[2], size[0], size[1], size[2]};
}

void add(std::string* uses, int used, int allowed, const char* what) {
  if (used <= allowed) return;
  if (!uses->empty()) *uses += "; ";
  *uses += std::to_string(used) + " " + what + " (of " + std::to_string(allowed) + ")";
}

bool hasComputeShader(GLuint program) {
  std::array<GLuint, 8> shaders{};
  GLsizei count = 0;
  glGetAttachedShaders(program, static_cast<GLsizei>(shaders.size()), &count, shaders.data());
  return std::any_of(shaders.begin(), shaders.begin() + count, [](GLuint shader) {
    GLint type = 0;
    glGetShaderiv(shader, GL_SHADER_TYPE, &type);
    return type == GL_COMPUTE_SHADER;
  });
}

}  // namespace

std::string usesBeyondFloors(GLuint program) {
  const bool computes = hasComputeShader(program);
  std::string uses;
  // Vertex and fragment shaders may have none at all.
  add(&uses,
      activeResources(program, GL_SHADER_STORAGE_BLOCK),
      computes ? kStorageBlocks : 0,
      "storage blocks");
  add(&uses, imageUniforms(program), computes ? kImageUniforms : 0, "image uniforms");
  add(&uses, activeResources(program, GL_UNIFORM_BLOCK), kUniformBlocks, "uniform blocks");
  if (!computes) return uses;
  const std::array<int, 4> size = groupSize(program);
  add(&uses, size[0], kGroupInvocations, "invocations in a workgroup");
  for (std::size_t i = 0; i < 3; ++i)
    add(&uses, size[i + 1], kGroupSize[i], "invocations along an axis");
  return uses;
}

}  // namespace glide::gl_limits
