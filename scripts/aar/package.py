#!/usr/bin/env python3
"""Puts an Android archive (AAR) together without Gradle: Java classes, one native library per ABI, the C headers as a
prefab module, and what the Android build wants to know.

usage: package.py --classes classes.jar --library ABI=LIB.so ... --headers DIR --android-project android/glide
                  --version X.Y.Z --min-sdk N [--ndk-major N] --output glide-slam.aar
"""
import argparse
import json
import pathlib
import re
import sys
import zipfile

# The oldest time that a zip can hold: the same input gives the same bytes.
EPOCH = (1980, 1, 1, 0, 0, 0)
PACKAGE = "io.github.glideslam"
MODULE = "glide"
LIBRARY = "libglide_jni.so"
# ABIs that Android has. Others are for tests of the packaging and say so in their name.
ANDROID_ABIS = {"arm64-v8a", "armeabi-v7a", "x86", "x86_64"}
TEST_ABI = re.compile(r"test-[a-z0-9_-]+")
METADATA = "META-INF/com/android/build/gradle/aar-metadata.properties"


class PackagingError(Exception):
    """What is wrong with the input, for people."""


def read(path):
    try:
        return pathlib.Path(path).read_bytes()
    except OSError as error:
        raise PackagingError(f"{path}: {error.strerror}") from error


def parse_library(text):
    abi, separator, path = text.partition("=")
    if not separator or not path:
        raise PackagingError(f"--library {text}: is not of the form ABI=FILE")
    if abi not in ANDROID_ABIS and not TEST_ABI.fullmatch(abi):
        raise PackagingError(f"--library {text}: {abi} is no ABI of Android (nor named test-...)")
    return abi, path


def prefab_entries(options, libraries):
    """The prefab module: schema 2, C only, so no STL crosses."""
    root = f"prefab/modules/{MODULE}"
    yield "prefab/prefab.json", json.dumps(
        {"schema_version": 2, "name": "glide-slam", "version": options.version, "dependencies": []}, indent=2)
    yield f"{root}/module.json", json.dumps(
        {"export_libraries": [], "library_name": LIBRARY.removesuffix(".so"), "android": {}}, indent=2)
    for header in ("glide.h", "glide_types.h"):
        yield f"{root}/include/glide/{header}", read(pathlib.Path(options.headers) / "glide" / header)
    for abi, path in libraries:
        description = {"abi": abi, "api": options.min_sdk, "ndk": options.ndk_major, "stl": "none", "static": False}
        yield f"{root}/libs/android.{abi}/abi.json", json.dumps(description, indent=2)
        yield f"{root}/libs/android.{abi}/{LIBRARY}", read(path)


def manifest(project, min_sdk):
    """The project's, with what Gradle has in its own files and an archive in the manifest: package and minimal SDK."""
    text = read(project / "src/main/AndroidManifest.xml").decode()
    merged, changes = re.subn(
        r"<manifest ([^>]*)>", rf'<manifest \1 package="{PACKAGE}">\n    <uses-sdk android:minSdkVersion="{min_sdk}" />', text)
    if changes != 1:
        raise PackagingError(f"{project}/src/main/AndroidManifest.xml: has no <manifest ...>")
    return merged


def entries(options):
    project = pathlib.Path(options.android_project)
    libraries = [parse_library(text) for text in options.library]
    yield "AndroidManifest.xml", manifest(project, options.min_sdk)
    yield "classes.jar", read(options.classes)
    yield "proguard.txt", read(project / "consumer-rules.pro")
    yield "R.txt", b""
    yield METADATA, f"aarFormatVersion=1.0\naarMetadataVersion=1.0\nminCompileSdk={options.min_sdk}\n"
    for abi, path in libraries:
        yield f"jni/{abi}/{LIBRARY}", read(path)
    yield from prefab_entries(options, libraries)


def write_archive(options):
    with zipfile.ZipFile(options.output, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in sorted(entries(options)):
            info = zipfile.ZipInfo(name, EPOCH)
            info.compress_type = zipfile.ZIP_DEFLATED
            info.external_attr = 0o644 << 16
            archive.writestr(info, content)


def parse_arguments(arguments):
    parser = argparse.ArgumentParser(description=__doc__.split("\n\n", maxsplit=1)[0])
    parser.add_argument("--classes", required=True)
    parser.add_argument("--library", action="append", required=True, metavar="ABI=FILE")
    parser.add_argument("--headers", required=True)
    parser.add_argument("--android-project", required=True)
    parser.add_argument("--version", required=True)
    parser.add_argument("--min-sdk", type=int, required=True)
    parser.add_argument("--ndk-major", type=int, default=0)
    parser.add_argument("--output", required=True)
    return parser.parse_args(arguments)


def main(arguments):
    try:
        write_archive(parse_arguments(arguments))
    except PackagingError as error:
        print(f"package.py: {error}", file=sys.stderr)
        return 1
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
