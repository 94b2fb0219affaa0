# ./glide demo: from nothing to a report and a video. Sourced by ./glide.
# shellcheck shell=bash
: "${root:?}"

readonly no_gl=3 # what glide-replay ends with when there is no OpenGL ES (docs/replay.md)

# render_living_room DIR: a walk once around a room and on over its beginning, in colour, exposed by metering.
render_living_room() {
  "$(program glide-synth)" "$1" --scene living-room --color --motion orbit --speed 1.6 --frames 400 \
    --noise 1.5 --metering 0.5 --overwrite >&2
}

# demo_replay OUT [replay options]: with a video in OUT/demo.mp4, or without one where there is no OpenGL ES.
demo_replay() {
  local out="$1" status=0 option
  local replay=("$(program glide-replay)" "tum:$out/room" --output "$out/replay")
  shift
  for option in "$@"; do
    case "$option" in
      --render | --render=*)
        "${replay[@]}" "$@"
        return
        ;;
    esac
  done
  "${replay[@]}" --render "$out/demo.mp4" "$@" || status=$?
  [ "$status" -eq "$no_gl" ] || return "$status"
  say "no OpenGL ES to draw with: once more without the video"
  "${replay[@]}" "$@"
}

# name_if_there WHAT FILE [NOTE]
name_if_there() {
  [ ! -f "$2" ] || say "$(printf '%-11s %s%s' "$1" "$2" "${3:+ ($3)}")"
}

# setup_viewer [replay options]: what --viewer needs, when it is among them.
setup_viewer() {
  case " $* " in *" --viewer "*) setup viewer ;; esac
}

# refuse_output [replay options]: the demo has its own places.
refuse_output() {
  local option
  for option in "$@"; do
    case "$option" in
      -o* | --output | --output=*) die "$option: the demo writes into out/demo" ;;
    esac
  done
}

demo() {
  local out="$root/out/demo" status=0
  refuse_output "$@"
  setup_viewer "$@"
  make_program glide-replay glide-synth
  mkdir -p "$out"
  rm -rf "$out/room" "$out/replay" "$out/demo.mp4"
  say "rendering 400 images of a living room"
  render_living_room "$out/room"
  say "tracking them, and drawing what the camera saw and the map"
  demo_replay "$out" "$@" || status=$?
  name_if_there report "$out/replay/report.html" "open it in a browser"
  name_if_there video "$out/demo.mp4"
  name_if_there trajectory "$out/replay/trajectory.tum" "the truth is groundtruth.tum beside it"
  return "$status"
}
