# cmake -DDIRECTORY=... -DFUNCTION=... -DOUTPUT=... -P EmbedShaders.cmake: see GlideShaders.cmake.
file(GLOB paths ${DIRECTORY}/*.comp ${DIRECTORY}/*.vert ${DIRECTORY}/*.frag ${DIRECTORY}/*.glsl)
list(SORT paths)
set(entries "")
foreach(path IN LISTS paths)
  get_filename_component(name "${path}" NAME)
  file(READ "${path}" text)
  string(APPEND entries "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
endforeach()
list(LENGTH paths count)
file(WRITE "${OUTPUT}.new" "// Generated from ${DIRECTORY}; do not edit.
#include \"gpu/shader_source.h\"

namespace glide {

std::span<const EmbeddedShader> ${FUNCTION}() {
  static constexpr EmbeddedShader kShaders[${count}] = {
${entries}  };
  return kShaders;
}

}  // namespace glide
")
file(RENAME "${OUTPUT}.new" "${OUTPUT}")
