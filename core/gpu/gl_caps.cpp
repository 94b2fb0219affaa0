#include "gpu/gl_caps.h"

#include "gpu/gl_query.h"

#include <cctype>

namespace glide {
namespace {

constexpr std::array<int, 2> kNeeded{3, 1};

std::string glString(GLenum name) {
  const GLubyte* text = glGetString(name);
  return text == nullptr ? std::string() : reinterpret_cast<const char*>(text);
}

bool hasExtension(std::string_view extension) {
  const int count = glInteger(GL_NUM_EXTENSIONS);
  for (int i = 0; i < count; ++i) {
    const GLubyte* text = glGetStringi(GL_EXTENSIONS, static_cast<GLuint>(i));
    if (text != nullptr && extension == reinterpret_cast<const char*>(text)) return true;
  }
  return false;
}

Error unsupported(const std::string& message) { return {ErrorCode::unsupported, message}; }

void queryLimits(GlCaps* caps) {
  caps->max_group_invocations = glInteger(GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS);
  caps->max_shared_bytes = glInteger(GL_MAX_COMPUTE_SHARED_MEMORY_SIZE);
  caps->max_storage_blocks = glInteger(GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS);
  caps->max_texture_size = glInteger(GL_MAX_TEXTURE_SIZE);
  GLint64 bytes = 0;
  glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &bytes);
  caps->max_storage_bytes = bytes;
}

std::vector<std::uint32_t> binaryFormats() {
  std::vector<GLint> formats(static_cast<std::size_t>(glInteger(GL_NUM_PROGRAM_BINARY_FORMATS)));
  if (!formats.empty()) glGetIntegerv(GL_PROGRAM_BINARY_FORMATS, formats.data());
  return {formats.begin(), formats.end()};
}

}  // namespace

Result<GlCaps> GlCaps::query() {
  GlCaps caps;
  caps.version = glString(GL_VERSION);
  if (caps.version.empty()) {
    return Error{ErrorCode::missing_context, "OpenGL ES: no context is current on this thread"};
  }
  caps.vendor = glString(GL_VENDOR);
  caps.renderer = glString(GL_RENDERER);
  const std::optional<std::array<int, 2>> es_version = parseEsVersion(caps.version);
  if (!es_version || *es_version < kNeeded) {
    return unsupported("OpenGL ES 3.1 is needed, but the current context is \"" + caps.version +
                       "\" on \"" + caps.renderer + "\"");
  }
  caps.es_version = *es_version;
  caps.quirks = driverQuirks({caps.vendor, caps.renderer, caps.version});
  caps.has_timer_query = hasExtension("GL_EXT_disjoint_timer_query");
  caps.has_external = hasExtension("GL_OES_EGL_image_external");
  caps.has_external_essl3 = hasExtension("GL_OES_EGL_image_external_essl3");
  caps.program_binary_formats = binaryFormats();
  queryLimits(&caps);
  return caps;
}

std::optional<std::array<int, 2>> parseEsVersion(std::string_view version) {
  constexpr std::string_view kPrefix = "OpenGL ES ";
  if (version.substr(0, kPrefix.size()) != kPrefix) return std::nullopt;
  const std::string_view number = version.substr(kPrefix.size());
  const auto digit = [](char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; };
  if (number.size() < 3 || !digit(number[0]) || number[1] != '.' || !digit(number[2])) {
    return std::nullopt;
  }
  return std::array<int, 2>{number[0] - '0', number[2] - '0'};
}

}  // namespace glide
