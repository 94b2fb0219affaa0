#!/usr/bin/env bash
# abi_test.sh LIBRARY SOURCE: the C ABI is what it was: the functions that LIBRARY exports (symbols.txt), sizes and
# offsets of the structs (layout.c), and a header that a C99 and a C++ compiler take without a warning.
set -euo pipefail
library="$1"
source="$2"
here="$source/desktop-test/house/c_abi"
include="$source/core/include"
if ! diff <(nm -D --defined-only "$library" | awk '$3 ~ /^glide_/ { print $3 }' | sort) "$here/symbols.txt"; then
  echo "the functions above (<: exported, >: pinned in symbols.txt) differ: raise GLIDE_ABI_MINOR when some were added"
  exit 1
fi
declared="$(grep -o 'glide_[a-z_]*(' "$include/glide/glide.h" | tr -d '(' | sort -u)"
diff <(echo "$declared") "$here/symbols.txt" || { echo "glide.h declares other functions than symbols.txt names"; exit 1; }
echo '#include "glide/glide.h"' | ${CC:-cc} -std=c99 -Wall -Wextra -pedantic -Werror -I"$include" -x c -fsyntax-only -
echo '#include "glide/glide.h"' | ${CXX:-c++} -std=c++11 -Wall -Wextra -pedantic -Werror -I"$include" -x c++ -fsyntax-only -
${CC:-cc} -std=c11 -Wall -Wextra -Werror -I"$include" -fsyntax-only "$here/layout.c"
