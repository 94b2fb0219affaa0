#pragma once

#include "gpu/gl_caps.h"
#include "gpu/gl_objects.h"
#include "gpu/gpu_commands.h"
#include "photometric/align_types.h"

#include "base/stopwatch.h"

#include <array>

namespace glide {

void deleteQuery(GLuint name);

/// How far timing may slow down what it times.
enum class GpuTiming {
  passive,  ///< No wait of its own.
  stages,   ///< For benchmarks: waits for the GPU at the end of a stage.
  levels,   ///< For benchmarks: at the end of each level of the track stage, too.
};

/// Milliseconds of the stages of a direct frame. Lives on the GL thread.
/// With GL_EXT_disjoint_timer_query: GPU time between two GL_TIMESTAMP_EXT queries around the
/// stage, read after the alignment's fence; the stage timings wait for nothing but the end of
/// track. A stage that was issued after the last fence (a reference made after the alignment) is
/// reported from the next collect() on; until then its previous time stands, or the wall clock of
/// the call when there is none yet.
/// Without: wall clock of the calls. Passive, work that the driver defers is then part of the
/// readback, which ends with the fence; else each stage ends when the GPU has done it.
/// The readback is always wall clock: passive with the wait for the GPU, else from the GPU's end of
/// track until the result is in memory.
class GpuTimer {
 public:
  static GpuTimer create(const GlCaps& caps, GpuTiming timing);

  void begin(GpuStage stage);
  void end(GpuStage stage);
  /// Until the next call or the stage's end, work is that of `level`. Nothing unless
  /// GpuTiming::levels.
  void beginLevel(int level);
  /// Takes over the times that have arrived. Call after the fence.
  void collect();

  double stageMs(GpuStage stage) const { return stages_[static_cast<std::size_t>(stage)].ms; }
  /// 0 for a level that no beginLevel has named.
  double levelMs(int level) const { return levels_[static_cast<std::size_t>(level)].ms; }
  /// The stages as the trackers report them: align is track, with the readback where that holds the
  /// wait for the GPU.
  AlignTimes times() const;
  /// Whether times are the GPU's own: only in the context of creation, since contexts do not share
  /// queries.
  bool usesQueries() const;
  /// Forgets all names without a GL call: the context is gone.
  void abandon();

 private:
  struct Span {
    GlName<deleteQuery> begin, end;
    Stopwatch wall;
    bool pending = false;
    double ms = 0.0;
  };
  explicit GpuTimer(GpuTiming timing) : timing_(timing) {}
  void makeQueries(Span* span) const;
  void open(Span* span);
  void close(Span* span);
  void closeLevel();
  void read(Span* span) const;

  std::array<Span, kGpuStages> stages_;
  std::array<Span, kMaxAlignLevels> levels_;
  GpuTiming timing_;
  int open_level_ = -1;            ///< none
  const void* context_ = nullptr;  ///< EGLContext of the queries
  PFNGLQUERYCOUNTEREXTPROC write_timestamp_ = nullptr;
  PFNGLGETQUERYOBJECTUI64VEXTPROC get_result_ = nullptr;
};

}  // namespace glide
