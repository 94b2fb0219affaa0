# Tests on the software drivers of docs/drivers.md. Those that CI runs on; the others are for `./glide test --driver`.
set(GLIDE_DRIVERS llvmpipe softpipe zink angle-swiftshader angle-lavapipe)
set(GLIDE_CI_DRIVERS llvmpipe softpipe angle-swiftshader)

# glide_driver_test(NAME DRIVER [OPT_IN] COMMAND ... [ENVIRONMENT ...]): the test NAME_DRIVER, with the label driver-DRIVER.
# OPT_IN, and every driver that is not CI's: only `ctest -C drivers` runs it. Status 77 is a skip, as it is where the driver
# is not to be had.
function(glide_driver_test name driver)
  cmake_parse_arguments(ARG "OPT_IN" "" "COMMAND;ENVIRONMENT" ${ARGN})
  set(configurations)
  if(ARG_OPT_IN OR NOT driver IN_LIST GLIDE_CI_DRIVERS)
    set(configurations CONFIGURATIONS drivers)
  endif()
  add_test(NAME ${name}_${driver} ${configurations}
    COMMAND ${PROJECT_SOURCE_DIR}/scripts/with_driver.sh ${driver} ${ARG_COMMAND})
  set_tests_properties(${name}_${driver} PROPERTIES LABELS "gpu;driver-${driver}" SKIP_RETURN_CODE 77 TIMEOUT 600
    ENVIRONMENT "${ARG_ENVIRONMENT}")
endfunction()

# glide_limits_test(NAME COMMAND ... [ENVIRONMENT ...]): the test NAME_limits_llvmpipe, on a device with the least that
# OpenGL ES 3.1 allows (desktop-test/gl_limits).
function(glide_limits_test name)
  cmake_parse_arguments(ARG "" "" "COMMAND;ENVIRONMENT" ${ARGN})
  if(TARGET glide_gl_limits)
    glide_driver_test(${name}_limits llvmpipe
      COMMAND env LD_PRELOAD=$<TARGET_FILE:glide_gl_limits> MESA_GLES_VERSION_OVERRIDE=3.1 ${ARG_COMMAND}
      ENVIRONMENT ${ARG_ENVIRONMENT})
  endif()
endfunction()
