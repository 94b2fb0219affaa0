#!/usr/bin/env python3
"""Fails where a block of C or C++ in a document does not compile, with the document's file and line.

usage: compile_code.py ROOT INCLUDES

INCLUDES is the installed headers' folder. Blocks are whole files, C99 or C++20 by their language; ```c fragment is the
body of a function that has a session and an image.
"""
import pathlib
import subprocess
import sys

import markdown

COMPILERS = {
    "c": ["cc", "-xc", "-std=c99", "-pedantic"],
    "cpp": ["c++", "-xc++", "-std=c++20"],
}
WARNINGS = ["-Wall", "-Wextra", "-Werror", "-fsyntax-only"]
FRAGMENT = "fragment"
BEFORE = {
    "c": "#include <glide/glide.h>\n#include <stdio.h>\n#include <stdlib.h>\n"
    "void fragment(glide_session* session, glide_image image);\n"
    "void fragment(glide_session* session, glide_image image) {\n(void)session; (void)image;\n",
    "cpp": "#include <glide/session.h>\nvoid fragment(glide::Session& session, const glide::FrameInput& image) {\n"
    "(void)session; (void)image;\n",
}
AFTER = "\n}\n"
# Of other libraries than ours, as far as the documents use them.
DECLARATIONS = "desktop-test/android/ndk_declarations"


def blocks_of(text):
    return [block for block in markdown.parse(text).blocks if block.language in COMPILERS]


def source_of(block, name):
    """What the compiler gets: it counts lines as the document does."""
    code = f'#line {block.first_line} "{name}"\n' + "\n".join(block.lines)
    if block.notes == FRAGMENT:
        return BEFORE[block.language] + code + AFTER
    return code + "\n"


def fault_of(block, name, includes):
    """What the compiler says, or nothing."""
    command = [*COMPILERS[block.language], *WARNINGS, *(f"-I{folder}" for folder in includes), "-"]
    done = subprocess.run(command, input=source_of(block, name), capture_output=True, text=True, check=False)
    return done.stderr if done.returncode else ""


def main():
    root, headers = map(pathlib.Path, sys.argv[1:3])
    documents = [root / "README.md", *sorted((root / "docs").rglob("*.md"))]
    count, faults = 0, []
    for path in documents:
        for block in blocks_of(path.read_text()):
            count += 1
            faults.append(fault_of(block, path.relative_to(root), [headers, root / DECLARATIONS]))
    print(f"{count} blocks of C and C++")
    print("".join(faults), end="")
    return 1 if any(faults) or count == 0 else 0


if __name__ == "__main__":
    sys.exit(main())
