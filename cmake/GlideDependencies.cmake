# The libraries that the core links (docs/provenance.md).
if(GLIDE_ANDROID_DEPS)
  list(PREPEND CMAKE_FIND_ROOT_PATH ${GLIDE_ANDROID_DEPS})
  list(PREPEND CMAKE_PREFIX_PATH ${GLIDE_ANDROID_DEPS})
endif()
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
# The suffix: where OpenCV installs itself for Android.
find_package(OpenCV REQUIRED COMPONENTS core imgproc PATH_SUFFIXES sdk/native/jni/abi-${ANDROID_ABI})
find_package(Ceres REQUIRED)
find_package(Threads REQUIRED)
find_package(ZLIB REQUIRED)
if(GLIDE_GLES)
  find_package(glm REQUIRED)
endif()

# Highway's own package names its target differently from version to version.
find_library(GLIDE_HWY_LIBRARY hwy REQUIRED)
find_path(GLIDE_HWY_INCLUDE hwy/highway.h REQUIRED)
add_library(hwy UNKNOWN IMPORTED)
set_target_properties(hwy PROPERTIES IMPORTED_LOCATION ${GLIDE_HWY_LIBRARY}
  INTERFACE_INCLUDE_DIRECTORIES ${GLIDE_HWY_INCLUDE})
