# glide_module(NAME LINKS ... PRIVATE ...): the static library glide_NAME of all sources in core/NAME.
# Layers (docs/architecture.md) are checked by desktop-test/check_layers.py, not here.
function(glide_module name)
  cmake_parse_arguments(ARG "" "" "LINKS;PRIVATE" ${ARGN})
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*.cpp)
  if(ANDROID)
    list(FILTER sources EXCLUDE REGEX "_none\\.cpp$")  # what other systems have instead of NAME_android.cpp
  else()
    list(FILTER sources EXCLUDE REGEX "_android\\.cpp$")
  endif()
  if(NOT sources)
    return()
  endif()
  add_library(glide_${name} STATIC ${sources})
  target_include_directories(glide_${name} PUBLIC
    $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/core> $<BUILD_INTERFACE:${CMAKE_SOURCE_DIR}/core/include>)
  target_link_libraries(glide_${name} PUBLIC glide_flags ${ARG_LINKS} PRIVATE ${ARG_PRIVATE})
  if(GLIDE_PCH)
    target_precompile_headers(glide_${name} REUSE_FROM glide_pch)
  endif()
endfunction()

# glide_tests(NAME [PREFIX prefix] LINKS ...): the test program [prefix]NAME_test of all *_test.cpp (and *_fixture.cpp) in
# this folder's NAME, one ctest entry per test program.
function(glide_tests name)
  cmake_parse_arguments(ARG "" "PREFIX" "LINKS;LABELS" ${ARGN})
  set(program ${ARG_PREFIX}${name}_test)
  file(GLOB sources CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*_test.cpp
       ${CMAKE_CURRENT_SOURCE_DIR}/${name}/*_fixture.cpp)
  if(NOT sources)
    return()
  endif()
  add_executable(${program} ${sources})
  target_link_libraries(${program} PRIVATE glide_test_support ${ARG_LINKS} GTest::gmock GTest::gtest_main)
  if(GLIDE_PCH)
    # The precompiled header is position-independent code; an executable's -fPIE would not match it.
    set_target_properties(${program} PROPERTIES POSITION_INDEPENDENT_CODE OFF)
    target_compile_options(${program} PRIVATE -fPIC)
    target_precompile_headers(${program} REUSE_FROM glide_pch)
  endif()
  add_test(NAME ${program} COMMAND ${program})
  set_tests_properties(${program} PROPERTIES LABELS "${ARG_LABELS}"
    ENVIRONMENT "GLIDE_SOURCE_DIR=${CMAKE_SOURCE_DIR}")
endfunction()
