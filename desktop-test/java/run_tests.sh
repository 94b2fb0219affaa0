#!/usr/bin/env bash
# run_tests.sh BUILD SOURCE: the tests of the Java API, with the JVM's checks of JNI on. Skips (77) where JDK 17, Maven or,
# the first time, Maven's repository is missing; under CI that is a failure.
set -euo pipefail
build="$1"
source="$2"
out="$build/java"
repository="$source/build/cache/m2"
complete="$repository/java_test.complete" # the POM that the repository holds everything for

skip() {
  echo "java_test: skipped: $*"
  [ -z "${CI:-}" ] || { echo "java_test: under CI that is a failure" && exit 1; }
  exit 77
}

if [ -z "${JAVA_HOME:-}" ]; then
  compiler="$(command -v javac)" || skip "there is no JDK (apt-get install openjdk-17-jdk-headless)"
  JAVA_HOME="$(dirname "$(dirname "$(readlink -f "$compiler")")")"
fi
export JAVA_HOME
"$JAVA_HOME/bin/javac" -version 2>&1 | grep -q '^javac 17\.' || skip "JAVA_HOME=$JAVA_HOME is no JDK 17"
command -v mvn >/dev/null || skip "there is no Maven (apt-get install maven)"
[ -f "$build/jni/libglide_jni.so" ] || skip "libglide_jni was not built: CMake found no jni.h"

maven() {
  mvn --batch-mode --no-transfer-progress -Dmaven.repo.local="$repository" -f "$source/desktop-test/java/pom.xml" \
    -Dout="$out" -Dlibrary="$build/jni" "$@"
}

# Everything that Maven fetches, once; offline from then on.
if ! cmp -s "$complete" "$source/desktop-test/java/pom.xml"; then
  mkdir -p "$repository"
  maven test -Dtest=PoseTest >"$repository/java_test.log" 2>&1 || {
    tail -n 30 "$repository/java_test.log"
    skip "Maven could not fetch what it needs, or could not compile"
  }
  cp "$source/desktop-test/java/pom.xml" "$complete"
fi

rm -rf "$out/sequences"
"$build/desktop-test/java/reference_run" walk "$out/sequences/walk" 30
desk="$source/../shared/data/desk_fisheye_400"
if [ -d "$desk" ]; then "$build/desktop-test/java/reference_run" tum "$desk" "$out/sequences/desk" 60; fi

log="$out/java_test.log"
maven --offline test | tee "$log"
if grep -q -e 'WARNING in native method' -e 'FATAL ERROR in native method' "$log"; then
  echo "java_test: -Xcheck:jni found the above"
  exit 1
fi
