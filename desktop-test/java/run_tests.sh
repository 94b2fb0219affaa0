#!/usr/bin/env bash
# run_tests.sh BUILD SOURCE [MAVEN ARGUMENTS]: the tests of the Java API, with the JVM's checks of JNI on. Skips (77) where
# JDK 17, Maven or, the first time, Maven's repository is missing; under CI that is a failure.
set -euo pipefail
build="$1"
source="$2"
shift 2
out="$build/java"
repository="$source/build/cache/m2"
complete="$repository/java_test.complete" # the POM that the repository holds everything for

skip() {
  echo "java_test: skipped: $*"
  [ -z "${CI:-}" ] || { echo "java_test: under CI that is a failure" && exit 1; }
  exit 77
}

# The first JDK 17 of JAVA_HOME, the compiler on the path, and where Debian puts it.
find_jdk() {
  local home compiler
  compiler="$(command -v javac)" || compiler=""
  for home in "${JAVA_HOME:-}" "$(dirname "$(dirname "$(readlink -f "$compiler")")")" /usr/lib/jvm/java-17-openjdk-*; do
    if "$home/bin/javac" -version 2>&1 | grep -q '^javac 17\.'; then
      echo "$home"
      return
    fi
  done
  return 1
}
JAVA_HOME="$(find_jdk)" || skip "there is no JDK 17 (apt-get install openjdk-17-jdk-headless)"
export JAVA_HOME
command -v mvn >/dev/null || skip "there is no Maven (apt-get install maven)"
[ -f "$build/jni/libglide_jni.so" ] || skip "libglide_jni was not built: CMake found no jni.h"

maven() {
  mvn --batch-mode --no-transfer-progress -Dmaven.repo.local="$repository" -f "$source/desktop-test/java/pom.xml" \
    -Dout="$out" -Dlibrary="$build/jni" "$@"
}

# Everything that Maven fetches, once; offline from then on. A registry that does not answer is asked twice.
fetch() { maven test -Dtest=PoseTest >"$repository/java_test.log" 2>&1; }
if ! cmp -s "$complete" "$source/desktop-test/java/pom.xml"; then
  mkdir -p "$repository"
  fetch || fetch || {
    tail -n 30 "$repository/java_test.log"
    if grep -q -E 'Could not (transfer|resolve|find)|could not be resolved' "$repository/java_test.log"; then
      skip "Maven could not fetch what it needs"
    fi
    exit 1
  }
  cp "$source/desktop-test/java/pom.xml" "$complete"
fi

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
