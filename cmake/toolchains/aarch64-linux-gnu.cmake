# Debian's g++-aarch64-linux-gnu: the nearest to Android's arm64 that needs no NDK (./glide test --arch arm64).
# scripts/arm64.sh fills these two folders. Not with GLIDE_PCH: gcc 12 crashes where arm_sve.h follows a precompiled header.
cmake_path(SET glide_cache NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../../build/cache")
set(glide_arm64_system ${glide_cache}/arm64/system)
set(glide_arm64_dependencies ${glide_cache}/deps/aarch64-linux-gnu)

set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_LIBRARY_ARCHITECTURE aarch64-linux-gnu)

set(CMAKE_FIND_ROOT_PATH ${glide_arm64_dependencies} ${glide_arm64_system})
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# EGL and OpenGL ES are found by their names alone.
foreach(language C CXX)
  set(CMAKE_${language}_FLAGS_INIT "-isystem ${glide_arm64_system}/usr/include")
endforeach()
set(glide_arm64_link "-L${glide_arm64_system}/usr/lib -Wl,-rpath-link,${glide_cache}/mobile/sysroot/usr/lib/aarch64-linux-gnu")
foreach(kind EXE SHARED MODULE)
  set(CMAKE_${kind}_LINKER_FLAGS_INIT "${glide_arm64_link}")
endforeach()

set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L ${glide_cache}/mobile/sysroot)
