#!/usr/bin/env bash
# android_java_test.sh BUILD SOURCE: compiles the Java of android/ that needs Android's platform, the sample too, and the
# Kotlin of the documents, and tests it under Robolectric. Skips (77) where JDK 17, Maven or, the first time, its repository
# (270 MB) is missing; under CI that is a failure. GLIDE_SKIP_ANDROID=1 skips in any case.
set -euo pipefail
build="$(realpath "$1")"
source="$(realpath "$2")"
name=android_java_test
project="$source/desktop-test/android_java"
out="$build/android_java"
library="$build/jni"
# shellcheck source=desktop-test/java/maven.sh
. "$source/desktop-test/java/maven.sh"

if [ "${GLIDE_SKIP_ANDROID:-}" = 1 ]; then
  echo "$name: skipped: GLIDE_SKIP_ANDROID=1"
  exit 77
fi
need_maven
python3 -B "$project/kotlin_of_docs.py" "$source" "$out/kotlin"
fetch_with FrameTimeTest
maven --offline test
