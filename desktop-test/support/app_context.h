#pragma once

#include "glide/result.h"

#include <memory>
#include <string>
#include <vector>

namespace glide::test {

/// Which objects a new context sees.
enum class ContextSharing {
  none,     ///< its own
  current,  ///< those of the context that is current
};

/// An OpenGL ES 3.1 context as an app would have it, with KHR_debug, on the display of the context
/// that is current on this thread. Current when made.
class AppContext {
 public:
  static Result<AppContext> create(ContextSharing sharing);

  AppContext(AppContext&& other) noexcept;
  AppContext& operator=(AppContext&& other) noexcept;
  /// With it goes all that it does not share. What is current afterwards: no context, if it was
  /// this one.
  ~AppContext();

  void makeCurrent() const;
  /// Current with a small surface of its own; false when the driver has no such.
  bool makeCurrentWithSurface();
  bool isCurrent() const;
  /// Errors that the driver has reported, until forgetComplaints(); none where it has no KHR_debug.
  const std::vector<std::string>& complaints() const { return *complaints_; }
  void forgetComplaints() { complaints_->clear(); }

 private:
  AppContext() : complaints_(std::make_unique<std::vector<std::string>>()) {}
  void listen();

  void* display_ = nullptr;  ///< EGLDisplay
  void* config_ = nullptr;   ///< EGLConfig
  void* context_ = nullptr;  ///< EGLContext
  void* surface_ = nullptr;  ///< EGLSurface
  std::unique_ptr<std::vector<std::string>> complaints_;
};

bool hasCurrentContext();

/// No context is current on this thread afterwards.
void makeNoContextCurrent();

/// The context and surfaces that are current, made current again on destruction.
class ScopedCurrentContext {
 public:
  ScopedCurrentContext();
  ~ScopedCurrentContext() { restore(); }
  void restore() const;
  ScopedCurrentContext(const ScopedCurrentContext&) = delete;
  ScopedCurrentContext& operator=(const ScopedCurrentContext&) = delete;

 private:
  void* display_;
  void* draw_;
  void* read_;
  void* context_;
};

}  // namespace glide::test
