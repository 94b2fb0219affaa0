#!/usr/bin/env python3
"""Runs the commands of the documents, or checks them where running would take long: see commands.toml. Commands in running
text are checked, too, and so are the paths named there.

usage: commands.py ROOT WORK
Commands run in WORK/tree: links to the checkout and to what is built, an out/ of its own, and what fixtures.sh makes.
"""
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time

import check_links
import markdown
import rules
import validity

HERE = pathlib.Path(__file__).resolve().parent
SHELL = ("sh", "bash", "console")
# A block without a language that holds such a line is meant for the shell.
COMMAND_LINE = re.compile(r"\s*(\$ )?(\./glide |(scripts|desktop-test)/\S+\.(sh|py)|cmake -|([A-Z]+=\"?)?build/\S+/|ctest |gradle )")
# In running text `--option` is one of ./glide, but on these pages.
OTHER_PROGRAMS = ("docs/android.md", "docs/benchmarks.md", "docs/exports.md")
# How long one block may run before it is given up, in seconds.
TIMEOUT = 120

NO_RULE = """{place}: no rule says what the test does with the command
    {line}
Add to desktop-test/house/docs/commands.toml
    [[command]]
    line = '{line}'
    run = true
(what fixtures.sh makes may be named; run = '...' and why = '...' run a smaller command in its place), or, when it takes
minutes, a device or the network, in place of the last line
    check = 'why it is not run'"""


def pages(root):
    """Pairs of a page's name and its Document."""
    return sorted(check_links.read(root).items())


def block_commands(root):
    """(place, block, line) of every command in a shell block."""
    for page, document in pages(root):
        for block in document.blocks:
            if block.language in SHELL:
                for number, line in rules.lines_of(block):
                    yield f"{page}:{number}", block, line


def untagged_faults(root):
    for page, document in pages(root):
        for block in document.blocks:
            if not block.language and any(COMMAND_LINE.match(line) for line in block.lines):
                yield f"{page}:{block.first_line - 1}: the block holds commands: begin it with ```sh, not ```"


def rule_faults(root, ruled):
    seen = set()
    for place, _, line in block_commands(root):
        seen.add(line)
        if line not in ruled:
            yield NO_RULE.format(place=place, line=line)
    for line in sorted(set(ruled) - seen):
        yield f"commands.toml: no document has the command any more: {line}"


def validity_faults(root, checker):
    for place, _, line in block_commands(root):
        for fault in checker.faults(line):
            yield f"{place}: {line}: {fault}"
    for page, document in pages(root):
        for number, code in document.code:
            if validity.is_checkable(code):
                found = checker.faults(code)
            else:
                found = checker.option_faults(code) if page not in OTHER_PROGRAMS else []
            for fault in found:
                yield f"{page}:{number}: `{code}`: {fault}"


def make_tree(root, tree):
    """What looks like the checkout after a build."""
    shutil.rmtree(tree, ignore_errors=True)
    (tree / "build").mkdir(parents=True)
    shutil.copy2(root / "glide", tree / "glide")
    shutil.copytree(root / "scripts", tree / "scripts")
    for path in root.iterdir():
        if path.name not in ("glide", "scripts", "build", "out") and not path.name.startswith("."):
            (tree / path.name).symlink_to(path)
    for name in ("release", "cache"):
        if (root / "build" / name).exists():
            (tree / "build" / name).symlink_to(root / "build" / name)


def shell(script, tree, environment):
    """(succeeded, output)"""
    try:
        done = subprocess.run(["bash", "-c", script], cwd=tree, env=environment, stdout=subprocess.PIPE, stderr=subprocess.STDOUT,
                              stdin=subprocess.DEVNULL, text=True, errors="replace", timeout=TIMEOUT, check=False)
    except subprocess.TimeoutExpired as error:
        return False, f"{error.output or ''}\ngiven up after {TIMEOUT} s"
    return done.returncode == 0, done.stdout


def scripts_of(root, ruled):
    """(place, script) of each block that has something to run: its lines share a shell."""
    blocks = {}
    for place, block, line in block_commands(root):
        command = rules.command_of(ruled.get(line, {"check": ""}))
        if command:
            blocks.setdefault(id(block), (place, []))[1].append(command)
    for place, commands in blocks.values():
        yield place, commands


def run_faults(root, ruled, tree, environment):
    make_tree(root, tree)
    done, output = shell(f"set -euo pipefail\n. {HERE}/fixtures.sh", tree, environment)
    if not done:
        yield f"fixtures.sh fails:\n{output}"
        return
    for place, commands in scripts_of(root, ruled):
        begin = time.monotonic()
        done, output = shell("\n".join(["set -euxo pipefail", *commands]), tree, environment)
        print(f"{place}: {'; '.join(commands)} ({time.monotonic() - begin:.1f} s)", flush=True)
        if not done:
            yield f"{place}: what the block says does not work:\n{output[-4000:]}"


def main():
    root, work = (pathlib.Path(argument).resolve() for argument in sys.argv[1:3])
    environment = {**os.environ, "GLIDE_NO_BUILD": "1", "NO_COLOR": "1"}
    try:
        ruled = rules.read(HERE / "commands.toml")
    except rules.RuleError as error:
        print(error)
        return 1
    checker = validity.Checker(root, root / "glide", environment)
    faults = [*untagged_faults(root), *rule_faults(root, ruled), *validity_faults(root, checker),
              *run_faults(root, ruled, work / "tree", environment)]
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
