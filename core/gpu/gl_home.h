#pragma once

#include "gpu/gl_objects.h"
#include "gpu/gl_state.h"

#include <optional>

namespace glide {

/// Where GL names live: the share group of the context that was current at creation. Every call may
/// come in another context of the group; the home tells whether it does, and puts what different
/// contexts submit in order. Owned by the GL thread.
class GlHome {
 public:
  /// gl when the context gives no sampler object.
  static Result<GlHome> create();

  /// Whether names of the home may be used and deleted: a context of its share group is current. No
  /// context, one of another group and one that was lost are not here, even where EGL gives a new
  /// context the handle of an old one.
  bool isHere() const;
  /// Whether the current context is the very one of creation: what contexts do not share (queries,
  /// framebuffers, vertex arrays) exists only there.
  bool isCreator() const;

  /// Begin of a pass: what was submitted last in another context of the group comes first on the
  /// GPU. That context was flushed (eglMakeCurrent does) or the app has seen to it.
  void enter();
  /// End of a pass that nobody has waited for. Fences cost a submission on some drivers: there is
  /// one only if contexts have changed before. What goes without is the pyramid of a frame that was
  /// not aligned; the next frame takes its place.
  void leave();
  /// End of work that later passes read in whatever context they come.
  void publish();
  /// Forgets all names without a GL call.
  void abandon();

 private:
  explicit GlHome(GlSampler mark);

  /// A sampler object with a limit of detail that no one else's has: found again under its name
  /// only in its share group. Samplers are shared, and their parameters need no binding.
  GlSampler mark_;
  GLfloat mark_min_lod_ = 0.0F;
  const void* creator_;     ///< EGLContext
  const void* last_;        ///< EGLContext of the last pass
  bool has_moved_ = false;  ///< passes came in more than one context
  std::optional<GlSync> submitted_;
};

/// One call of the library in the app's context: its state, and the order of what contexts submit.
class GlVisit {
 public:
  GlVisit(GlHome* home, GlStatePolicy policy) : state_(policy), home_(home) { home_->enter(); }
  ~GlVisit() { home_->leave(); }
  GlVisit(const GlVisit&) = delete;
  GlVisit& operator=(const GlVisit&) = delete;

 private:
  ScopedGlState state_;
  GlHome* home_;
};

}  // namespace glide
