# ./glide aar: the Android archive without Gradle. Sourced; expects scripts/steps.sh.
# shellcheck shell=bash
: "${root:?}"

aar_min_sdk=26
# The dexer that Android's build uses; what it refuses, Android refuses.
r8_version=9.5.28
r8_url="https://repo1.maven.org/maven2/com/android/tools/r8/$r8_version/r8-$r8_version.jar"
r8_sha256=38a9ffaaebbd17d1514e3ecbff5a85b989bb13c551b9e224c7409514eea84ff5

aar_version() { sed -n 's/^project(glide VERSION \([0-9.]*\).*/\1/p' "$root/CMakeLists.txt"; }

# aar_classes OUT: classes.jar of the core package, and of the package for Android where its platform jar is at hand.
aar_classes() {
  local out="$1" sources="$root/android/glide/src/main/java/io/github/glideslam" jar
  rm -rf "$out" && mkdir -p "$out/classes"
  javac --release 8 -Xlint:-options -d "$out/classes" "$sources"/*.java || return
  jar="$(find "$root/build/cache/m2" -name 'android-all-*.jar' -print -quit 2>/dev/null)"
  if [ -n "$jar" ] && [ -d "$sources/android" ]; then
    javac --release 8 -Xlint:-options -cp "$out/classes:$jar" -d "$out/classes" "$sources"/android/*.java || return
  elif [ -n "${ANDROID_NDK_HOME:-}" ]; then
    die "no android-all jar in build/cache/m2 to compile io.github.glideslam.android against (./glide test fetches it)"
  else
    say "without io.github.glideslam.android: no android-all jar in build/cache/m2 (./glide test fetches it)"
  fi
  jar --create --file "$out/classes.jar" --date 1980-01-01T00:00:02Z -C "$out/classes" .
}

# 28 of NDK 28.2.13676358; 0 without an NDK.
aar_ndk_major() {
  local major=""
  [ -z "${ANDROID_NDK_HOME:-}" ] ||
    major="$(sed -n 's/^Pkg.Revision *= *\([0-9]*\)\..*/\1/p' "$ANDROID_NDK_HOME/source.properties")"
  echo "${major:-0}"
}

# aar_libraries OUT: ABI=FILE for each native library, stripped.
aar_libraries() {
  local out="$1" preset abi strip
  if [ -z "${ANDROID_NDK_HOME:-}" ]; then
    say "ANDROID_NDK_HOME is not set: the desktop's library takes the place of Android's, as ABI test-desktop"
    build release glide_jni || return
    [ -e "$root/build/release/jni/libglide_jni.so" ] || die "there is no libglide_jni.so: it takes a JDK (javac) to build it"
    strip --strip-unneeded -o "$out/test-desktop.so" "$root/build/release/jni/libglide_jni.so" || return
    echo "test-desktop=$out/test-desktop.so"
    return
  fi
  for preset in android-arm64 android-x86_64; do
    case "$preset" in *arm64) abi=arm64-v8a ;; *) abi=x86_64 ;; esac
    build "$preset" glide || return
    strip="$(find "$ANDROID_NDK_HOME/toolchains" -name llvm-strip -print -quit)"
    "$strip" --strip-unneeded -o "$out/$abi.so" "$root/build/$preset/jni/libglide_jni.so" || return
    echo "$abi=$out/$abi.so"
  done
}

# The dexer, fetched once.
aar_dexer() {
  local jar="$root/build/cache/r8-$r8_version.jar"
  if [ ! -s "$jar" ]; then
    mkdir -p "$(dirname "$jar")"
    curl --fail --silent --show-error --location --output "$jar.new" "$r8_url" || return
    sha256sum --check --status <<<"$r8_sha256  $jar.new" || { say "$r8_url is not the r8 that was pinned" && return 1; }
    mv "$jar.new" "$jar"
  fi
  echo "$jar"
}

aar_dex() {
  local out="$1" jar platform java
  java="$(readlink -f "$(command -v javac)")" # its folder has java.lang, which android-all leaves out
  jar="$(aar_dexer)" || { say "no r8 to be had from $r8_url: the classes were not dexed" && return 0; }
  platform="$(find "$root/build/cache/m2" -name 'android-all-*.jar' -print -quit 2>/dev/null)"
  rm -rf "$out/dex" && mkdir -p "$out/dex"
  java -cp "$jar" com.android.tools.r8.D8 --min-api "$aar_min_sdk" ${platform:+--lib "$platform"} \
    --lib "${java%/bin/javac}" --output "$out/dex" "$out/classes.jar" || return
  [ -s "$out/dex/classes.dex" ] || die "r8 made no classes.dex"
  say "dexed: $(stat --format %s "$out/dex/classes.dex") bytes"
}

# make_aar OUT: the archive, and what it is made of, in this folder.
make_aar() {
  local out="$1" libraries=() library
  setup build test || return
  mkdir -p "$out" && rm -rf "$out/java" "$out/glide-slam.aar" || return
  aar_classes "$out/java" || return
  aar_libraries "$out" >"$out/libraries" || return
  while read -r library; do libraries+=(--library "$library"); done <"$out/libraries"
  [ "${#libraries[@]}" -gt 0 ] || die "there is no native library"
  python3 "$root/scripts/aar/package.py" --classes "$out/java/classes.jar" "${libraries[@]}" \
    --headers "$root/core/include" --android-project "$root/android/glide" --version "$(aar_version)" \
    --min-sdk "$aar_min_sdk" --ndk-major "$(aar_ndk_major)" --output "$out/glide-slam.aar" || return
  aar_dex "$out/java" || return
  python3 "$root/scripts/aar/check.py" "$out/glide-slam.aar"
}
