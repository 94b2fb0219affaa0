#pragma once

#include "gpu/driver_quirks.h"

#include "glide/result.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glide {

/// What the current OpenGL ES context is and can do.
struct GlCaps {
  std::string vendor, renderer, version;
  std::array<int, 2> es_version{};     ///< major, minor; at least 3.1
  DriverQuirks quirks;                 ///< from vendor, renderer and version
  bool has_timer_query = false;        ///< GL_EXT_disjoint_timer_query
  bool has_external = false;           ///< GL_OES_EGL_image_external: ESSL 1 samples such textures
  bool has_external_essl3 = false;     ///< GL_OES_EGL_image_external_essl3: compute shaders do
  int max_group_invocations = 0;       ///< per compute workgroup, at least 128
  int max_shared_bytes = 0;            ///< per compute workgroup, at least 16384
  int max_storage_blocks = 0;          ///< per compute shader, at least 4
  int max_texture_size = 0;            ///< px
  std::int64_t max_storage_bytes = 0;  ///< of one shader storage block, at least 2^27
  /// Of glProgramBinary; many drivers have none.
  std::vector<std::uint32_t> program_binary_formats;

  /// Asks the context that is current on this thread. missing_context when there is none,
  /// unsupported, with what is there instead, when it is not OpenGL ES 3.1 or newer.
  static Result<GlCaps> query();
};

/// Major and minor of a GL_VERSION string of OpenGL ES 2 or newer; nothing for ES 1 and desktop GL.
std::optional<std::array<int, 2>> parseEsVersion(std::string_view version);

}  // namespace glide
