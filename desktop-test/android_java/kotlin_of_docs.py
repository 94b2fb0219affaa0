#!/usr/bin/env python3
"""Writes the Kotlin of the documents into files that a compiler takes, with the lines of the documents.

usage: kotlin_of_docs.py ROOT OUT

```kotlin gradle is a build script, which needs Gradle: it is left out.
"""
import pathlib
import shutil
import sys

ROOT, OUT = map(pathlib.Path, sys.argv[1:3])
sys.path.insert(0, str(ROOT / "desktop-test/house/docs"))
import markdown  # noqa: E402

# What an editor adds by itself.
IMPORTS = [
    "android.content.Context",
    "android.opengl.GLSurfaceView",
    "android.util.Log",
    "android.util.Size",
    "io.github.glideslam.*",
    "io.github.glideslam.android.*",
    "javax.microedition.khronos.egl.EGLConfig",
    "javax.microedition.khronos.opengles.GL10",
]


def source_of(block):
    header = "; ".join(f"import {name}" for name in IMPORTS)
    return header + "\n" * (block.first_line - 1) + "\n".join(block.lines) + "\n"


def main():
    shutil.rmtree(OUT, ignore_errors=True)
    OUT.mkdir(parents=True)
    count = 0
    for path in [ROOT / "README.md", *sorted((ROOT / "docs").rglob("*.md"))]:
        for block in markdown.parse(path.read_text()).blocks:
            if block.language != "kotlin" or block.notes == "gradle":
                continue
            count += 1
            (OUT / f"{path.stem}_md_{block.first_line}.kt").write_text(source_of(block))
    print(f"{count} blocks of Kotlin")
    return 0 if count else 1


if __name__ == "__main__":
    sys.exit(main())
