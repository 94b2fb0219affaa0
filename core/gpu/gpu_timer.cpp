#include "gpu/gpu_timer.h"

#include <EGL/egl.h>

#include <algorithm>

namespace glide {
namespace {

constexpr double kMsPerNs = 1e-6;

constexpr int kNoLevel = -1;

template <class Function>
Function load(const char* name) {
  return reinterpret_cast<Function>(eglGetProcAddress(name));
}

/// Whether the timestamp counter exists; some drivers have the extension with zero bits.
bool countsTimestamps() {
  const auto get = load<PFNGLGETQUERYIVEXTPROC>("glGetQueryivEXT");
  if (get == nullptr) return false;
  GLint bits = 0;
  get(GL_TIMESTAMP_EXT, GL_QUERY_COUNTER_BITS_EXT, &bits);
  return bits > 0;
}

GLuint newQuery() {
  GLuint name = 0;
  glGenQueries(1, &name);
  return name;
}

}  // namespace

void deleteQuery(GLuint name) { glDeleteQueries(1, &name); }

GpuTimer GpuTimer::create(const GlCaps& caps, GpuTiming timing) {
  GpuTimer timer(timing);
  if (!caps.has_timer_query || !countsTimestamps()) return timer;
  const auto write = load<PFNGLQUERYCOUNTEREXTPROC>("glQueryCounterEXT");
  const auto get = load<PFNGLGETQUERYOBJECTUI64VEXTPROC>("glGetQueryObjectui64vEXT");
  if (write == nullptr || get == nullptr) return timer;
  timer.context_ = eglGetCurrentContext();
  timer.write_timestamp_ = write;
  timer.get_result_ = get;
  for (Span& span : timer.stages_) timer.makeQueries(&span);
  timer.stages_[static_cast<std::size_t>(GpuStage::readback)] = Span{};  // wall clock
  if (timing != GpuTiming::levels) return timer;
  for (Span& span : timer.levels_) timer.makeQueries(&span);
  return timer;
}

bool GpuTimer::usesQueries() const {
  return write_timestamp_ != nullptr && eglGetCurrentContext() == context_;
}

void GpuTimer::makeQueries(Span* span) const {
  span->begin = GlName<deleteQuery>(newQuery());
  span->end = GlName<deleteQuery>(newQuery());
}

void GpuTimer::begin(GpuStage stage) { open(&stages_[static_cast<std::size_t>(stage)]); }

void GpuTimer::end(GpuStage stage) {
  closeLevel();
  close(&stages_[static_cast<std::size_t>(stage)]);
  // With queries only the readback's clock needs the GPU to be done with what is before it.
  if (timing_ != GpuTiming::passive && usesQueries() && stage == GpuStage::track) {
    GlSync::insert().wait(kGpuTimeoutNs);
  }
}

void GpuTimer::beginLevel(int level) {
  if (timing_ != GpuTiming::levels) return;
  closeLevel();
  open_level_ = level;
  open(&levels_[static_cast<std::size_t>(level)]);
}

void GpuTimer::closeLevel() {
  if (open_level_ == kNoLevel) return;
  close(&levels_[static_cast<std::size_t>(open_level_)]);
  open_level_ = kNoLevel;
}

void GpuTimer::open(Span* span) {
  span->wall.lapMs();
  if (span->begin.get() != 0 && usesQueries())
    write_timestamp_(span->begin.get(), GL_TIMESTAMP_EXT);
}

void GpuTimer::close(Span* span) {
  const bool has_query = span->end.get() != 0 && usesQueries();
  // A fence that is never reached leaves a time that is too short, and an alignment that fails.
  if (timing_ != GpuTiming::passive && !usesQueries()) GlSync::insert().wait(kGpuTimeoutNs);
  const double wall_ms = span->wall.lapMs();
  if (!has_query || span->ms == 0.0) span->ms = wall_ms;
  if (!has_query) return;
  write_timestamp_(span->end.get(), GL_TIMESTAMP_EXT);
  span->pending = true;
}

void GpuTimer::collect() {
  for (Span& span : stages_) read(&span);
  for (Span& span : levels_) read(&span);
}

void GpuTimer::read(Span* span) const {
  if (!span->pending || !usesQueries()) return;
  GLuint available = 0;
  glGetQueryObjectuiv(span->end.get(), GL_QUERY_RESULT_AVAILABLE, &available);
  if (available == 0) return;
  GLuint64 begin_ns = 0;
  GLuint64 end_ns = 0;
  get_result_(span->begin.get(), GL_QUERY_RESULT_EXT, &begin_ns);
  get_result_(span->end.get(), GL_QUERY_RESULT_EXT, &end_ns);
  span->pending = false;
  // GL_GPU_DISJOINT_EXT would tell of a counter that jumped, but reading takes it from the app.
  if (end_ns < begin_ns) return;
  span->ms = static_cast<double>(end_ns - begin_ns) * kMsPerNs;
}

void GpuTimer::abandon() {
  const auto drop = [](Span& span) {
    span.begin.abandon();
    span.end.abandon();
  };
  std::for_each(stages_.begin(), stages_.end(), drop);
  std::for_each(levels_.begin(), levels_.end(), drop);
}

AlignTimes GpuTimer::times() const {
  const double wait_ms = usesQueries() ? 0.0 : stageMs(GpuStage::readback);
  return {stageMs(GpuStage::upload) + stageMs(GpuStage::pyramid),
          stageMs(GpuStage::precompute),
          stageMs(GpuStage::track) + wait_ms};
}

}  // namespace glide
