# glide_embed_shaders(TARGET [DIRECTORY FUNCTION]): at build time, every file of DIRECTORY (default: shaders/)
# becomes a string_view in a generated source of TARGET, which defines
#   std::span<const glide::EmbeddedShader> FUNCTION();      (default: glide::embeddedShaders, core/gpu/shader_source.h)
# #include lines are resolved when a program is built.
function(glide_embed_shaders target)
  set(directory ${CMAKE_SOURCE_DIR}/shaders)
  set(function_name embeddedShaders)
  set(script ${CMAKE_CURRENT_FUNCTION_LIST_DIR}/EmbedShaders.cmake)
  if(ARGC GREATER 2)
    set(directory ${ARGV1})
    set(function_name ${ARGV2})
  endif()
  file(GLOB shaders CONFIGURE_DEPENDS ${directory}/*.comp ${directory}/*.vert ${directory}/*.frag ${directory}/*.glsl)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_shaders.cpp)
  add_custom_command(
    OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DDIRECTORY=${directory} -DFUNCTION=${function_name} -DOUTPUT=${output}
            -P ${script}
    DEPENDS ${shaders} ${script}
    COMMENT "Embedding shaders of ${target}"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()
