#!/usr/bin/env python3
"""Fails where the library uses what Android's NDK r23 lacks: its clang is 12, its libc++ 11.

usage: check_portable.py ROOT
What no pattern can see, ./glide test --arch arm64 compiles against that very libc++.
"""
import pathlib
import re
import sys

FOLDERS = ("core", "jni")
HEADERS = ("barrier", "concepts", "coroutine", "execution", "format", "latch", "memory_resource", "ranges", "semaphore",
           "source_location", "stop_token", "syncstream")

# What to look for, and what to write instead.
PATTERNS = [
    (r"#\s*include\s*<(?:" + "|".join(HEADERS) + r")>", "libc++ 11 has no such header"),
    (r"std::(?:ranges|views|format|pmr|execution|source_location|jthread|stop_token)\b", "not in libc++ 11"),
    (r"std::(?:latch|barrier|counting_semaphore|binary_semaphore|atomic_ref|osyncstream)\b", "not in libc++ 11"),
    (r"std::atomic<\s*std::(?:shared|weak)_ptr\b", "use Published (core/base/published.h)"),
    (r"std::(?:bit_cast|bind_front|construct_at|identity|assume_aligned|source_location)\b", "not in libc++ 11"),
    (r"std::(?:make_unique_for_overwrite|make_shared_for_overwrite)\b", "not in libc++ 11"),
    (r"std::(?:same_as|convertible_to|integral|floating_point|invocable|derived_from)\b", "libc++ 11 has no concepts"),
    (r"std::(?:lexicographical_compare_three_way|compare_three_way)\b", "not in libc++ 11"),
    (r"std::make_shared<[^<>;]*\[\]>", "libc++ 11 makes no shared arrays"),
    (r"std::from_chars\([^;]*chars_format", "libc++ 11 reads only integers so"),
    (r"\busing\s+enum\b", "clang 12 does not know it"),
]
COMPILED = [(re.compile(pattern), reason) for pattern, reason in PATTERNS]
COMMENT = re.compile(r"//[^\n]*|/\*.*?\*/", re.DOTALL)


def without_comments(text):
    """The text with comments blanked, lines where they were."""
    return COMMENT.sub(lambda match: "\n" * match.group().count("\n"), text)


def faults_in(text):
    """(line number, what is there, why not) for each fault."""
    text = without_comments(text)
    for pattern, reason in COMPILED:
        for match in pattern.finditer(text):
            yield text.count("\n", 0, match.start()) + 1, match.group(), reason


def check(root):
    """All faults as lines of text, and the number of files read."""
    files = sorted(p for folder in FOLDERS for p in (root / folder).rglob("*") if p.suffix in (".h", ".cpp"))
    faults = [f"{path.relative_to(root)}:{line}: {found}: {reason}"
              for path in files for line, found, reason in faults_in(path.read_text())]
    return faults, len(files)


def main():
    faults, count = check(pathlib.Path(sys.argv[1]))
    print("\n".join(faults) if faults else f"{count} files use nothing that NDK r23 lacks, as far as patterns can tell")
    return 1 if faults or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
