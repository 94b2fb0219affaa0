#pragma once

#include "gpu/gl.h"

#include "glide/result.h"

#include <cstdint>
#include <string_view>
#include <utility>

namespace glide {

/// Owns one GL name; Destroy deletes it. Move-only. Lives and dies on the GL thread with the
/// context current, unless abandoned.
template <void (*Destroy)(GLuint)>
class GlName {
 public:
  GlName() = default;
  explicit GlName(GLuint name) : name_(name) {}
  GlName(GlName&& other) noexcept : name_(std::exchange(other.name_, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(name_, other.name_);
    return *this;
  }
  ~GlName() {
    if (name_ != 0) Destroy(name_);
  }

  GLuint get() const { return name_; }
  /// Forgets the name without a GL call: the context is gone.
  void abandon() { name_ = 0; }

 private:
  GLuint name_ = 0;
};

void deleteBuffer(GLuint name);
void deleteTexture(GLuint name);
void deleteProgram(GLuint name);
void deleteShader(GLuint name);
void deleteSampler(GLuint name);
void deleteFramebuffer(GLuint name);
void deleteVertexArray(GLuint name);

using GlProgram = GlName<deleteProgram>;
using GlShader = GlName<deleteShader>;
using GlSampler = GlName<deleteSampler>;

/// That the driver has no room for `what`.
Error outOfMemory(std::string_view what);

/// Whether there was memory for all of several objects (or of stages that hold such).
template <class... Objects>
bool allComplete(const Objects&... objects) {
  return (objects.isComplete() && ...);
}

/// Forgets the names of several objects (or of stages that hold such).
template <class... Objects>
void abandonAll(Objects&... objects) {
  (objects.abandon(), ...);
}

/// A buffer of fixed size. Its functions leave it bound to GL_SHADER_STORAGE_BUFFER (the generic
/// binding).
class GlBuffer {
 public:
  /// Contents are unspecified. `usage` as in glBufferData. Without memory for it, not complete.
  static GlBuffer allocate(std::int64_t bytes, GLenum usage);
  bool isComplete() const { return bytes_ > 0; }

  /// Replaces the first `bytes` bytes.
  void write(const void* data, std::int64_t bytes) const;
  /// Replaces `bytes` bytes from `offset` on.
  void writeRange(const void* data, std::int64_t offset, std::int64_t bytes) const;
  /// Copies the first `bytes` bytes out; false when the driver does not map. The caller has waited
  /// for the GPU and issued GL_BUFFER_UPDATE_BARRIER_BIT.
  bool read(void* data, std::int64_t bytes) const;

  GLuint get() const { return name_.get(); }
  std::int64_t bytes() const { return bytes_; }
  void abandon() { name_.abandon(); }

 private:
  GlName<deleteBuffer> name_;
  std::int64_t bytes_ = 0;
};

/// A 2-D texture of one level, nearest filtering, clamped. Made through texture unit 0.
class GlTexture {
 public:
  /// Contents are unspecified. Without memory for it, not complete.
  static GlTexture allocate(GLenum format, int width, int height);
  bool isComplete() const { return width_ > 0; }

  GLuint get() const { return name_.get(); }
  int width() const { return width_; }
  int height() const { return height_; }
  void abandon() { name_.abandon(); }

 private:
  GlName<deleteTexture> name_;
  int width_ = 0, height_ = 0;
};

/// A frame takes milliseconds on a phone and seconds on the slowest software driver; after this the
/// GPU hangs.
inline constexpr std::uint64_t kGpuTimeoutNs = 20'000'000'000;

/// A fence after everything submitted so far.
class GlSync {
 public:
  static GlSync insert();
  GlSync(GlSync&& other) noexcept : sync_(std::exchange(other.sync_, nullptr)) {}
  GlSync& operator=(GlSync&& other) noexcept {
    std::swap(sync_, other.sync_);
    return *this;
  }
  ~GlSync() {
    if (sync_ != nullptr) glDeleteSync(sync_);
  }

  /// Flushes, and waits until the GPU is there; false after `timeout_ns` or when the context is
  /// lost.
  bool wait(std::uint64_t timeout_ns) const;
  /// Lets what is submitted from here on to the current context wait, on the GPU; the context that
  /// inserted the fence has been flushed since.
  void orderAfter() const { glWaitSync(sync_, 0, GL_TIMEOUT_IGNORED); }
  void abandon() { sync_ = nullptr; }

 private:
  explicit GlSync(GLsync sync) : sync_(sync) {}
  GLsync sync_ = nullptr;
};

}  // namespace glide
