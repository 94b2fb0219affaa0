# What the tests of Java share: tools that may be missing, and Maven with a repository of its own. Sourced; expects
#   name     of the test
#   project  folder of its pom.xml
#   source   the project's root; what Maven fetches goes to build/cache/m2
#   out      where it builds
#   library  folder of libglide_jni.so
# shellcheck shell=bash
: "${name:?}" "${project:?}" "${source:?}" "${out:?}" "${library:?}"
repository="$source/build/cache/m2"

# skip REASON...: ends the test; CTest knows 77. Under CI that is a failure.
skip() {
  echo "$name: skipped: $*"
  [ -z "${CI:-}" ] || { echo "$name: under CI that is a failure" && exit 1; }
  exit 77
}

# The first JDK 17 of JAVA_HOME, the compiler on the path, and where Debian puts it.
find_jdk() {
  local home compiler
  compiler="$(command -v javac)" || compiler=""
  for home in "${JAVA_HOME:-}" "$(dirname "$(dirname "$(readlink -f "$compiler")")")" /usr/lib/jvm/java-17-openjdk-*; do
    if "$home/bin/javac" -version 2>&1 | grep -q '^javac 17\.'; then
      echo "$home"
      return
    fi
  done
  return 1
}

# Sets JAVA_HOME, or skips.
need_maven() {
  JAVA_HOME="$(find_jdk)" || skip "there is no JDK 17 (apt-get install openjdk-17-jdk-headless)"
  export JAVA_HOME
  command -v mvn >/dev/null || skip "there is no Maven (apt-get install maven)"
}

maven() {
  mvn --batch-mode --no-transfer-progress -Dmaven.repo.local="$repository" -f "$project/pom.xml" -Dout="$out" \
    -Dlibrary="$library" "$@"
}

# fetch_with TEST: everything that Maven fetches for this POM, once, by a test that needs little; offline from then on. A
# registry that does not answer is asked twice.
fetch_with() {
  local complete="$repository/$name.complete" log="$repository/$name.log" begin=$SECONDS
  ! cmp -s "$complete" "$project/pom.xml" || return 0
  mkdir -p "$repository"
  if ! maven test -Dtest="$1" >"$log" 2>&1 && ! maven test -Dtest="$1" >"$log" 2>&1; then
    tail -n 30 "$log"
    ! grep -q -E 'Could not (transfer|resolve|find)|could not be resolved' "$log" || skip "Maven could not fetch what it needs"
    exit 1
  fi
  cp "$project/pom.xml" "$complete"
  echo "$name: fetched in $((SECONDS - begin)) s"
}
