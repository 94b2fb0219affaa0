#!/usr/bin/env bash
# android_java_test.sh BUILD SOURCE: compiles the Java of android/ that needs Android's platform, the sample too, and tests
# it under Robolectric. Skips (77) where Maven or, the first time, its repository (200 MB) is missing; under CI that is a
# failure. GLIDE_SKIP_ANDROID=1 skips in any case.
set -euo pipefail
build="$1"
source="$2"
here="$source/desktop-test/android_java"
repository="$source/build/cache/m2"
complete="$repository/android_java_test.complete" # the POM that the repository holds everything for

skip() {
  echo "android_java_test: skipped: $*"
  [ -z "${CI:-}" ] || { echo "android_java_test: under CI that is a failure" && exit 1; }
  exit 77
}

maven() {
  mvn --batch-mode --no-transfer-progress -Dmaven.repo.local="$repository" -f "$here/pom.xml" \
    -Dout="$build/android_java" -Dlibrary="$build/jni" "$@"
}

# Everything that Maven fetches, by one test that needs no Robolectric.
fetch() {
  local log="$repository/android_java_test.log" begin=$SECONDS
  mkdir -p "$repository"
  if ! maven test -Dtest=FrameTimeTest >"$log" 2>&1; then
    tail -n 30 "$log"
    ! grep -q -e 'COMPILATION ERROR' -e 'There are test failures' "$log" || exit 1
    skip "Maven could not fetch what it needs"
  fi
  cp "$here/pom.xml" "$complete"
  echo "android_java_test: fetched in $((SECONDS - begin)) s"
}

if [ "${GLIDE_SKIP_ANDROID:-}" = 1 ]; then
  echo "android_java_test: skipped: GLIDE_SKIP_ANDROID=1"
  exit 77
fi
for tool in mvn javac; do
  command -v "$tool" >/dev/null || skip "there is no $tool (apt-get install openjdk-17-jdk-headless maven)"
done
cmp -s "$complete" "$here/pom.xml" || fetch
maven --offline test
