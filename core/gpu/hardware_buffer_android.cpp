#include "gpu/gl_state.h"
#include "gpu/hardware_buffer.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <android/hardware_buffer.h>
#include <string>

namespace glide {
namespace {

/// What the import needs of EGL_ANDROID_get_native_client_buffer, EGL_ANDROID_image_native_buffer,
/// EGL_KHR_image_base and GL_OES_EGL_image.
struct ImageFunctions {
  PFNEGLGETNATIVECLIENTBUFFERANDROIDPROC client_buffer = nullptr;
  PFNEGLCREATEIMAGEKHRPROC create = nullptr;
  PFNEGLDESTROYIMAGEKHRPROC destroy = nullptr;
  PFNGLEGLIMAGETARGETTEXTURE2DOESPROC target_texture = nullptr;

  bool areThere() const {
    return client_buffer != nullptr && create != nullptr && destroy != nullptr &&
           target_texture != nullptr;
  }
};

template <class Function>
Function load(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

ImageFunctions loadFunctions() {
  return {
      load<PFNEGLGETNATIVECLIENTBUFFERANDROIDPROC>("eglGetNativeClientBufferANDROID"),
      load<PFNEGLCREATEIMAGEKHRPROC>("eglCreateImageKHR"),
      load<PFNEGLDESTROYIMAGEKHRPROC>("eglDestroyImageKHR"),
      load<PFNGLEGLIMAGETARGETTEXTURE2DOESPROC>("glEGLImageTargetTexture2DOES"),
  };
}

Error invalid(const std::string& what) {
  return {ErrorCode::invalid_argument, "the image's hardware buffer " + what};
}

Status checkBuffer(const AHardwareBuffer_Desc& description) {
  if (description.layers != 1) return invalid("has several layers");
  if ((description.usage & AHARDWAREBUFFER_USAGE_GPU_SAMPLED_IMAGE) == 0)
    return invalid("was allocated without AHARDWAREBUFFER_USAGE_GPU_SAMPLED_IMAGE");
  return Unit{};
}

/// Binds the image of `buffer` to `texture`. The image itself is not kept: the texture holds on to
/// the memory (EGL_KHR_image_base, siblings).
Status showIn(GLuint texture, const AHardwareBuffer* buffer, const ImageFunctions& egl) {
  const EGLDisplay display = eglGetCurrentDisplay();
  constexpr EGLint kAttributes[] = {EGL_IMAGE_PRESERVED_KHR, EGL_TRUE, EGL_NONE};
  const EGLImageKHR image = egl.create(
      display, EGL_NO_CONTEXT, EGL_NATIVE_BUFFER_ANDROID, egl.client_buffer(buffer), kAttributes);
  if (image == EGL_NO_IMAGE_KHR)
    return Error{ErrorCode::gl, "the image's hardware buffer: EGL makes no image of it"};
  glBindTexture(GL_TEXTURE_EXTERNAL_OES, texture);
  egl.target_texture(GL_TEXTURE_EXTERNAL_OES, image);
  egl.destroy(display, image);
  return Unit{};
}

}  // namespace

Result<Texture> HardwareBufferTexture::import(const HardwareBuffer& buffer, GlStatePolicy policy) {
  const ImageFunctions egl = loadFunctions();
  if (!egl.areThere())
    return Error{ErrorCode::unsupported, "the image: this EGL imports no hardware buffers"};
  AHardwareBuffer_Desc description{};
  AHardwareBuffer_describe(buffer.buffer, &description);
  const Status usable = checkBuffer(description);
  if (!usable) return usable.error();
  if (texture_.get() == 0) {
    GLuint name = 0;
    glGenTextures(1, &name);
    texture_ = GlName<deleteTexture>(name);
  }
  glActiveTexture(GL_TEXTURE0);
  const ScopedTextureBinding binding(
      policy, GL_TEXTURE_EXTERNAL_OES, GL_TEXTURE_BINDING_EXTERNAL_OES);
  const Status shown = showIn(texture_.get(), buffer.buffer, egl);
  if (!shown) return shown.error();
  return Texture{texture_.get(),
                 GL_TEXTURE_EXTERNAL_OES,
                 static_cast<int>(description.width),
                 static_cast<int>(description.height),
                 buffer.transform};
}

}  // namespace glide
