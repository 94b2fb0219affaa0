#include "gpu/program_cache.h"

#include "gpu/gl_caps.h"

#include <algorithm>
#include <cstring>

namespace glide {
namespace {

constexpr std::string_view kKind = "program";

bool isLinked(const GlProgram& program) {
  GLint is_linked = GL_FALSE;
  glGetProgramiv(program.get(), GL_LINK_STATUS, &is_linked);
  return is_linked == GL_TRUE;
}

}  // namespace

ProgramCache::ProgramCache(DeviceCache files, const GlCaps& caps)
    : files_(std::move(files)), formats_(caps.program_binary_formats) {}

std::optional<GlProgram> ProgramCache::load(const std::string& text) const {
  if (!isKept()) return std::nullopt;
  const std::optional<std::vector<std::byte>> value = files_.load(kKind, text);
  GLenum format = 0;
  if (!value || value->size() <= sizeof(format)) return std::nullopt;
  std::memcpy(&format, value->data(), sizeof(format));
  // An unknown format would leave an error for the app to find.
  if (std::find(formats_.begin(), formats_.end(), format) == formats_.end()) return std::nullopt;
  GlProgram program(glCreateProgram());
  glProgramBinary(program.get(),
                  format,
                  value->data() + sizeof(format),
                  static_cast<GLsizei>(value->size() - sizeof(format)));
  if (!isLinked(program)) return std::nullopt;
  return program;
}

void ProgramCache::prepare(const GlProgram& program) const {
  if (isKept()) glProgramParameteri(program.get(), GL_PROGRAM_BINARY_RETRIEVABLE_HINT, GL_TRUE);
}

void ProgramCache::store(const std::string& text, const GlProgram& program) const {
  if (!isKept()) return;
  GLint bytes = 0;
  glGetProgramiv(program.get(), GL_PROGRAM_BINARY_LENGTH, &bytes);
  if (bytes <= 0) return;
  GLenum format = 0;
  std::vector<std::byte> value(sizeof(format) + static_cast<std::size_t>(bytes));
  GLsizei written = 0;
  glGetProgramBinary(program.get(), bytes, &written, &format, value.data() + sizeof(format));
  if (written <= 0) return;
  std::memcpy(value.data(), &format, sizeof(format));
  value.resize(sizeof(format) + static_cast<std::size_t>(written));
  files_.store(kKind, text, value);
}

}  // namespace glide
