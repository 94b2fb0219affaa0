#include "gpu/gl_home.h"

#include <EGL/egl.h>

#include <random>

namespace glide {
namespace {

/// Every whole number below is a float of its own.
constexpr int kFloatIntegers = 1 << 24;

GLfloat uniqueLod() {
  std::random_device random;  // not for results: marks of two sessions must differ
  return static_cast<GLfloat>(std::uniform_int_distribution<int>(1, kFloatIntegers)(random));
}

GLfloat minLod(GLuint sampler) {
  GLfloat value = 0.0F;
  glGetSamplerParameterfv(sampler, GL_TEXTURE_MIN_LOD, &value);
  return value;
}

}  // namespace

Result<GlHome> GlHome::create() {
  GLuint name = 0;
  glGenSamplers(1, &name);
  GlSampler mark(name);
  if (name == 0) return outOfMemory("a sampler object");
  glSamplerParameterf(name, GL_TEXTURE_MIN_LOD, uniqueLod());
  return GlHome(std::move(mark));
}

GlHome::GlHome(GlSampler mark)
    : mark_(std::move(mark)),
      mark_min_lod_(minLod(mark_.get())),
      creator_(eglGetCurrentContext()),
      last_(creator_) {}

bool GlHome::isHere() const {
  if (mark_.get() == 0) return false;  // abandoned: no GL call any more
  return eglGetCurrentContext() != EGL_NO_CONTEXT && glIsSampler(mark_.get()) == GL_TRUE &&
         minLod(mark_.get()) == mark_min_lod_;
}

bool GlHome::isCreator() const { return eglGetCurrentContext() == creator_; }

void GlHome::enter() {
  const void* context = eglGetCurrentContext();
  if (context == last_) return;
  if (submitted_) submitted_->orderAfter();
  last_ = context;
  has_moved_ = true;
}

void GlHome::leave() {
  if (has_moved_) publish();
}

void GlHome::publish() { submitted_ = GlSync::insert(); }

void GlHome::abandon() {
  mark_.abandon();
  if (submitted_) submitted_->abandon();
  submitted_.reset();
}

}  // namespace glide
