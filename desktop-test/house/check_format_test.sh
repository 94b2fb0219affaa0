#!/usr/bin/env bash
# check_format_test.sh ROOT: the format check accepts what is right and refuses what is not.
set -euo pipefail
here="$(cd "$(dirname "$0")" && pwd)"
folder="$(mktemp -d)"
trap 'rm -rf "$folder"' EXIT
cp "$1/.clang-format" "$folder"
git -C "$folder" init --quiet
printf 'int main() { return 0; }\n' >"$folder/a.cpp"
git -C "$folder" add a.cpp
"$here/check_format.sh" "$folder" || { echo "refuses a well-formatted file"; exit 1; }
printf 'int  main( ) {return 0 ;}\n' >"$folder/a.cpp"
if "$here/check_format.sh" "$folder" 2>/dev/null; then echo "accepts a badly formatted file"; exit 1; fi
