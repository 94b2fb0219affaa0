#!/usr/bin/env bash
# shell_test.sh ROOT: ./glide and the scripts are well-formed, name their commands, and fail honestly.
set -euo pipefail
cd "$1"
fail() { echo "$*"; exit 1; }

scripts=(glide .ci/run scripts/*.sh desktop-test/house/*.sh desktop-test/house/docs/*.sh desktop-test/java/*.sh
  desktop-test/android_java/*.sh)
for script in "${scripts[@]}"; do bash -n "$script"; done
if command -v shellcheck >/dev/null; then shellcheck -x "${scripts[@]}"; fi

for command in setup build aar test demo bench format tidy; do
  case "$(./glide "$command" --help)" in
    *"Usage: ./glide $command"*) ;;
    *) fail "./glide $command --help says nothing" ;;
  esac
  case "$(./glide --help)" in
    *"  $command "*) ;;
    *) fail "./glide --help does not name $command" ;;
  esac
done
status=0
./glide nonsense 2>/dev/null || status=$?
[ "$status" -eq 1 ] || fail "./glide nonsense ends with $status instead of 1"
for command in "./glide test --driver" scripts/with_driver.sh; do
  status=0
  $command nonsense true 2>/dev/null || status=$?
  [ "$status" -eq 1 ] || fail "$command nonsense ends with $status instead of 1"
done
case "$(scripts/with_driver.sh llvmpipe env)" in
  *GLIDE_GL_RENDERER=^llvmpipe*) ;;
  *) fail "scripts/with_driver.sh llvmpipe does not choose llvmpipe" ;;
esac
status=0
./glide >/dev/null 2>&1 || status=$?
[ "$status" -eq 1 ] || fail "./glide without a command ends with $status instead of 1"
