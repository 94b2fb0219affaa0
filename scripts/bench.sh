# What ./glide bench gpu and ./glide bench paper run. Sourced after scripts/steps.sh; expects $root.
# shellcheck shell=bash
: "${root:?}"

# bench_gpu [--driver D] OPTIONS...: options as glide-gpu-bench --help tells them.
bench_gpu() {
  local arguments=() run=() is_sweep=no
  while [ $# -gt 0 ]; do
    case "$1" in
      --driver)
        [ $# -ge 2 ] || die "--driver needs a name"
        run=("$root/scripts/with_driver.sh" "$2")
        shift
        ;;
      --driver=*) run=("$root/scripts/with_driver.sh" "${1#--driver=}") ;;
      --sweep) is_sweep=yes && arguments+=("$1") ;;
      *) arguments+=("$1") ;;
    esac
    shift
  done
  make_program glide-gpu-bench
  mkdir -p "$root/out/bench"
  # The plot of a sweep, unless another is asked for: the last --plot counts.
  if [ "$is_sweep" = yes ]; then arguments=(--plot "$root/out/bench/gpu_sweep.png" "${arguments[@]}"); fi
  "${run[@]}" "$(program glide-gpu-bench)" "${arguments[@]}"
}

# bench_paper ROOT... [options]
bench_paper() {
  if [ $# -gt 0 ]; then make_program glide-replay; fi
  python3 -B "$root/desktop-test/bench/paper/paper.py" "$@"
}
