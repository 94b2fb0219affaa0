#!/usr/bin/env python3
"""Reads the include graph of core/ and jni/ and fails where it breaks the layers of docs/architecture.md.

usage: check_layers.py ROOT
"""
import pathlib
import re
import sys

# Lowest first; folders on one line are siblings, which never include each other.
LAYERS = [
    {"include"},  # core/include/glide: the public headers
    {"base"},
    {"geometry", "image"},
    {"photometric"},
    {"feature", "gpu"},
    {"map"},
    {"optimize"},
    {"track", "mapping", "loop", "ar", "render"},
    {"session"},
    {"capi", "vit"},
]
RANK = {folder: rank for rank, folders in enumerate(LAYERS) for folder in folders}

# Libraries and the only places that may include them.
LIBRARIES = [
    (r"opencv2/", r"core/feature/.*|core/geometry/.*\.cpp", "OpenCV belongs to feature/ and geometry/*.cpp"),
    (r"ceres/", r"core/optimize/.*", "Ceres belongs to optimize/"),
    (r"(GLES\d?|EGL|GL)/", r"core/(gpu|render)/.*", "GL belongs to gpu/ and render/"),
    (r"glm/", r"core/render/.*", "GLM belongs to render/"),
    (r"hwy/", r"core/(image|photometric|feature)/.*\.cpp", "Highway belongs to the kernels' .cpp files"),
    (r"(gtest|gmock|benchmark|CLI|nlohmann|yaml-cpp|spdlog|fmt)/", r"(?!)", "core does without this library"),
]
INCLUDE = re.compile(r'^\s*#\s*include\s*([<"])([^>"]+)[>"]', re.MULTILINE)
STANDARD_HEADER = re.compile(r"[a-z_]+|(stddef|stdint|string)\.h")  # the last for the C ABI


def layer_of(path):
    """Folder of core/ that a path (relative to the root) belongs to."""
    return path.parts[1]


def target_folder(name):
    """Folder of core/ that `#include "name"` points into."""
    first = name.split("/")[0]
    return "include" if first == "glide" else first


def check_own_include(root, path, name):
    folder, target = layer_of(path), target_folder(name)
    base = "core/include" if target == "include" else "core"
    if not (root / base / name).is_file():
        return f'"{name}" is no file (write includes relative to core/)'
    if target not in RANK:
        return f"core/{target}/ has no place in the table of layers"
    if folder != target and RANK[target] >= RANK[folder]:
        relation = "a sibling of" if RANK[target] == RANK[folder] else "above"
        return f'"{name}": {target}/ is {relation} {folder}/'
    return None


def check_library_include(path, name):
    if layer_of(path) == "include" and not STANDARD_HEADER.fullmatch(name):
        return f"<{name}>: public headers include the standard library only"
    for library, allowed, rule in LIBRARIES:
        if re.match(library, name) and not re.fullmatch(allowed, path.as_posix()):
            return f"<{name}>: {rule}"
    return None


def check_file(root, path):
    if layer_of(path) not in RANK:
        return [f"core/{layer_of(path)}/ has no place in the table of layers"]
    found = []
    for mark, name in INCLUDE.findall((root / path).read_text()):
        fault = check_own_include(root, path, name) if mark == '"' else check_library_include(path, name)
        if fault:
            found.append(fault)
    return found


def check_binding(root, path):
    """jni/ is a client like any app: the C ABI, itself, and what is no library of the core's."""
    found = []
    for mark, name in INCLUDE.findall((root / path).read_text()):
        is_own = (root / path.parent / name).is_file()
        if mark == '"' and name != "glide/glide.h" and not is_own:
            found.append(f'"{name}": jni/ includes glide/glide.h and itself')
        elif mark == "<":
            found += [f"<{name}>: {rule}" for library, _, rule in LIBRARIES if re.match(library, name)]
    return found


def sources(root, folder):
    return sorted(p.relative_to(root) for p in (root / folder).rglob("*") if p.suffix in (".h", ".cpp"))


def check(root):
    """All faults as lines of text, and the number of files read."""
    core, jni = sources(root, "core"), sources(root, "jni")
    faults = [f"{path}: {fault}" for path in core for fault in check_file(root, path)]
    faults += [f"{path}: {fault}" for path in jni for fault in check_binding(root, path)]
    return faults, len(core) + len(jni)


def main():
    faults, count = check(pathlib.Path(sys.argv[1]))
    print("\n".join(faults) if faults else f"{count} files keep to their layers")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
