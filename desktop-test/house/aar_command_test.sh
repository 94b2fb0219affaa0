#!/usr/bin/env bash
# aar_command_test.sh ROOT WORK: ./glide aar packs what is built, under the ABI for tests, and what comes out is looked at
# with tools that are not ours. Nothing is built. Exit status 77 (skipped) where libglide_jni is not built.
set -euo pipefail
root="$1"
work="$2"
fail() { echo "$*" && exit 1; }

if [ ! -e "$root/build/release/jni/libglide_jni.so" ]; then
  echo "skipped: there is no libglide_jni.so, for want of a JDK"
  exit 77
fi
unset ANDROID_NDK_HOME
rm -rf "$work"
GLIDE_NO_BUILD=1 "$root/glide" aar --output "$work"
cd "$work"
abi=test-desktop
prefab=prefab/modules/glide

names="$(unzip -l glide-slam.aar | awk 'NR > 3 && NF == 4 { print $4 }' | sort)"
wanted="$(
  LC_ALL=C sort <<TEXT
AndroidManifest.xml
META-INF/com/android/build/gradle/aar-metadata.properties
R.txt
classes.jar
jni/$abi/libglide_jni.so
prefab/prefab.json
$prefab/include/glide/glide.h
$prefab/include/glide/glide_types.h
$prefab/libs/android.$abi/abi.json
$prefab/libs/android.$abi/libglide_jni.so
$prefab/module.json
proguard.txt
TEXT
)"
diff <(LC_ALL=C sort <<<"$names") - <<<"$wanted" || fail "the archive has other entries (<) than it should (>)"

unzip -q glide-slam.aar -d unpacked
library="unpacked/jni/$abi/libglide_jni.so"
exported="$(nm -D --defined-only "$library" | awk '{ print $3 }' | LC_ALL=C sort)"
pinned="$(LC_ALL=C sort - "$root/desktop-test/house/c_abi/symbols.txt" <<<JNI_OnLoad)"
diff <(echo "$exported") - <<<"$pinned" || fail "$library exports others (<) than JNI_OnLoad and the C ABI (>)"
alignments="$(readelf -lW "$library" | awk '$1 == "LOAD" { print $NF }' | sort -u)"
[ "$alignments" = 0x4000 ] || fail "segments of $library are aligned to $alignments, not to 16 KiB"
# grep -q would leave before the other has written all, which then counts as a failure.
if readelf -SW "$library" | grep ' \.symtab ' >/dev/null; then fail "$library is not stripped"; fi
unzip -l unpacked/classes.jar | grep ' io/github/glideslam/Session.class$' >/dev/null || fail "classes.jar has no Session"
cmp "unpacked/$prefab/include/glide/glide.h" "$root/core/include/glide/glide.h"

# Whatever the machine has fetched for it must have been used.
if compgen -G "$root/build/cache/r8-*.jar" >/dev/null; then
  [ -s java/dex/classes.dex ] || fail "r8 is there and made no classes.dex"
fi
if [ -n "$(find "$root/build/cache/m2" -name 'android-all-*.jar' -print -quit 2>/dev/null)" ]; then
  unzip -l unpacked/classes.jar | grep ' io/github/glideslam/android/Camera2Source.class$' >/dev/null ||
    fail "android-all is there and classes.jar has no Camera2Source"
fi
