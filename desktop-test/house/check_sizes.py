#!/usr/bin/env python3
"""Fails where a file, a function or a parameter list is longer than docs/conventions.md allows.

usage: check_sizes.py ROOT
"""
import ast
import pathlib
import re
import sys

import cpp_functions

FOLDERS = ("core", "jni", "shaders", "android", "desktop-test", "scripts", "cmake")
FILES = ("glide", ".ci/run")
FOREIGN = {"node_modules"}
SOURCES = {".h", ".cpp", ".comp", ".vert", ".frag", ".glsl"}
# A function of JavaScript that makes an object holds all of its methods: their files are measured, they are not.
COUNTED = SOURCES | {".java", ".kts", ".py", ".sh", ".cmake", ".txt", ".js", ".mjs", ".css", ".html"}
MAX_FILE_LINES = 300
MAX_FUNCTION_LINES, LONG_FUNCTION_LINES = 60, 40  # the first fails, the second is counted
MAX_PARAMETERS = 5
# Tables of numbers that a script wrote.
GENERATED = {"core/feature/descriptor_pattern.cpp"}


def python_functions(text):
    """The same for Python."""
    nodes = (n for n in ast.walk(ast.parse(text)) if isinstance(n, ast.FunctionDef))
    return [
        cpp_functions.Function(n.name, n.lineno, n.end_lineno - n.lineno + 1, len(n.args.args)) for n in nodes
    ]


def functions_of(path, text):
    if path.suffix in SOURCES:
        return cpp_functions.functions(text)
    if path.suffix == ".java":
        return cpp_functions.java_functions(text)
    return python_functions(text) if path.suffix == ".py" else []


def is_waived(lines, function):
    """Where a foreign interface dictates the size, the line before the function says so to clang-tidy and to us."""
    waivers = ("NOLINTNEXTLINE(readability-function-size)", "NOLINTBEGIN(readability-function-size)")
    return function.line > 1 and any(waiver in lines[function.line - 2] for waiver in waivers)


def check_text(path, text):
    """Faults of one file as text, and its functions."""
    faults, source_lines = [], text.split("\n")
    found = [f for f in functions_of(path, text) if not is_waived(source_lines, f)]
    lines = text.count("\n")
    if lines > MAX_FILE_LINES:
        faults.append(f"{path}: {lines} lines, at most {MAX_FILE_LINES} are allowed")
    for function in found:
        where = f"{path}:{function.line}: {function.name}"
        if function.length > MAX_FUNCTION_LINES:
            faults.append(f"{where} has {function.length} lines, at most {MAX_FUNCTION_LINES} are allowed")
        if function.parameters > MAX_PARAMETERS:
            faults.append(f"{where} has {function.parameters} parameters, at most {MAX_PARAMETERS} are allowed")
    return faults, found


def percentile(values, share):
    return sorted(values)[min(len(values) - 1, int(share * len(values)))]


def summarise(lines, found):
    lengths = [function.length for _, function in found]
    print(f"{len(lines)} files, 90th percentile {percentile(lines, 0.9)} lines, longest {max(lines)}")
    print(f"{len(found)} functions, 90th percentile {percentile(lengths, 0.9)} lines, longest {max(lengths)}")
    long = [(path, f) for path, f in found if f.length > LONG_FUNCTION_LINES]
    print(f"{len(long)} functions are longer than {LONG_FUNCTION_LINES} lines:")
    for path, function in long:
        print(f"  {path}:{function.line}: {function.name} {function.length}")


def counted_files(root):
    """Paths relative to the root."""
    files = [pathlib.Path(name) for name in FILES]
    for folder in FOLDERS:
        files += [p.relative_to(root) for p in (root / folder).rglob("*") if p.suffix in COUNTED]
    return sorted(p for p in files if p.as_posix() not in GENERATED and not FOREIGN & set(p.parts))


def main():
    root = pathlib.Path(sys.argv[1])
    faults, found, lines = [], [], []
    for name in counted_files(root):
        path = root / name
        text = path.read_text()
        lines.append(text.count("\n"))
        file_faults, file_functions = check_text(name, text)
        faults += file_faults
        found += [(name, function) for function in file_functions]
    summarise(lines, found)
    print("\n".join(faults))
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
