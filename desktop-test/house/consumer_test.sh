#!/usr/bin/env bash
# consumer_test.sh BUILD SOURCE: installs the library into a new prefix, builds an application against it with
# find_package(glide), and runs it.
set -euo pipefail
build="$1"
source="$2"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cmake --install "$build" --prefix "$folder/prefix" >"$folder/log" || { cat "$folder/log"; exit 1; }
unset CMAKE_PREFIX_PATH
cmake -S "$source" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror"
cmake --build "$folder/build"
"$folder/build/consumer"
"$folder/build/readme_example"
# The library exports its public API and nothing of its parts (templates of the standard library aside).
library="$(find "$folder/prefix" -name libglide.so)"
if nm -DC --defined-only "$library" | grep ' T ' | grep -v ' T glide::\(Session::\|validate(\)'; then
  echo "libglide.so exports the above, which is not its public API"
  exit 1
fi
