#pragma once

#include "gpu/device_cache.h"
#include "gpu/gl.h"
#include "gpu/gl_objects.h"

#include <optional>
#include <string>
#include <vector>

namespace glide {

struct GlCaps;

/// Linked programs from one start of the app to the next (glGetProgramBinary), by their whole text,
/// which has the defines in it. A binary that is damaged, of another driver, or that the driver
/// refuses is as if it were not there; then the caller builds and stores the program anew. Where
/// the driver has no binary format nothing is kept. Values, used on the GL thread; calls no
/// glGetError and makes no error pending.
class ProgramCache {
 public:
  /// Keeps nothing.
  ProgramCache() = default;
  ProgramCache(DeviceCache files, const GlCaps& caps);

  bool isKept() const { return files_.isKept() && !formats_.empty(); }
  /// The program of `text`, linked and ready.
  std::optional<GlProgram> load(const std::string& text) const;
  /// Before the program is linked, so that the driver keeps what store() asks for.
  void prepare(const GlProgram& program) const;
  /// Keeps `program`, which was built from `text`.
  void store(const std::string& text, const GlProgram& program) const;

 private:
  DeviceCache files_;
  std::vector<GLenum> formats_;  ///< that the driver takes
};

}  // namespace glide
