#!/usr/bin/env python3
"""Checks an Android archive: what is in it, the prefab module, what its libraries export and how they are aligned.

usage: check.py glide-slam.aar [--json]
Prints the sizes per ABI. Exit status 1 and a line for each fault when there are any.
"""
import json
import pathlib
import re
import subprocess
import sys
import tempfile
import xml.etree.ElementTree
import zipfile

LIBRARY = "libglide_jni.so"
PREFAB = "prefab/modules/glide"
NEEDED = [
    "AndroidManifest.xml", "classes.jar", "proguard.txt", "R.txt",
    "META-INF/com/android/build/gradle/aar-metadata.properties",
    "prefab/prefab.json", f"{PREFAB}/module.json",
    f"{PREFAB}/include/glide/glide.h", f"{PREFAB}/include/glide/glide_types.h",
]
# Android 15 devices may have pages of 16 KiB; Google Play asks for it.
PAGE_BYTES = 16384
EXPORTS = re.compile(r"JNI_OnLoad|JNI_OnUnload|glide_[a-z_]+")
ABI_FIELDS = {"abi": str, "api": int, "ndk": int, "stl": str, "static": bool}


def output_of(*command):
    return subprocess.run(command, check=True, capture_output=True, text=True).stdout


def exported(library):
    lines = output_of("nm", "-D", "--defined-only", str(library)).splitlines()
    return [line.split()[-1].split("@")[0] for line in lines]


def load_alignments(library):
    lines = output_of("readelf", "-lW", str(library)).splitlines()
    return [int(line.split()[-1], 16) for line in lines if line.split()[:1] == ["LOAD"]]


def library_faults(abi, library):
    names = exported(library)
    for name in names:
        if not EXPORTS.fullmatch(name):
            yield f"{abi}: exports {name}"
    if "JNI_OnLoad" not in names or "glide_session_create" not in names:
        yield f"{abi}: JNI_OnLoad or glide_session_create is not exported"
    alignments = load_alignments(library)
    if not alignments:
        yield f"{abi}: has no LOAD segment"
    for alignment in alignments:
        if alignment % PAGE_BYTES != 0:
            yield f"{abi}: a LOAD segment is aligned to {alignment}, not to {PAGE_BYTES}"


def prefab_faults(archive, abis):
    package = json.loads(archive.read("prefab/prefab.json"))
    if package.get("schema_version") != 2 or package.get("name") != "glide-slam" or package.get("dependencies") != []:
        yield "prefab.json: not schema 2 of glide-slam without dependencies"
    module = json.loads(archive.read(f"{PREFAB}/module.json"))
    if module.get("export_libraries") != [] or module.get("library_name") != LIBRARY.removesuffix(".so"):
        yield "module.json: not a module of " + LIBRARY
    for abi in abis:
        folder = f"{PREFAB}/libs/android.{abi}"
        names = archive.namelist()
        if f"{folder}/abi.json" not in names or f"{folder}/{LIBRARY}" not in names:
            yield f"prefab has no library for {abi}"
            continue
        description = json.loads(archive.read(f"{folder}/abi.json"))
        if {key: type(value) for key, value in description.items()} != ABI_FIELDS or description["abi"] != abi:
            yield f"{folder}/abi.json: not the fields of schema 2"
        if description.get("stl") != "none":
            yield f"{folder}/abi.json: stl is not none, but only C crosses"
        if archive.read(f"{folder}/{LIBRARY}") != archive.read(f"jni/{abi}/{LIBRARY}"):
            yield f"{abi}: the prefab library is another one than jni's"


def classes_faults(archive, folder):
    path = pathlib.Path(folder) / "classes.jar"
    path.write_bytes(archive.read("classes.jar"))
    with zipfile.ZipFile(path) as classes:
        if "io/github/glideslam/Session.class" not in classes.namelist():
            yield "classes.jar: has no io.github.glideslam.Session"


def manifest_faults(archive):
    manifest = xml.etree.ElementTree.fromstring(archive.read("AndroidManifest.xml"))
    if manifest.get("package") != "io.github.glideslam":
        yield f"AndroidManifest.xml: package is {manifest.get('package')}"
    if len(list(manifest.iter("uses-sdk"))) != 1:
        yield "AndroidManifest.xml: does not tell the minimal SDK"
    android = "{http://schemas.android.com/apk/res/android}"
    versions = [feature.get(f"{android}glEsVersion") for feature in manifest.iter("uses-feature")]
    if "0x00030001" not in versions:
        yield "AndroidManifest.xml: does not ask for OpenGL ES 3.1"


def check(path):
    """(faults, {abi: bytes of the library})"""
    with zipfile.ZipFile(path) as archive, tempfile.TemporaryDirectory() as folder:
        names = archive.namelist()
        faults = [f"{name} is missing" for name in NEEDED if name not in names]
        abis = sorted(name.split("/")[1] for name in names if name.startswith("jni/"))
        if not abis:
            faults.append("there is no native library under jni/")
        if faults:
            return faults, {}
        sizes = {}
        for abi in abis:
            library = pathlib.Path(folder) / abi
            library.write_bytes(archive.read(f"jni/{abi}/{LIBRARY}"))
            sizes[abi] = library.stat().st_size
            faults += library_faults(abi, library)
        faults += [*prefab_faults(archive, abis), *classes_faults(archive, folder), *manifest_faults(archive)]
        return faults, sizes


def main(arguments):
    path = pathlib.Path(arguments[0])
    faults, sizes = check(path)
    for fault in faults:
        print(f"{path.name}: {fault}", file=sys.stderr)
    report = {"aar_bytes": path.stat().st_size, "library_bytes": sizes}
    if "--json" in arguments:
        print(json.dumps(report))
    else:
        print(f"{path}: {report['aar_bytes'] / 1e6:.1f} MB")
        for abi, size in sizes.items():
            print(f"  {abi}: {LIBRARY} {size / 1e6:.1f} MB")
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
