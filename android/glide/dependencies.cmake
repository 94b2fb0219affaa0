# Read by CMake's project() in Gradle's builds, which pass the same arguments for every ABI.
set(GLIDE_ANDROID_DEPS ${CMAKE_CURRENT_LIST_DIR}/../../build/cache/deps/${ANDROID_ABI})
