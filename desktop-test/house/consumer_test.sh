#!/usr/bin/env bash
# consumer_test.sh BUILD SOURCE WRITE_WALK: installs the library into a new prefix, builds applications in C and C++
# against it with find_package(glide), and runs them; the C one on images that WRITE_WALK makes. The documents' C and C++ is
# compiled against the installed headers.
set -euo pipefail
build="$1"
source="$2"
write_walk="$3"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cmake --install "$build" --prefix "$folder/prefix" >"$folder/log" || { cat "$folder/log"; exit 1; }
unset CMAKE_PREFIX_PATH
cmake -S "$source" -B "$folder/build" -G Ninja -DCMAKE_PREFIX_PATH="$folder/prefix" -DCMAKE_CXX_FLAGS="-Wall -Wextra -Werror" \
  -DCMAKE_C_FLAGS="-std=c99 -Wall -Wextra -pedantic -Werror"
cmake --build "$folder/build"
"$folder/build/consumer"
"$folder/build/readme_example"
root="$source/../../.."
python3 -B "$root/desktop-test/house/docs/compile_code.py" "$root" "$folder/prefix/include"
read -r -a camera <<<"$("$write_walk" "$folder/images" 30)"
"$folder/build/track_folder" "${camera[@]}" "$folder"/images/*.pgm | tail -n 1 | grep -q '0029.pgm'
# The library exports its public API and nothing else.
library="$(find "$folder/prefix" -name libglide.so)"
if nm -DC --defined-only "$library" | grep -v -e ' T glide_' -e ' T glide::\(\(Session\|MapRenderer\|CameraRenderer\|RenderTarget\)::[^I]\|validate(\|setField(\|applySetting(\)' \
  -e ' A '; then
  echo "libglide.so exports the above, which is not its public API"
  exit 1
fi
