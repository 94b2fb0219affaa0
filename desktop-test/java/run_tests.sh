#!/usr/bin/env bash
# run_tests.sh BUILD SOURCE [MAVEN ARGUMENTS]: the tests of the Java API, with the JVM's checks of JNI on. Skips (77) where
# JDK 17, Maven or, the first time, Maven's repository is missing; under CI that is a failure.
set -euo pipefail
build="$(realpath "$1")"
source="$(realpath "$2")"
shift 2
name=java_test
project="$source/desktop-test/java"
out="$build/java"
library="$build/jni"
# shellcheck source=desktop-test/java/maven.sh
. "$project/maven.sh"

need_maven
[ -f "$library/libglide_jni.so" ] || skip "libglide_jni was not built: CMake found no jni.h"
fetch_with PoseTest

rm -rf "$out/sequences"
"$build/desktop-test/java/reference_run" walk "$out/sequences/walk" 30
desk="$source/../shared/data/desk_fisheye_400"
if [ -d "$desk" ]; then "$build/desktop-test/java/reference_run" tum "$desk" "$out/sequences/desk" 60; fi

log="$out/java_test.log"
maven --offline test "$@" | tee "$log"
if grep -q -e 'WARNING in native method' -e 'FATAL ERROR in native method' "$log"; then
  echo "java_test: -Xcheck:jni found the above"
  exit 1
fi
