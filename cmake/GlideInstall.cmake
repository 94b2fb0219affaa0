# cmake --install: the library, its public headers, and what find_package(glide) needs.
include(CMakePackageConfigHelpers)

set(glide_config_folder ${CMAKE_INSTALL_LIBDIR}/cmake/glide)

install(TARGETS glide EXPORT glideTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR})
install(DIRECTORY ${PROJECT_SOURCE_DIR}/core/include/glide DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}
  FILES_MATCHING PATTERN "*.h")
install(EXPORT glideTargets NAMESPACE glide:: DESTINATION ${glide_config_folder})

configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/glideConfig.cmake.in
  ${CMAKE_CURRENT_BINARY_DIR}/glideConfig.cmake INSTALL_DESTINATION ${glide_config_folder})
# Until 1.0 every minor version may change the API.
write_basic_package_version_file(${CMAKE_CURRENT_BINARY_DIR}/glideConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${CMAKE_CURRENT_BINARY_DIR}/glideConfig.cmake ${CMAKE_CURRENT_BINARY_DIR}/glideConfigVersion.cmake
  DESTINATION ${glide_config_folder})
