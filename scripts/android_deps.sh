#!/usr/bin/env bash
# android_deps.sh TOOLCHAIN_FILE PREFIX [cmake arguments]: what the library links, as static libraries for another system.
set -euo pipefail
root="$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)"
# shellcheck source=scripts/steps.sh
. "$root/scripts/steps.sh"
# shellcheck source=scripts/mobile_compilers.sh
. "$root/scripts/mobile_compilers.sh"

usage() {
  cat <<'TEXT'
Usage: scripts/android_deps.sh TOOLCHAIN_FILE PREFIX [cmake arguments]
Builds Eigen and GLM (headers), Highway, OpenCV (core and imgproc) and Ceres (without glog, gflags, LAPACK and
SuiteSparse) as static libraries from Debian's source packages (130 MB, fetched once into build/cache/deps) and installs
them below PREFIX. What is already in PREFIX stays. For Android, once per ABI:
  scripts/android_deps.sh $ANDROID_NDK_HOME/build/cmake/android.toolchain.cmake build/cache/deps/arm64-v8a \
    -DANDROID_ABI=arm64-v8a -DANDROID_PLATFORM=android-26 -DANDROID_STL=c++_static
and then GLIDE_ANDROID_DEPS=$PWD/build/cache/deps/arm64-v8a cmake --preset android-arm64 (docs/android.md).
GLIDE_JOBS is the number of compilers that run at a time (default: all processors).
TEXT
}

deps="$root/build/cache/deps"
dependencies=(eigen3 glm highway opencv ceres-solver) # Ceres needs Eigen's

# fetch_source NAME: Debian's source package, unpacked with Debian's patches. What exists is complete.
fetch_source() {
  local name="$1"
  [ ! -d "$deps/$name" ] || return 0
  mkdir -p "$deps/source" "$mobile"
  mobile_apt_files "$mobile/apt" bookworm && mobile_apt update || return
  (cd "$deps/source" && mobile_apt source --download-only "$name") || return
  rm -rf "$deps/new" && mkdir "$deps/new" &&
    (cd "$deps/new" && dpkg-source --no-check --no-copy -x "$deps/source/$name"_*.dsc "$name") &&
    mv -T "$deps/new/$name" "$deps/$name"
}

# Of Ceres' code for blocks of fixed sizes only that for ours is generated (docs/algorithms/bundle-adjustment.md). It makes
# the library 0.16 MB larger; without it the adjustment of 24 keyframes took 0.22 s instead of 0.16 (x86-64).
ceres_blocks="(2, 3, 6)"
specialize_ceres() {
  local folder="$deps/ceres-solver/internal/ceres" script=generate_template_specializations.py
  python3 - "$folder/$script" "$ceres_blocks" <<'PYTHON' && (cd "$folder" && python3 -B "$script")
import pathlib, re, sys
path = pathlib.Path(sys.argv[1])
path.write_text(re.sub(r"SPECIALIZATIONS = \[.*?\]", f"SPECIALIZATIONS = [{sys.argv[2]}]", path.read_text(), flags=re.DOTALL))
PYTHON
}

# options_of NAME: one cmake argument a line.
options_of() {
  case "$1" in
    eigen3) printf '%s\n' -DEIGEN_BUILD_DOC=OFF -DEIGEN_BUILD_PKGCONFIG=OFF ;;
    glm) printf '%s\n' -DGLM_TEST_ENABLE=OFF ;;
    highway) printf '%s\n' -DHWY_FORCE_STATIC_LIBS=ON ;;
    opencv)
      printf '%s\n' -DBUILD_LIST=core,imgproc -DBUILD_{ZLIB,opencv_apps,PERF_TESTS,TESTS,EXAMPLES,DOCS,JAVA}=OFF \
        -DBUILD_ANDROID_{PROJECTS,EXAMPLES}=OFF -DWITH_{IPP,ITT,LAPACK,EIGEN,OPENCL,VA,PROTOBUF,ADE,CAROTENE,PTHREADS_PF}=OFF \
        -DWITH_{JPEG,PNG,TIFF,WEBP,OPENJPEG,JASPER,OPENEXR,GTK,FFMPEG,GSTREAMER,V4L,1394,QUIRC,IMGCODEC_HDR}=OFF \
        -DCV_TRACE=OFF -DOPENCV_GENERATE_PKGCONFIG=OFF -DOPENCV_ENABLE_NONFREE=OFF
      ;;
    ceres-solver) # -2: errors; it would say something at every adjustment
      printf '%s\n' -DMINIGLOG=ON -DMINIGLOG_MAX_LOG_LEVEL=-2 -DEIGENSPARSE=ON -DBUILD_{EXAMPLES,BENCHMARKS,DOCUMENTATION}=OFF \
        -D{GFLAGS,SUITESPARSE,CXSPARSE,ACCELERATESPARSE,LAPACK,CUDA,EXPORT_BUILD_DIR}=OFF
      ;;
  esac
}

# build_dependency NAME TOOLCHAIN_FILE PREFIX [cmake arguments]
build_dependency() {
  local name="$1" toolchain="$2" prefix="$3" folder options
  shift 3
  folder="$prefix/build/$name"
  mapfile -t options < <(options_of "$name")
  if [ "$name" = ceres-solver ]; then specialize_ceres || return; fi
  cmake -S "$deps/$name" -B "$folder" -G Ninja -DCMAKE_TOOLCHAIN_FILE="$toolchain" -DCMAKE_INSTALL_PREFIX="$prefix" \
    -DCMAKE_PREFIX_PATH="$prefix" -DCMAKE_FIND_ROOT_PATH="$prefix" -DCMAKE_BUILD_TYPE=Release -DBUILD_TESTING=OFF \
    -DBUILD_SHARED_LIBS=OFF -DCMAKE_POSITION_INDEPENDENT_CODE=ON -DCMAKE_CXX_STANDARD=17 \
    -DCMAKE_CXX_COMPILER_LAUNCHER=ccache -DCMAKE_C_COMPILER_LAUNCHER=ccache \
    -DCMAKE_CXX_FLAGS_RELEASE='-O2 -DNDEBUG -ffunction-sections -fdata-sections' "${options[@]}" "$@" &&
    ninja -C "$folder" -j "$(jobs)" install && rm -rf "$folder" && touch "$prefix/$name.installed"
}

case "${1:-}" in -h | --help) usage && exit ;; esac
[ $# -ge 2 ] || { usage >&2 && exit 1; }
[ -f "$1" ] || die "there is no toolchain file $1"
toolchain="$(readlink -f "$1")"
prefix="$(readlink -m "$2")"
shift 2
export CCACHE_DIR="${CCACHE_DIR:-$root/build/ccache}"
mkdir -p "$prefix"
for name in "${dependencies[@]}"; do
  [ ! -e "$prefix/$name.installed" ] || continue
  say "building $name for $(basename "$prefix")"
  run_quietly "$deps/fetch.log" "fetching the source package $name" fetch_source "$name"
  run_quietly "$prefix/$name.log" "building $name" build_dependency "$name" "$toolchain" "$prefix" "$@"
done
