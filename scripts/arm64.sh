# ./glide test --arch arm64: the library for aarch64-linux-gnu, its CPU tests and some GLES tests under qemu, and what
# NDK r23's library and clang say of the sources. Sourced after scripts/mobile_compilers.sh; expects $root.
# shellcheck shell=bash
: "${root:?}" "${mobile:?}" "${mobile_libraries:?}"

arm64_system="$root/build/cache/arm64/system"
arm64_dependencies="$root/build/cache/deps/aarch64-linux-gnu"
arm64_toolchain="$root/cmake/toolchains/aarch64-linux-gnu.cmake"

# Headers and libraries beside the cross compiler's own, as links: EGL and OpenGL ES by glvnd, and zlib.
arm64_link_system() {
  local new="$arm64_system.new" name
  rm -rf "$new" "$arm64_system" && mkdir -p "$new/usr/include" "$new/usr/lib" || return
  for name in EGL GLES2 GLES3 KHR; do ln -s "/usr/include/$name" "$new/usr/include/$name" || return; done
  for name in zlib.h zconf.h; do ln -s "$mobile/sysroot/usr/include/$name" "$new/usr/include/$name" || return; done
  ln -s "$mobile_libraries/libEGL.so.1" "$new/usr/lib/libEGL.so" &&
    ln -s "$mobile_libraries/libGLESv2.so.2" "$new/usr/lib/libGLESv2.so" &&
    ln -s "$mobile_libraries/libz.a" "$new/usr/lib/libz.a" && mv -T "$new" "$arm64_system"
}

# libc++ 11, as Debian 11 has it: the C++ library of NDK r23, the oldest that the library is to compile with.
arm64_libcxx="$root/build/cache/arm64/libcxx-11"

arm64_fetch_libcxx() {
  local apt="$root/build/cache/arm64/apt" new="$arm64_libcxx.new"
  rm -rf "$new" && mkdir -p "$new" && mobile_apt_files "$apt" bullseye || return
  (cd "$new" && mobile_apt_in "$apt" -o Acquire::Check-Valid-Until=false update &&
    mobile_apt_in "$apt" download libc++-11-dev && dpkg -x libc++-11-dev_*.deb .) && mv -T "$new" "$arm64_libcxx"
}

# Every source for arm64 as Android's clang sees it, but for the C library. Nothing is compiled to code.
arm64_check_portable() {
  local include="$arm64_dependencies/include"
  in_root git ls-files 'core/*.cpp' ':!core/*_android.cpp' | in_root xargs -P "$(jobs)" -n 1 clang++ \
    --target=aarch64-linux-gnu -std=c++20 -fsyntax-only -nostdinc++ -isystem "$arm64_libcxx/usr/lib/llvm-11/include/c++/v1" \
    -Icore -Icore/include -DGLIDE_GLES=1 -isystem "$arm64_system/usr/include" -isystem "$include" \
    -isystem "$include/eigen3" -isystem "$include/opencv4" -isystem "$include/ceres/internal/miniglog"
}

arm64_units=(base geometry image photometric feature map optimize track ar capi)
# What tracks whole walks takes a hundred times as long as natively; one of them, which also saves and loads, is left.
arm64_not='CScene*:CThreads.*:CSession.*:CMap.O*:CMap.Sa*:CMap.T*'
# Death tests that start their program anew: the kernel knows no arm64 programs, only the emulator does.
arm64_not+=':CExitDeathTest.*'
# Some of each: what a context has, kernels that write images, kernels that reduce, textures.
arm64_gles_tests='GlCapsTest.*:GpuPyramidTest.*:GpuAlignerTest.GivesTheCpus*:TextureReaderTest.TakesR8*'

arm64_unit_tests() {
  local expression
  expression="^($(
    IFS='|'
    echo "${arm64_units[*]}"
  ))_test$"
  build arm64 "${arm64_units[@]/%/_test}" && GTEST_FILTER="-$arm64_not" ctest_in arm64 -R "$expression"
}

# On Mesa's llvmpipe for arm64; the emulator's -L is where it and its drivers lie.
arm64_gles() {
  build arm64 gpu_test || return
  (
    use_mesa llvmpipe
    GLIDE_REQUIRE_GL=1 GLIDE_SOURCE_DIR="$root" MESA_SHADER_CACHE_DISABLE=true qemu-aarch64-static -L "$mobile/sysroot" \
      "$root/build/arm64/desktop-test/gpu/gpu_test" --gtest_filter="$arm64_gles_tests"
  )
}

# What an app would link and load, with all that it uses inside; the sizes are those of docs/android.md.
arm64_libraries() {
  local library stripped
  build arm64 glide glide_jni || return
  for library in core/libglide.so jni/libglide_jni.so; do
    stripped="$root/build/arm64/$(basename "$library").stripped"
    aarch64-linux-gnu-strip --strip-unneeded -o "$stripped" "$root/build/arm64/$library" || return
    say "$(basename "$library") for arm64, stripped: $(stat --format %s "$stripped") bytes"
  done
}

arm64_prepare() {
  setup mobile arm64 && mobile_prepare || return
  [ -d "$arm64_system" ] || arm64_link_system || return
  [ -d "$arm64_libcxx" ] || mobile_log libcxx "fetching libc++ 11 from deb.debian.org" arm64_fetch_libcxx || return
  "$root/scripts/android_deps.sh" "$arm64_toolchain" "$arm64_dependencies"
}

arm64_suites() {
  arm64_prepare || return
  suite "core as clang sees it for arm64, with libc++ 11" arm64_check_portable
  suite "libraries for arm64" arm64_libraries
  suite "unit tests for arm64 under qemu" arm64_unit_tests
  suite "OpenGL ES for arm64 under qemu" arm64_gles
}
