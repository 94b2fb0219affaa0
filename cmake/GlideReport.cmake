# glide_embed_report(TARGET): at build time, the page of desktop-test/report becomes a generated source of TARGET, which
# defines glide::replay::reportTemplate() (desktop-test/replay/outputs/report_template.h). Without node and npm, or when
# npm cannot fetch its packages, the page is empty.
find_program(GLIDE_NODE node)
find_program(GLIDE_NPM npm)

function(glide_embed_report target)
  set(folder ${PROJECT_SOURCE_DIR}/desktop-test/report)
  set(script ${PROJECT_SOURCE_DIR}/cmake/EmbedReport.cmake)
  set(output ${CMAKE_CURRENT_BINARY_DIR}/${target}_report.cpp)
  if(NOT GLIDE_NODE OR NOT GLIDE_NPM)
    message(STATUS "No node and npm: glide-replay will write no report.html")
  endif()
  file(GLOB sources CONFIGURE_DEPENDS ${folder}/src/*.js ${folder}/src/*/*.js ${folder}/*.json ${folder}/*.mjs
       ${folder}/style.css ${folder}/template.html)
  if(EXISTS ${output}.failed)  # without a registry npm takes a while to find out: not in every build
    file(TIMESTAMP ${output}.failed failed "%s" UTC)
    string(TIMESTAMP now "%s" UTC)
    math(EXPR seconds "${now} - ${failed}")
    if(seconds GREATER 3600)
      file(REMOVE ${output}.built)
    endif()
  endif()
  add_custom_command(
    OUTPUT ${output}.built
    BYPRODUCTS ${output}
    COMMAND ${CMAKE_COMMAND} -DNODE=${GLIDE_NODE} -DNPM=${GLIDE_NPM} -DFOLDER=${folder}
            -DCACHE=${PROJECT_SOURCE_DIR}/build/cache/report -DOUTPUT=${output} -P ${script}
    DEPENDS ${sources} ${script}
    COMMENT "Building the page of report.html"
    VERBATIM)
  target_sources(${target} PRIVATE ${output} ${output}.built)
endfunction()
