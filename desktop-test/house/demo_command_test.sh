#!/usr/bin/env bash
# demo_command_test.sh ROOT: ./glide demo goes on without OpenGL ES, passes options and exit statuses on, and names what is there.
# The programs are stand-ins: nothing is built or rendered.
set -euo pipefail
cd "$1"
scripts="$PWD/scripts"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
fail() { echo "$*" && exit 1; }

# Stand-ins that write down how they were called. STATUS is what a replay ends with when it is to draw.
cat >"$work/synth" <<'TEXT'
#!/bin/sh
mkdir -p "$1" && echo "synth $*" >>"$CALLS"
TEXT
cat >"$work/replay" <<'TEXT'
#!/bin/sh
echo "replay $*" >>"$CALLS"
out="$3"
case "$*" in *--render*) [ "$STATUS" -eq 0 ] || [ "$STATUS" -eq 130 ] || exit "$STATUS"; touch "$5" ;; esac
mkdir -p "$out" && touch "$out/report.html" "$out/trajectory.tum"
case "$*" in *--render*) exit "$STATUS" ;; esac
TEXT
chmod +x "$work/synth" "$work/replay"
export CALLS="$work/calls" STATUS

# run_demo STATUS [options]: prints what it said; its exit status is that of the demo.
run_demo() {
  STATUS="$1"
  shift
  rm -rf "$work/out" "$CALLS"
  (
    root="$work"
    # shellcheck source=scripts/steps.sh
    . "$scripts/steps.sh"
    # shellcheck source=scripts/demo.sh
    . "$scripts/demo.sh"
    make_program() { :; }
    setup() { echo "setup $*" >>"$CALLS"; }
    program() { echo "$work/${1#glide-}"; }
    demo "$@" 2>&1
  )
}

said="$(run_demo 0 --stride 2)" || fail "the demo fails: $said"
for file in replay/report.html demo.mp4 replay/trajectory.tum; do
  case "$said" in *"$work/out/demo/$file"*) ;; *) fail "the demo does not name $file: $said" ;; esac
done
grep -q -e "--render $work/out/demo/demo.mp4 --stride 2" "$CALLS" || fail "options are not passed on: $(cat "$CALLS")"

said="$(run_demo 3)" || fail "the demo fails without OpenGL ES: $said"
case "$said" in *"no OpenGL ES"*) ;; *) fail "the demo does not say that there is no OpenGL ES: $said" ;; esac
case "$said" in *demo.mp4*) fail "the demo names a video that is not there: $said" ;; esac
[ "$(grep -c '^replay' "$CALLS")" -eq 2 ] || fail "the demo does not replay again without the video"

for status in 1 130; do
  ended=0
  said="$(run_demo "$status")" || ended=$?
  [ "$ended" -eq "$status" ] || fail "the demo ends with $ended where replay ended with $status"
done
case "$said" in *report.html*) ;; *) fail "an interrupted demo does not name what it wrote: $said" ;; esac

for option in "-o $work/x" "-o$work/x" "--output $work/x" "--output=$work/x"; do
  # shellcheck disable=SC2086 # an option and its value
  if said="$(run_demo 0 --stride 2 $option)"; then fail "the demo takes $option"; fi
  case "$said" in *"out/demo"*) ;; *) fail "the demo does not say where it writes: $said" ;; esac
  [ ! -e "$CALLS" ] || fail "the demo renders before it refuses $option: $(cat "$CALLS")"
done

run_demo 0 --viewer >/dev/null || fail "the demo fails with --viewer"
[ "$(head -1 "$CALLS")" = "setup viewer" ] || fail "the demo does not install what --viewer needs: $(cat "$CALLS")"
