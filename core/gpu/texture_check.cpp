#include "gpu/texture_check.h"

#include "gpu/gl_state.h"

#include <string>

namespace glide {
namespace {

Error invalid(const std::string& what) { return {ErrorCode::invalid_argument, "the image" + what}; }

GLint levelParameter(GLenum query) {
  GLint value = 0;
  glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, query, &value);
  return value;
}

/// Whether the texture, which exists, is of that target. When not, the GL error is the app's.
bool isOfTarget(const Texture& texture, GLenum binding) {
  GLint bound = 0;
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(texture.target, texture.name);
  glGetIntegerv(binding, &bound);
  return static_cast<GLuint>(bound) == texture.name;
}

Error wrongTarget(const Texture& texture, const char* target) {
  return invalid("'s name " + std::to_string(texture.name) + " is not a texture of target " +
                 target);
}

Status checkExternal(const Texture& texture, GlStatePolicy policy) {
  const ScopedTextureBinding binding(
      policy, GL_TEXTURE_EXTERNAL_OES, GL_TEXTURE_BINDING_EXTERNAL_OES);
  if (!isOfTarget(texture, GL_TEXTURE_BINDING_EXTERNAL_OES))
    return wrongTarget(texture, "GL_TEXTURE_EXTERNAL_OES");
  return Unit{};
}

Status checkPlain(const Texture& texture) {
  if (!isOfTarget(texture, GL_TEXTURE_BINDING_2D)) return wrongTarget(texture, "GL_TEXTURE_2D");
  const std::string name = std::to_string(texture.name);
  const GLint width = levelParameter(GL_TEXTURE_WIDTH);
  const GLint height = levelParameter(GL_TEXTURE_HEIGHT);
  if (width != texture.width || height != texture.height)
    return invalid("'s name " + name + " is a texture of " + std::to_string(width) + "x" +
                   std::to_string(height) + ", not " + std::to_string(texture.width) + "x" +
                   std::to_string(texture.height));
  const GLint type = levelParameter(GL_TEXTURE_RED_TYPE);
  if (type == GL_INT || type == GL_UNSIGNED_INT)
    return invalid("'s name " + name + " holds integers, which cannot be sampled as grey levels");
  return Unit{};
}

}  // namespace

Status checkTextureObject(const Texture& texture, GlStatePolicy policy) {
  if (glIsTexture(texture.name) != GL_TRUE)
    return invalid("'s name " + std::to_string(texture.name) +
                   " is no texture of the current context");
  return texture.target == GL_TEXTURE_EXTERNAL_OES ? checkExternal(texture, policy)
                                                   : checkPlain(texture);
}

bool isBoundTextureGrey() { return levelParameter(GL_TEXTURE_GREEN_SIZE) == 0; }

}  // namespace glide
