# Flags that every target of the project shares, as the interface target glide_flags.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
set(CMAKE_POSITION_INDEPENDENT_CODE ON)
set(CMAKE_CXX_VISIBILITY_PRESET hidden)
set(CMAKE_VISIBILITY_INLINES_HIDDEN ON)
set(CMAKE_EXPORT_COMPILE_COMMANDS ON)
if(NOT CMAKE_BUILD_TYPE)
  set(CMAKE_BUILD_TYPE Release)
endif()
# Asserts stay on in every preset; Eigen's own range checks are paid for in debug builds only.
set(CMAKE_CXX_FLAGS_RELEASE "-O2")

find_program(GLIDE_CCACHE ccache)
if(GLIDE_CCACHE AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  set(CMAKE_CXX_COMPILER_LAUNCHER
      ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros,include_file_mtime,include_file_ctime
      ${GLIDE_CCACHE})
endif()

add_library(glide_flags INTERFACE)
target_compile_options(glide_flags INTERFACE -Wall -Wextra -Wconversion -Wshadow
  $<$<CXX_COMPILER_ID:GNU>:-fpch-preprocess> $<$<CXX_COMPILER_ID:Clang>:-Wno-missing-braces>)
# The sanitizers' instrumentation makes gcc's flow warnings see ghosts; the plain builds judge warnings.
if(GLIDE_WERROR AND NOT GLIDE_SANITIZE)
  target_compile_options(glide_flags INTERFACE -Werror)
endif()
# Phones count every byte of a library: what nothing calls can be left out, function by function.
if(CMAKE_CROSSCOMPILING)
  target_compile_options(glide_flags INTERFACE -ffunction-sections -fdata-sections)
endif()
if(CMAKE_BUILD_TYPE STREQUAL "Release")
  target_compile_definitions(glide_flags INTERFACE EIGEN_NO_DEBUG)
endif()
if(GLIDE_SANITIZE)
  target_compile_options(glide_flags INTERFACE -fsanitize=${GLIDE_SANITIZE} -fno-omit-frame-pointer -g1 -O1)
  target_link_options(glide_flags INTERFACE -fsanitize=${GLIDE_SANITIZE})
endif()
# Our shared libraries carry no dead code and show nothing of what they are linked from. What they need must be there when
# they are linked; clang's sanitizers, though, are in the program alone.
set(glide_shared_link_options -Wl,--gc-sections -Wl,--exclude-libs,ALL)
if(NOT (GLIDE_SANITIZE AND CMAKE_CXX_COMPILER_ID MATCHES "Clang"))
  list(APPEND glide_shared_link_options -Wl,--no-undefined)
endif()
if(GLIDE_FUZZ)
  # Coverage for the fuzzer; and what the sanitizers find ends the program.
  target_compile_options(glide_flags INTERFACE -fsanitize=fuzzer-no-link -fno-sanitize-recover=all)
  target_link_options(glide_flags INTERFACE -fsanitize=fuzzer-no-link)
endif()
