#!/usr/bin/env bash
# check_format.sh ROOT: fails where clang-format would change a source that git knows.
set -euo pipefail
cd "$1"
command -v clang-format >/dev/null || { echo "clang-format is missing (./glide setup installs it)"; exit 1; }
git ls-files -z '*.h' '*.cpp' | xargs -0 -P "$(nproc)" -n 32 clang-format --dry-run -Werror --ferror-limit=1
