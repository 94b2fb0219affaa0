#!/bin/bash
# setup_evo.sh VENV: evo (PyPI) in a virtual environment, for the test that compares our ATE with its.
# Exits with 77, which ctest counts as skipped, when PyPI cannot be reached.
set -u
venv="$1"
version=1.38.1
[ -x "$venv/bin/evo_ape" ] && { echo "evo is already in $venv"; exit 0; }
python3 -m venv "$venv" || { echo "python3 -m venv failed (apt-get install python3-venv)"; exit 1; }
log=$("$venv/bin/pip" install --quiet --disable-pip-version-check "evo==$version" 2>&1) && exit 0
echo "$log"
if grep -qiE "connection|timed out|temporary failure|proxy|from versions: none" <<<"$log"; then
  echo "SKIPPED: PyPI cannot be reached, so evo cannot be installed"
  exit 77
fi
exit 1
