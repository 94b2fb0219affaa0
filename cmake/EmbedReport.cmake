# cmake -DNODE=... -DNPM=... -DFOLDER=... -DCACHE=... -DOUTPUT=... -P EmbedReport.cmake: see GlideReport.cmake.
set(page "")
set(status "no node and npm")
if(NODE AND NPM)
  file(MAKE_DIRECTORY ${CACHE})
  file(LOCK ${CACHE}/lock TIMEOUT 600)  # build folders share the cache
  execute_process(COMMAND ${NODE} ${FOLDER}/build.mjs ${CACHE} ${OUTPUT}.html RESULT_VARIABLE status)
endif()
if(status EQUAL 0)
  file(READ ${OUTPUT}.html page)
elseif(NODE AND NPM)
  message(WARNING "the page of report.html could not be built (${status}): glide-replay will write none")
endif()
file(WRITE "${OUTPUT}.new" "// Generated from ${FOLDER}; do not edit.
#include \"replay/outputs/report_template.h\"

namespace glide::replay {

std::string_view reportTemplate() { return R\"page(${page})page\"; }

}  // namespace glide::replay
")
file(RENAME "${OUTPUT}.new" "${OUTPUT}")
if(page OR NOT NODE OR NOT NPM)
  file(TOUCH ${OUTPUT}.built)
else()
  file(REMOVE ${OUTPUT}.built)
endif()
