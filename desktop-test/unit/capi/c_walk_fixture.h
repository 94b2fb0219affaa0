#pragma once

#include "unit/session/sequence_fixture.h"

#include "glide/glide.h"

#include <cstdint>
#include <string>
#include <vector>

namespace glide::test {

/// A glide_session that follows SequenceFixture's walk: inline mapping on the CPU.
class CWalk {
 public:
  /// Axes are GLIDE_AXES_*.
  explicit CWalk(std::int32_t axes);
  /// The same with GLIDE_EXECUTION_*.
  CWalk(std::int32_t axes, std::int32_t execution);
  /// The same with the axes, execution, log and log_user of a config.
  explicit CWalk(const glide_config& wishes);
  /// GL axes and one setting more, "key=value"; it must outlive this.
  explicit CWalk(const char* setting);
  ~CWalk();
  CWalk(const CWalk&) = delete;
  CWalk& operator=(const CWalk&) = delete;

  /// The config that the session was made with; its settings live as long as this.
  const glide_config& config() const { return config_; }
  glide_session* session() const { return session_; }
  /// The image of a frame of the walk; each is rendered once in the program.
  static const ImageU8& image(int frame);
  /// Feeds the image at x metres; the status is in status().
  glide_frame feed(double x);
  glide_frame feed(const ImageU8& image);
  /// Walks until it has fed `count` frames in all. The last answer.
  glide_frame walk(int count);
  glide_status status() const { return status_; }
  const SequenceFixture& sequence() const { return sequence_; }

 private:
  CWalk(const glide_config& wishes, std::vector<const char*> settings);

  SequenceFixture sequence_;
  std::vector<const char*> settings_;
  glide_config config_;
  glide_session* session_ = nullptr;
  glide_status status_ = GLIDE_OK;
  std::int64_t t_ns_ = 0;
  int fed_ = 0;
};

/// A zeroed struct that knows its size.
template <class T>
T sized() {
  T value;
  GLIDE_INIT(value);
  return value;
}

}  // namespace glide::test
