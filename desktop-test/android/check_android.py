#!/usr/bin/env python3
"""Fails where the Gradle project contradicts itself or the rest.

usage: check_android.py ROOT WORK
"""
import pathlib
import re
import subprocess
import sys
import xml.etree.ElementTree

NAME = "{http://schemas.android.com/apk/res/android}name"


def only(pattern, text, what):
    """The one value that a pattern has in a text."""
    found = set(re.findall(pattern, text))
    if len(found) != 1:
        raise ValueError(f"{what}: expected one value, found {sorted(found)}")
    return found.pop()


def version_faults(root):
    """One version, one minimal and one compile SDK everywhere; no version left open."""
    library = (root / "android/glide/build.gradle.kts").read_text()
    sample = (root / "android/sample/build.gradle.kts").read_text()
    cmake = only(r"project\(glide VERSION ([0-9.]+)", (root / "CMakeLists.txt").read_text(), "CMakeLists.txt")
    for what, pattern, text in (("the library's version", r'\nversion = "([^"]+)"', library),
                                ("the sample's version", r'versionName = "([^"]+)"', sample)):
        if only(pattern, text, what) != cmake:
            yield f"{what} is not CMake's, {cmake}"
    only(r"compileSdk = (\d+)", library + sample, "compileSdk")
    minimal = only(r"minSdk = (\d+)", library + sample, "minSdk")
    if only(r"aar_min_sdk=(\d+)", (root / "scripts/aar.sh").read_text(), "scripts/aar.sh") != minimal:
        yield f"scripts/aar.sh has another minimal SDK than Gradle's {minimal}"
    only(r'id\("com\.android\.\w+"\) version "(\d+\.\d+\.\d+)"', (root / "android/build.gradle.kts").read_text(), "AGP")
    wrapper = (root / "android/gradle/wrapper/gradle-wrapper.properties").read_text()
    only(r"gradle-(\d+\.\d+\.\d+)-bin\.zip", wrapper, "Gradle")


def activity_faults(root):
    """What the manifest names must exist."""
    sample = root / "android/sample"
    package = only(r'namespace = "([^"]+)"', (sample / "build.gradle.kts").read_text(), "namespace")
    for activity in xml.etree.ElementTree.parse(sample / "src/main/AndroidManifest.xml").iter("activity"):
        source = sample / "src/main/java" / package.replace(".", "/") / f"{activity.get(NAME).lstrip('.')}.java"
        if not source.exists():
            yield f"the manifest names {activity.get(NAME)}, and there is no {source.relative_to(root)}"


def prefab_faults(root, work):
    """Gradle names the prefab module after a CMake target, ./glide aar by its own; the library in it is the same."""
    gradle = (root / "android/glide/build.gradle.kts").read_text()
    package = (root / "scripts/aar/package.py").read_text()
    module = only(r'\nMODULE = "(\w+)"', package, "package.py's MODULE")
    library = only(r'\nLIBRARY = "(\w+)\.so"', package, "package.py's LIBRARY")
    if only(r'prefab \{[^}]*create\("(\w+)"\)', gradle, "Gradle's prefab module") != module:
        yield f"Gradle's prefab module has another name than that of ./glide aar, {module}"
    if only(r'libraryName = "(\w+)"', gradle, "Gradle's libraryName") != library:
        yield f"Gradle's prefab library is not {library}"
    if only(r'targets\("(\w+)"\)', gradle, "Gradle's targets") != module:
        yield f"Gradle does not build the target {module}"
    # As for Android, but with this machine's compiler and libraries: that is enough to see what the targets are called.
    configured = subprocess.run(["cmake", "-S", root, "-B", work, "-G", "Ninja", "-DANDROID=ON", "-DGLIDE_DESKTOP=OFF"],
                                capture_output=True, text=True, check=False)
    if configured.returncode != 0:
        yield f"cmake -DANDROID=ON fails:\n{configured.stderr}"
        return
    query = subprocess.run(["ninja", "-C", work, "-t", "query", module], capture_output=True, text=True, check=False)
    if f"/{library}.so" not in query.stdout:
        yield f"on Android the CMake target {module} is not {library}.so:\n{query.stdout}{query.stderr}"


def main():
    root, work = map(pathlib.Path, sys.argv[1:3])
    faults = [*version_faults(root), *activity_faults(root), *prefab_faults(root, work)]
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
