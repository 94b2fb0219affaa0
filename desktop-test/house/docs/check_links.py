#!/usr/bin/env python3
"""Fails where a link in the documents leads nowhere, or where a page of docs/ cannot be reached from docs/README.md or does
not lead back there.

usage: check_links.py ROOT
"""
import pathlib
import re
import sys

import markdown

INDEX = "docs/README.md"
FRONT = ["README.md", "CHANGELOG.md", "CONTRIBUTING.md"]
# A page named in running text, as README's tables do.
NAMED = re.compile(r"(?<![\w/.-])docs/[\w/.-]*\w")


def read(root):
    """{path relative to the root: Document} of all pages."""
    names = [name for name in FRONT if (root / name).exists()]
    names += sorted(str(path.relative_to(root)) for path in (root / "docs").rglob("*.md"))
    return {name: markdown.parse((root / name).read_text()) for name in names}


def target_of(root, page, link):
    """(path relative to the root or None when outside of it, anchor) of a link in a page."""
    path, _, anchor = link.partition("#")
    target = (root / page).parent.joinpath(path).resolve() if path else (root / page).resolve()
    try:
        return str(target.relative_to(root.resolve())), anchor
    except ValueError:
        return None, anchor


def links_of(root, page, document):
    """Triples of line, link as written, and target_of, of the links into the project."""
    for line, link in document.links:
        if not re.match(r"[a-z]+:", link):
            yield line, link, target_of(root, page, link)


def link_faults(root, pages):
    for page, document in pages.items():
        for line, link, (target, anchor) in links_of(root, page, document):
            if target is None or not (root / target).exists():
                yield f"{page}:{line}: there is no {link}"
            elif anchor and (target not in pages or anchor not in pages[target].anchors):
                yield f"{page}:{line}: {target} has no heading with the anchor #{anchor}"


def name_faults(root, pages):
    for page in pages:
        for number, line in enumerate((root / page).read_text().split("\n"), 1):
            for name in NAMED.findall(line):
                if not (root / name).exists():
                    yield f"{page}:{number}: names {name}, which does not exist"


def index_faults(root, pages):
    if INDEX not in pages:
        yield f"there is no {INDEX}"
        return
    listed = {target for _, _, (target, _) in links_of(root, INDEX, pages[INDEX])}
    for page, document in pages.items():
        if not page.startswith("docs/") or page == INDEX:
            continue
        here = page.removeprefix("docs/")
        if page not in listed:
            yield f"{INDEX} does not lead to {page}: add a line with [...]({here}) to the group it belongs to"
        if INDEX not in {target for _, _, (target, _) in links_of(root, page, document)}:
            back = "../" * here.count("/") + "README.md"
            yield f"{page} does not lead back to the index: add the line [All pages]({back}) below its title"


def faults_of(root):
    pages = read(root)
    return [*link_faults(root, pages), *name_faults(root, pages), *index_faults(root, pages)]


def main():
    faults = faults_of(pathlib.Path(sys.argv[1]))
    for fault in faults:
        print(fault)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
