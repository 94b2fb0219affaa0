#!/usr/bin/env bash
# run.sh SAMPLES_PROGRAM BUILD_FOLDER SOURCE_FOLDER: the report's tests in headless Chromium. Ends with 77, a skip, where node,
# npm or Chromium are missing; under CI with 1.
set -euo pipefail
samples_program="$1" build="$2" source="$3"
cannot() {
  echo "report_test: $*" >&2
  [ -z "${CI:-}" ] || exit 1
  exit 77
}

command -v node >/dev/null || cannot "SKIPPED, node is missing"
command -v chromium >/dev/null || command -v google-chrome >/dev/null || cannot "SKIPPED, chromium is missing"
export GLIDE_REPORT_SAMPLES="$build/report-samples" GLIDE_GOLDENS="$source/desktop-test/golden" GLIDE_DIFFS="$build/golden-diffs"
"$samples_program" "$GLIDE_REPORT_SAMPLES" || cannot "SKIPPED, the page of report.html was not built"
# The same letters on every machine; and what Chromium leaves behind stays in the build folder.
export FONTCONFIG_FILE="$source/desktop-test/report/test/fonts.conf" TMPDIR="$build/tmp"
mkdir -p "$TMPDIR"
exec node --test "$source/desktop-test/report/test/report_test.mjs"
