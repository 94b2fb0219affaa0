#!/usr/bin/env bash
# report_build_test.sh ROOT: a page of report.html that cannot be built is tried again after an hour, not by every build; what
# did not change is not compiled again. Node is a stand-in.
set -euo pipefail
root="$1"
work="$(mktemp -d)"
trap 'rm -rf "$work"' EXIT
fail() { echo "$*" && cat "$work/log" && exit 1; }

mkdir "$work/desktop-test"
ln -s "$root/cmake" "$work/cmake"
ln -s "$root/desktop-test/report" "$work/desktop-test/report"
cat >"$work/CMakeLists.txt" <<TEXT
cmake_minimum_required(VERSION 3.22)
project(page CXX)
set(CMAKE_CXX_STANDARD 20)
include(cmake/GlideReport.cmake)
add_library(page STATIC)
target_include_directories(page PRIVATE $root/desktop-test)
glide_embed_report(page)
TEXT
cat >"$work/node" <<TEXT
#!/bin/sh
echo called >>$work/calls
[ -e $work/online ] && echo the page >"\$3"
TEXT
chmod +x "$work/node"

build() {
  { cmake -G Ninja -S "$work" -B "$work/build" -DGLIDE_NODE="$work/node" -DGLIDE_NPM=npm &&
    cmake --build "$work/build"; } >"$work/log" 2>&1 || fail "it does not build"
}
# expect CALLS: so often node was called.
expect() { [ "$(wc -l <"$work/calls")" -eq "$1" ] || fail "node was called $(wc -l <"$work/calls") times, not $1"; }
library_time() { stat -c %Y.%y "$work/build/libpage.a"; }

build
compiled="$(library_time)"
build
expect 1
touch -d "2 hours ago" "$work/build/page_report.cpp.failed"
build
expect 2
[ "$(library_time)" = "$compiled" ] || fail "the same page was compiled again"
rm "$work/build/page_report.cpp.built"
touch "$work/online"
build
expect 3
grep -q "the page" "$work/build/page_report.cpp" || fail "the page is not in the source"
[ "$(library_time)" != "$compiled" ] || fail "the new page was not compiled"
[ ! -e "$work/build/page_report.cpp.failed" ] || fail "what was built counts as failed"
build
expect 3
