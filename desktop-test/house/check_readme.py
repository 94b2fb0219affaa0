#!/usr/bin/env python3
"""Fails unless the README's C++ example is the one that the consumer test compiles and runs.

usage: check_readme.py ROOT
"""
import pathlib
import re
import sys

EXAMPLE = "desktop-test/house/consumer/readme_example.cpp"


def shown(readme):
    """The C++ blocks of a Markdown text."""
    return re.findall(r"```cpp\n(.*?)```", readme, re.DOTALL)


def compiled(source):
    """The example without its leading comment."""
    return source[source.index("#include") :]


def main():
    root = pathlib.Path(sys.argv[1])
    example = compiled((root / EXAMPLE).read_text())
    if shown((root / "README.md").read_text()) == [example]:
        return 0
    print(f"README.md must show, as its one C++ block, the code of {EXAMPLE}:\n\n{example}")
    return 1


if __name__ == "__main__":
    sys.exit(main())
