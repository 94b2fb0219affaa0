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
  message(WARNING "the page of report.html could not be built (${status}): glide-replay will write none; tried again in an hour, or "
          "when ${OUTPUT}.built is removed")
endif()
file(WRITE "${OUTPUT}.new" "// Generated from ${FOLDER}; do not edit.
#include \"replay/outputs/report_template.h\"

namespace glide::replay {

std::string_view reportTemplate() { return R\"page(${page})page\"; }

}  // namespace glide::replay
")
file(COPY_FILE "${OUTPUT}.new" "${OUTPUT}" ONLY_IF_DIFFERENT)  # what includes it need not be compiled again
file(REMOVE "${OUTPUT}.new" "${OUTPUT}.failed")
if(NODE AND NPM AND NOT page)
  file(TOUCH "${OUTPUT}.failed")
endif()
file(TOUCH "${OUTPUT}.built")
