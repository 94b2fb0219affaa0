"""What the tests of the documents need of Markdown: headings, links, code in the text, and blocks of code."""
import dataclasses
import re

FENCE = re.compile(r"^\s*(`{3,})\s*(\w*)[ \t]*([^`]*)$")
HEADING = re.compile(r"^#{1,6}\s+(.*?)\s*#*$")
LINK = re.compile(r"\[[^\]]*\]\(\s*<?([^)\s>]+)>?(?:\s+\"[^\"]*\")?\s*\)")
CODE = re.compile(r"(`+)(.+?)\1", re.DOTALL)


@dataclasses.dataclass
class Block:
    """A fenced block. notes: what follows its language. first_line: the line number of its first line."""
    language: str
    notes: str
    first_line: int
    lines: list


@dataclasses.dataclass
class Document:
    """anchors: of its headings, as GitHub makes them. links and code: pairs of line number and text."""
    anchors: set
    links: list
    code: list
    blocks: list


def anchor_of(heading):
    text = LINK.sub(lambda link: link.group(0)[1:link.group(0).index("]")], heading)
    return re.sub(r"[^\w\- ]", "", text.lower()).replace(" ", "-")


def take_blocks(text):
    """The blocks, and the text with empty lines in their place."""
    blocks, rest, fence = [], [], None
    for number, line in enumerate(text.split("\n"), 1):
        match = FENCE.match(line)
        if fence is not None:
            if match and match.group(1) == fence and not match.group(2):
                fence = None
            else:
                blocks[-1].lines.append(line)
            line = ""
        elif match:
            fence = match.group(1)
            blocks.append(Block(match.group(2), match.group(3).strip(), number + 1, []))
            line = ""
        rest.append(line)
    return blocks, "\n".join(rest)


def paragraphs(text):
    """Pairs of first line number and paragraph: code and links may be broken over lines, not over empty ones."""
    number = 1
    for part in re.split(r"(\n\s*\n)", text):
        yield number, part
        number += part.count("\n")


def parse(text):
    blocks, rest = take_blocks(text)
    document = Document(set(), [], [], blocks)
    for line in rest.split("\n"):
        heading = HEADING.match(line)
        if heading:
            anchor = anchor_of(heading.group(1))
            twins = sum(re.fullmatch(re.escape(anchor) + r"(-\d+)?", other) is not None for other in document.anchors)
            document.anchors.add(f"{anchor}-{twins}" if anchor in document.anchors else anchor)
    for number, part in paragraphs(rest):
        for match in CODE.finditer(part):
            document.code.append((number + part[: match.start()].count("\n"), " ".join(match.group(2).split())))
        # Code is no link; its place is kept, so that lines can be counted.
        plain = CODE.sub(lambda match: re.sub(r"[^\n]", "x", match.group(0)), part)
        for match in LINK.finditer(plain):
            document.links.append((number + plain[: match.start()].count("\n"), match.group(1)))
    return document
