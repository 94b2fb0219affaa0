# What ./glide test runs. Sourced by it; expects scripts/steps.sh and scripts/drivers.sh.
# shellcheck shell=bash
: "${root:?}" "${all_drivers[*]:?}"

# Unit tests of what handles memory by hand or reads foreign files.
asan_targets=(geometry_test image_test photometric_test feature_test map_test optimize_test readers_test calibration_test
  mapping_test loop_test map_mutations vit_test)
# What runs on, or hands data to, more than one thread.
tsan_targets=(base_test session_test vit_test capi_test)

# ctest_in PRESET ARGUMENTS...
ctest_in() {
  local preset="$1"
  shift
  ctest --test-dir "$root/build/$preset" -j "$(jobs)" --output-on-failure "$@"
}

# sanitized PRESET TARGET...: builds these test programs under a sanitizer and runs them.
sanitized() {
  local preset="$1" expression
  shift
  build "$preset" "$@" || return
  expression="^($(
    IFS='|'
    echo "$*"
  ))$"
  ctest_in "$preset" -R "$expression"
}

# What runs inline has no second thread: maps in files, most of the C ABI. BusySessionMap and CSceneBeingMapped have two.
tsan_not='SessionMap.*:FrameMap.*:CMap.*:CScene.*:CSceneOfPoints.*:CSession.*:*BackEndLoop*Inline'
tsan_units() { GTEST_FILTER="-$tsan_not" sanitized tsan "${tsan_targets[@]}"; }

# suite NAME COMMAND...: runs it, says how it went, and remembers the failure.
failed_suites=()
suite() {
  local name="$1" begin=$SECONDS
  shift
  say "== $name"
  if "$@"; then
    say "== $name: passed ($((SECONDS - begin)) s)"
  else
    failed_suites+=("$name")
    say "== $name: FAILED ($((SECONDS - begin)) s)"
  fi
}

report_failed_suites() {
  [ "${#failed_suites[@]}" -eq 0 ] || die "failed: $(printf '%s; ' "${failed_suites[@]}")"
}

# A short run of the fuzzer, the same one every time. map_mutations, among all tests, is what is left without libFuzzer.
fuzz_suite() {
  local probe='extern "C" int LLVMFuzzerTestOneInput(const unsigned char*, unsigned long) { return 0; }'
  if ! clang++ -fsanitize=fuzzer -x c++ - -o /dev/null <<<"$probe" 2>/dev/null; then
    say "this clang has no libFuzzer: skipped"
    return 0
  fi
  sanitized fuzz map_fuzz
}

# Of CI's drivers only this one is no Debian package; fetched before its tests need it, which run two at a time.
fetch_angle_for_tests() { fetch_driver angle-swiftshader || say "no ANGLE: its tests are skipped, or fail under CI"; }

release_suite() { build release && ctest_in release "$@"; }

# A whole threaded replay under ThreadSanitizer: tracking, mapping, loss, relocalisation, orderly end.
tsan_replay() {
  local folder="$root/build/tsan/replay"
  build release glide-synth && build tsan glide-replay || return
  "$root/build/release/desktop-test/synthetic/glide-synth" "$folder/sequence" --overwrite --quiet --scene room \
    --frames 200 --size 320x240 --kidnap 110:120 || return
  TSAN_OPTIONS="suppressions=$root/scripts/tsan-suppressions.txt" \
    "$root/build/tsan/desktop-test/replay/glide-replay" "$folder/sequence" --backend cpu --progress none \
    --output "$folder/out" --require-tracked 0.9
}

# driver_suite DRIVER [ctest arguments]: what runs on OpenGL ES, on this driver.
driver_suite() {
  local driver="$1"
  shift
  is_driver "$driver" || die "there is no driver '$driver'; there are ${all_drivers[*]}"
  fetch_driver "$driver" || say "the driver $driver is not to be had here: its tests are skipped, or fail under CI"
  build release && ctest_in release -C drivers -L "^driver-$driver\$" "$@"
}

run_test_suites() {
  local quick=no
  if [ "${1:-}" = --quick ]; then
    quick=yes
    shift
  fi
  # Without a GL the GPU tests skip on a developer's machine; in CI that is a failure.
  if [ -n "${CI:-}" ]; then export GLIDE_REQUIRE_GL=1; fi
  if [ "${1:-}" = --driver ]; then
    [ $# -ge 2 ] || die "--driver needs one of ${all_drivers[*]}"
    driver_suite "${@:2}"
    return
  fi
  if [ "${1:-}" = --arch ]; then
    [ "${2:-}" = arm64 ] || die "--arch knows arm64 only"
    arm64_suites || return
    report_failed_suites
    return
  fi
  if [ "$quick" = no ] && [ $# -eq 0 ]; then
    suite "address and undefined behaviour sanitizers" sanitized asan "${asan_targets[@]}"
    suite "thread sanitizer" tsan_units
    suite "thread sanitizer on a whole replay" tsan_replay
    suite "fuzzer" fuzz_suite
    suite "library with clang" build clang glide
    fetch_angle_for_tests
  fi
  suite "all tests" release_suite "$@"
  report_failed_suites
}
