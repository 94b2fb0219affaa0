#pragma once

#include "gpu/gl_caps.h"
#include "gpu/gl_objects.h"
#include "photometric/align_types.h"

#include "base/stopwatch.h"

#include <array>

namespace glide {

void deleteQuery(GLuint name);

/// Milliseconds of the aligner's stages, without a wait of its own.
/// With GL_EXT_disjoint_timer_query: GPU time between two GL_TIMESTAMP_EXT queries around the
/// stage, read after the alignment's fence. A stage that was issued after the last fence (a
/// reference made after the alignment) is reported from the next collect() on; until then its
/// previous time stands, or the wall clock of the call when there is none yet. Without: wall clock
/// of the calls. Work that the driver defers is then part of the align stage, which ends with the
/// fence.
class GpuTimer {
 public:
  enum class Stage { pyramid, precompute, align };

  static GpuTimer create(const GlCaps& caps);

  void begin(Stage stage);
  void end(Stage stage);
  /// Takes over the times that have arrived. Call after the fence.
  void collect();
  AlignTimes times() const;
  /// Whether times are the GPU's own.
  bool usesQueries() const { return write_timestamp_ != nullptr; }

 private:
  struct Span {
    GlName<deleteQuery> begin, end;
    Stopwatch wall;
    bool pending = false;
    double ms = 0.0;
  };
  GpuTimer() = default;
  Span& span(Stage stage) { return spans_[static_cast<std::size_t>(stage)]; }
  bool read(Span* span) const;

  std::array<Span, 3> spans_;
  PFNGLQUERYCOUNTEREXTPROC write_timestamp_ = nullptr;
  PFNGLGETQUERYOBJECTUI64VEXTPROC get_result_ = nullptr;
};

}  // namespace glide
