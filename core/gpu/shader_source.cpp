#include "gpu/shader_source.h"

#include <algorithm>

namespace glide {
namespace {

constexpr std::string_view kInclude = "#include \"";
constexpr std::string_view kVersion = "#version";

/// Files include files at most this deep; more is a cycle.
constexpr int kMaxDepth = 4;

Error missing(std::string_view name) {
  return {ErrorCode::internal, "shader file " + std::string(name) + " is not embedded"};
}

/// Cuts the first line off `text`, without its end.
std::string_view takeLine(std::string_view* text) {
  const std::size_t end = std::min(text->find('\n'), text->size());
  const std::string_view line = text->substr(0, end);
  text->remove_prefix(std::min(end + 1, text->size()));
  return line;
}

class Assembler {
 public:
  Assembler(std::span<const EmbeddedShader> library, const ShaderDefines& defines)
      : library_(library), defines_(defines) {}

  Status append(std::string_view name, int depth) {
    const auto file = std::find_if(
        library_.begin(), library_.end(), [&](const EmbeddedShader& s) { return s.name == name; });
    if (file == library_.end() || depth > kMaxDepth) return missing(name);
    std::string_view text = file->text;
    while (!text.empty()) {
      Status status = appendLine(takeLine(&text), depth);
      if (!status) return status;
    }
    return Unit{};
  }

  std::string takeText() { return std::move(text_); }

 private:
  Status appendLine(std::string_view line, int depth) {
    if (line.substr(0, kInclude.size()) == kInclude) {
      line.remove_prefix(kInclude.size());
      return append(line.substr(0, line.find('"')), depth + 1);
    }
    text_.append(line).append("\n");
    if (line.substr(0, kVersion.size()) == kVersion) {
      for (const ShaderDefine& define : defines_) {
        text_.append("#define ").append(define.name).append(" ");
        text_.append(std::to_string(define.value)).append("\n");
      }
    }
    return Unit{};
  }

  std::span<const EmbeddedShader> library_;
  const ShaderDefines& defines_;
  std::string text_;
};

}  // namespace

Result<std::string> assembleShader(std::span<const EmbeddedShader> library,
                                   std::string_view name,
                                   const ShaderDefines& defines) {
  Assembler assembler(library, defines);
  Status status = assembler.append(name, 0);
  if (!status) return status.error();
  return assembler.takeText();
}

}  // namespace glide
