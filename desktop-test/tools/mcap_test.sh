#!/bin/bash
# mcap_test.sh VENV: runs to_mcap_test.py with the mcap package of requirements.txt, installed into a virtual environment.
# Exits with 77, which ctest counts as skipped, when PyPI cannot be reached.
set -u
venv="$1"
here=$(cd "$(dirname "$0")" && pwd)
package=$(grep '^mcap==' "$here/requirements.txt") || { echo "requirements.txt does not name mcap"; exit 1; }
if [ "$("$venv/bin/pip" freeze 2>/dev/null | grep '^mcap==')" != "$package" ]; then
  python3 -m venv "$venv" || { echo "python3 -m venv failed (apt-get install python3-venv)"; exit 1; }
  if ! log=$("$venv/bin/pip" install --quiet --disable-pip-version-check "$package" 2>&1); then
    echo "$log"
    grep -qiE "connection|timed out|temporary failure|proxy|from versions: none" <<<"$log" || exit 1
    echo "SKIPPED: PyPI cannot be reached, so $package cannot be installed"
    exit 77
  fi
fi
exec "$venv/bin/python" -B "$here/to_mcap_test.py"
