# The OpenGL ES drivers that need no GPU: what each needs, and the environment that selects it (docs/drivers.md).
# Sourced after scripts/steps.sh; expects $root.
# shellcheck shell=bash
: "${root:?}"

all_drivers=(llvmpipe softpipe zink angle-swiftshader angle-lavapipe)

# ANGLE and SwiftShader, built for desktop Linux by Chromium, as this npm package carries them.
angle_package="@sparticuz/chromium@147.0.0"
angle_sha256=18fe5404ce845594cd7d592fc07f37a19514079ba4d9c27192ad8b908743f16b
angle_folder="$root/build/cache/drivers/angle-147.0.0"
lavapipe_icd="/usr/share/vulkan/icd.d/lvp_icd.$(uname -m).json"

is_driver() {
  local known
  for known in "${all_drivers[@]}"; do
    if [ "$1" = "$known" ]; then return 0; fi
  done
  return 1
}

unpack_brotli() { node -e 'process.stdin.pipe(require("zlib").createBrotliDecompress()).pipe(process.stdout)'; }

# unpack_angle TARBALL FOLDER: the names that programs linked with libEGL and libGLESv2 look for.
unpack_angle() {
  local tarball="$1" folder="$2"
  echo "$angle_sha256  $tarball" | sha256sum --check --quiet || return
  tar --extract --gzip --to-stdout --file "$tarball" package/bin/swiftshader.tar.br |
    unpack_brotli | tar --extract --no-same-owner --directory "$folder" || return
  ln -s libEGL.so "$folder/libEGL.so.1" && ln -s libGLESv2.so "$folder/libGLESv2.so.2"
}

# Into a new folder that then becomes the cache: what is there is whole.
download_angle() {
  local new status=0
  mkdir -p "$(dirname "$angle_folder")" || return
  new="$(mktemp -d "$angle_folder.XXXXXX")" || return
  mkdir "$new/package" "$new/angle"
  (cd "$new/package" && npm pack --silent --cache "$new/npm" "$angle_package") && unpack_angle "$new"/package/*.tgz "$new/angle" &&
    mv "$new/angle" "$angle_folder" || status=$?
  rm -rf "$new"
  return "$status"
}

fetch_angle() {
  if [ -d "$angle_folder" ]; then return 0; fi
  if [ "$(uname -m)" != x86_64 ]; then
    say "ANGLE comes for x86_64 only, this is $(uname -m)"
    return 1
  fi
  if ! command -v npm >/dev/null; then setup angle || return; fi
  say "fetching ANGLE and SwiftShader (npm package $angle_package, 68 MB)"
  run_quietly "$root/build/cache/drivers/fetch.log" "fetching $angle_package" download_angle
}

fetch_lavapipe() {
  setup lavapipe || return
  if [ ! -e "$lavapipe_icd" ]; then
    say "lavapipe is missing: no $lavapipe_icd"
    return 1
  fi
}

fetch_what_is_missing() {
  case "$1" in
    llvmpipe | softpipe) setup mesa ;;
    zink) setup mesa && fetch_lavapipe ;;
    angle-swiftshader) fetch_angle ;;
    angle-lavapipe) fetch_angle && fetch_lavapipe ;;
  esac
}

# fetch_driver DRIVER: installs or downloads what is missing; otherwise says what it could not get. One at a time.
fetch_driver() {
  mkdir -p "$root/build/cache/drivers" || return
  (flock 9 && fetch_what_is_missing "$1" 9>&-) 9>"$root/build/cache/drivers/lock"
}

use_mesa() {
  export EGL_PLATFORM=surfaceless LIBGL_ALWAYS_SOFTWARE=true GALLIUM_DRIVER="$1" GLIDE_EGL_PLATFORM=surfaceless
  export MESA_SHADER_CACHE_DIR="${MESA_SHADER_CACHE_DIR:-$root/build/cache/mesa_shaders}"
}

# use_angle ICD: ANGLE on the Vulkan driver that this file names.
use_angle() {
  export LD_LIBRARY_PATH="$angle_folder${LD_LIBRARY_PATH:+:$LD_LIBRARY_PATH}" VK_ICD_FILENAMES="$1"
}

# use_driver DRIVER: exports what makes programs use it. GLIDE_GL_RENDERER is a regular expression that the renderer's
# name must match: with another one the tests fail.
use_driver() {
  case "$1" in
    llvmpipe | softpipe) use_mesa "$1" && export GLIDE_GL_RENDERER="^$1" ;;
    zink)
      use_mesa llvmpipe
      # On a CPU zink 22.3 compiles the values of uniforms into compute shaders, and forgets it when they change.
      export ZINK_INLINE_UNIFORMS=0
      export MESA_LOADER_DRIVER_OVERRIDE=zink VK_ICD_FILENAMES="$lavapipe_icd" GLIDE_GL_RENDERER='^zink'
      ;;
    angle-swiftshader)
      use_angle "$angle_folder/vk_swiftshader_icd.json"
      export GLIDE_EGL_PLATFORM=angle-swiftshader GLIDE_GL_RENDERER='^ANGLE.*SwiftShader'
      ;;
    angle-lavapipe)
      use_angle "$lavapipe_icd"
      export GLIDE_EGL_PLATFORM=angle-vulkan GLIDE_GL_RENDERER='^ANGLE.*llvmpipe'
      ;;
  esac
}
