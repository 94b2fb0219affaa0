# The steps that the commands of ./glide share. Sourced, never run; expects $root.
# shellcheck shell=bash
: "${root:?}"

say() { printf '%s\n' "glide: $*" >&2; }

die() {
  say "$*"
  exit 1
}

# run_quietly LOG WHAT COMMAND...: output into LOG; what matters of it on the terminal when the command fails.
run_quietly() {
  local log="$1" what="$2" status=0
  shift 2
  mkdir -p "$(dirname "$log")"
  "$@" >"$log" 2>&1 || status=$?
  if [ "$status" -ne 0 ]; then
    grep -E -A 12 'error:|CMake Error|FAILED:|^E: |undefined reference' "$log" | head -n 100 >&2 || tail -n 40 "$log" >&2
    say "$what failed (status $status); everything it said is in $log"
  fi
  return "$status"
}

as_root() {
  if [ "$(id -u)" -eq 0 ]; then
    "$@"
  elif command -v sudo >/dev/null; then
    sudo --preserve-env=DEBIAN_FRONTEND "$@"
  else
    die "must be root, or have sudo, to run: $*"
  fi
}

packages_of_groups() {
  local group
  for group in "$@"; do
    awk -v group="$group" '!/^#/ && $2 == group { print $1 }' "$root/scripts/debian-packages.txt"
  done | sort -u
}

is_installed() { [ "$(dpkg-query --show --showformat='${db:Status-Status}' "$1" 2>/dev/null)" = installed ]; }

# is_there PACKAGE: installed, or what it is for came from elsewhere: other packages of Node conflict with Debian's npm.
is_there() {
  case "$1" in
    npm) command -v npm >/dev/null || is_installed npm ;;
    nodejs) command -v node >/dev/null || is_installed nodejs ;;
    *) is_installed "$1" ;;
  esac
}

install_packages() {
  export DEBIAN_FRONTEND=noninteractive
  as_root apt-get update && as_root apt-get install --yes --no-install-recommends "$@"
}

# setup GROUP...: installs the Debian packages of these groups that are missing.
setup() {
  local package missing=()
  if [ -n "${GLIDE_NO_BUILD:-}" ]; then return 0; fi
  if ! command -v dpkg-query >/dev/null || ! command -v apt-get >/dev/null; then
    say "this is no Debian: please see to it that these are there: $(packages_of_groups "$@" | xargs)"
    return 0
  fi
  for package in $(packages_of_groups "$@"); do
    is_there "$package" || missing+=("$package")
  done
  [ "${#missing[@]}" -eq 0 ] && return 0
  say "installing ${missing[*]}"
  run_quietly "$root/build/apt.log" "apt-get" install_packages "${missing[@]}"
}

# How many compilers or tests at a time; GLIDE_JOBS=1 leaves room for other work.
jobs() { echo "${GLIDE_JOBS:-$(nproc 2>/dev/null || echo 2)}"; }

compile() {
  local preset="$1"
  shift
  cmake --preset "$preset" -S "$root" && cmake --build "$root/build/$preset" -j "$(jobs)" "$@"
}

# build PRESET [TARGET...]: builds what is stale. One at a time per build folder. With GLIDE_NO_BUILD=1, which is for tests
# of the commands themselves, nothing is installed nor built: what is there must do.
build() {
  local preset="$1" arguments=()
  if [ -n "${GLIDE_NO_BUILD:-}" ]; then return 0; fi
  shift
  [ $# -eq 0 ] || arguments=(--target "$@")
  export CCACHE_DIR="${CCACHE_DIR:-$root/build/ccache}" # all that we write stays in build/ and out/
  mkdir -p "$root/build/$preset"
  (
    flock 9
    run_quietly "$root/build/$preset/glide.log" "building $preset" in_root compile "$preset" "${arguments[@]}"
  ) 9>"$root/build/$preset/glide.lock"
}

in_root() { (cd "$root" && "$@"); }

program() {
  case "$1" in
    glide-replay) echo "$root/build/release/desktop-test/replay/glide-replay" ;;
    glide-synth) echo "$root/build/release/desktop-test/synthetic/glide-synth" ;;
    glide-growth) echo "$root/build/release/desktop-test/suites/glide-growth" ;;
    glide-gpu-bench) echo "$root/build/release/desktop-test/bench/gpu/glide-gpu-bench" ;;
    glide_bench) echo "$root/build/release/desktop-test/bench/glide_bench" ;;
  esac
}

# make_program NAME: set up and build what it takes to run it, saying so when that takes long.
make_program() {
  setup build || return
  [ -x "$(program "$1")" ] || say "building (this takes some minutes the first time)"
  build release "$@"
}
