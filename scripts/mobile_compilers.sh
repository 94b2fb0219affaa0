# ./glide bench mobile-compilers: every shader through Mesa's compilers for Mali and Adreno GPUs, without the hardware.
# Sourced after scripts/steps.sh; expects $root.
#
# Debian's arm64 package of Mesa holds both drivers. What is missing is a GPU: a shim from Mesa's sources answers in
# place of its kernel driver, so that shaders compile and nothing runs. The drivers are arm64 programs: qemu runs them.
# shellcheck shell=bash
: "${root:?}"

mobile="$root/build/cache/mobile"
mobile_libraries="$mobile/sysroot/usr/lib/aarch64-linux-gnu"
# What runs, and what the shims and our program are linked with.
mobile_packages=(libegl1 libgles2 libegl-mesa0 libgl1-mesa-dri libstdc++6 libdrm-dev zlib1g-dev libexpat1-dev)
mobile_shims=(src/panfrost/drm-shim/libpanfrost_noop_drm_shim.so src/freedreno/drm-shim/libfreedreno_noop_drm_shim.so)

# mobile_apt_files FOLDER SUITE: an apt of its own, for arm64 and for sources. The machine's package lists stay as they are.
mobile_apt_files() {
  local apt="$1" suite="$2" keys="signed-by=/usr/share/keyrings/debian-archive-keyring.gpg" type
  mkdir -p "$apt/state/lists/partial" "$apt/cache/archives/partial"
  : >"$apt/status"
  for type in deb deb-src; do echo "$type [$keys] http://deb.debian.org/debian $suite main"; done >"$apt/sources.list"
  cat >"$apt/apt.conf" <<TEXT
Dir::State "$apt/state";
Dir::State::status "$apt/status";
Dir::Cache "$apt/cache";
Dir::Etc::sourcelist "$apt/sources.list";
Dir::Etc::sourceparts "/dev/null";
APT::Architecture "arm64";
APT::Architectures "arm64";
APT::Install-Recommends "false";
APT::Sandbox::User "$(id -un)";
APT::Update::Error-Mode "any";
TEXT
}

mobile_apt_in() { apt-get --config-file "$1/apt.conf" "${@:2}"; }
mobile_apt() { mobile_apt_in "$mobile/apt" "$@"; }

mobile_download() {
  mobile_apt_files "$mobile/apt" bookworm && mobile_apt update &&
    mobile_apt install --download-only --yes "${mobile_packages[@]}" &&
    mkdir -p "$mobile/source" && (cd "$mobile/source" && mobile_apt source --download-only mesa)
}

# Into a new folder that then takes its name: what exists is complete.
mobile_unpack() {
  local package
  rm -rf "$mobile/sysroot.new" && mkdir "$mobile/sysroot.new" || return
  for package in "$mobile"/apt/cache/archives/*.deb; do dpkg -x "$package" "$mobile/sysroot.new" || return; done
  mv -T "$mobile/sysroot.new" "$mobile/sysroot"
}

mobile_cross_file() {
  cat <<TEXT
[binaries]
c = 'aarch64-linux-gnu-gcc'
cpp = 'aarch64-linux-gnu-g++'
ar = 'aarch64-linux-gnu-ar'
strip = 'aarch64-linux-gnu-strip'
pkgconfig = 'pkg-config'
[properties]
sys_root = '$mobile/sysroot'
pkg_config_libdir = '$mobile_libraries/pkgconfig:$mobile/sysroot/usr/share/pkgconfig'
[host_machine]
system = 'linux'
cpu_family = 'aarch64'
cpu = 'aarch64'
endian = 'little'
TEXT
}

mobile_make_shims() {
  local new="$mobile/shims.new" source="$mobile/source/mesa"
  rm -rf "$source" "$new" && mkdir "$new" && mobile_cross_file >"$new/cross.ini" || return
  dpkg-source --no-check -x "$mobile"/source/mesa_*.dsc "$source" || return
  # Debian's python3 has the mako that it needs, another one in PATH may not.
  PATH="/usr/bin:/bin:$PATH" meson setup "$new/build" "$source" --cross-file "$new/cross.ini" -Dbuildtype=release \
    -Dgallium-drivers=panfrost,freedreno -Dvulkan-drivers= -Dtools=drm-shim -Degl=disabled -Dgles1=disabled \
    -Dgles2=disabled -Dopengl=false -Dglx=disabled -Dplatforms= -Dgbm=disabled -Dllvm=disabled \
    -Dshared-glapi=disabled -Dlibunwind=disabled -Dzstd=disabled -Dvideo-codecs= &&
    ninja -C "$new/build" "${mobile_shims[@]}" || return
  (cd "$new/build" && mv "${mobile_shims[@]}" "$new") && rm -rf "$new/build" "$source" && mv -T "$new" "$mobile/shims"
}

mobile_log() { run_quietly "$mobile/$1.log" "${@:2}"; }

# The drivers and the shims; downloads and builds once.
mobile_prepare() {
  mkdir -p "$mobile"
  if [ ! -d "$mobile/sysroot" ] || { [ ! -d "$mobile/shims" ] && [ ! -d "$mobile/source" ]; }; then
    say "fetching Mesa for arm64 and its sources (110 MB)"
    mobile_log download "fetching Mesa from deb.debian.org (is this machine offline?)" mobile_download || return
    mobile_log unpack "unpacking Mesa" mobile_unpack || return
  fi
  if [ ! -d "$mobile/shims" ]; then
    say "building the shims (a minute)"
    mobile_log shims "building the shims" mobile_make_shims || return
  fi
}

mobile_embed() {
  cmake -DDIRECTORY="$1" -DFUNCTION="$2" -DOUTPUT="$mobile/program/$2.cpp" -P "$root/cmake/EmbedShaders.cmake"
}

# Only the headers of EGL and GLES: the C library's are the cross compiler's own.
mobile_make_program() {
  local out="$mobile/program" headers
  mkdir -p "$out/include" || return
  for headers in EGL GLES3 KHR; do ln -sfn "/usr/include/$headers" "$out/include/$headers" || return; done
  mobile_embed "$root/shaders" embeddedShaders && mobile_embed "$root/desktop-test/bench/mobile" yardsticks || return
  aarch64-linux-gnu-g++ -std=c++20 -O1 -Wall -Wextra -Werror -I"$out/include" -I"$root/core" -I"$root/core/include" \
    -I"$root/desktop-test" "$root/desktop-test/bench/mobile/compile_shaders.cpp" \
    "$root/desktop-test/support/shader_variants.cpp" "$root/core/gpu/shader_source.cpp" \
    "$out/embeddedShaders.cpp" "$out/yardsticks.cpp" -o "$out/compile_shaders" \
    "$mobile_libraries/libEGL.so.1" "$mobile_libraries/libGLESv2.so.2" -Wl,-rpath-link,"$mobile_libraries"
}

bench_mobile_compilers() {
  setup build mobile && mobile_prepare || return
  mobile_log program "building compile_shaders" mobile_make_program || return
  python3 -B "$root/desktop-test/bench/mobile/mobile_compilers.py" --cache "$mobile" "$@"
}
