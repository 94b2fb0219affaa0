#include "gpu/gpu_timer.h"

#include <EGL/egl.h>

namespace glide {
namespace {

constexpr double kMsPerNs = 1e-6;

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

GpuTimer GpuTimer::create(const GlCaps& caps) {
  GpuTimer timer;
  if (!caps.has_timer_query || !countsTimestamps()) return timer;
  const auto write = load<PFNGLQUERYCOUNTEREXTPROC>("glQueryCounterEXT");
  const auto get = load<PFNGLGETQUERYOBJECTUI64VEXTPROC>("glGetQueryObjectui64vEXT");
  if (write == nullptr || get == nullptr) return timer;
  timer.write_timestamp_ = write;
  timer.get_result_ = get;
  for (Span& span : timer.spans_) {
    span.begin = GlName<deleteQuery>(newQuery());
    span.end = GlName<deleteQuery>(newQuery());
  }
  return timer;
}

void GpuTimer::begin(Stage stage) {
  Span& s = span(stage);
  s.wall.lapMs();
  if (usesQueries()) write_timestamp_(s.begin.get(), GL_TIMESTAMP_EXT);
}

void GpuTimer::end(Stage stage) {
  Span& s = span(stage);
  const double wall_ms = s.wall.lapMs();
  if (!usesQueries() || s.ms == 0.0) s.ms = wall_ms;
  if (!usesQueries()) return;
  write_timestamp_(s.end.get(), GL_TIMESTAMP_EXT);
  s.pending = true;
}

void GpuTimer::collect() {
  for (Span& s : spans_) {
    if (s.pending && read(&s)) s.pending = false;
  }
}

bool GpuTimer::read(Span* span) const {
  GLuint available = 0;
  glGetQueryObjectuiv(span->end.get(), GL_QUERY_RESULT_AVAILABLE, &available);
  if (available == 0) return false;
  GLuint64 begin_ns = 0;
  GLuint64 end_ns = 0;
  get_result_(span->begin.get(), GL_QUERY_RESULT_EXT, &begin_ns);
  get_result_(span->end.get(), GL_QUERY_RESULT_EXT, &end_ns);
  span->ms = static_cast<double>(end_ns - begin_ns) * kMsPerNs;
  return true;
}

AlignTimes GpuTimer::times() const { return {spans_[0].ms, spans_[1].ms, spans_[2].ms}; }

}  // namespace glide
