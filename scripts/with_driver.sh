#!/usr/bin/env bash
# with_driver.sh DRIVER COMMAND...: runs the command on one of the drivers of docs/drivers.md.
set -euo pipefail
root="$(cd "$(dirname "$(readlink -f "${BASH_SOURCE[0]}")")/.." && pwd)"
# shellcheck source=scripts/steps.sh
. "$root/scripts/steps.sh"
# shellcheck source=scripts/drivers.sh
. "$root/scripts/drivers.sh"

usage() {
  cat <<TEXT
Usage: scripts/with_driver.sh DRIVER COMMAND...
Runs the command with OpenGL ES on DRIVER: ${all_drivers[*]}
What the driver needs is installed (apt) or downloaded into build/cache/drivers first. For example
  scripts/with_driver.sh angle-swiftshader ./glide replay euroc:FOLDER --backend gles
  scripts/with_driver.sh zink build/release/desktop-test/gpu/gpu_test
Status 77 when the driver is not to be had here; 1 when moreover GLIDE_REQUIRE_GL=1, as under CI.
TEXT
}

case "${1:-}" in -h | --help) usage && exit ;; esac
[ $# -ge 2 ] || { usage >&2 && exit 1; }
driver="$1"
shift
is_driver "$driver" || die "there is no driver '$driver'; there are ${all_drivers[*]}"
fetch_driver "$driver" || {
  say "the driver $driver is not to be had here"
  if [ "${GLIDE_REQUIRE_GL:-}" = 1 ]; then exit 1; fi
  exit 77
}
use_driver "$driver"
exec "$@"
