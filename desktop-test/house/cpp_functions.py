"""Finds the functions of C++, GLSL and Java sources: name, first line, length, parameters.

No compiler: it follows braces and looks at what stands before each. That is enough for formatted code.
"""
import re
from typing import NamedTuple


class Function(NamedTuple):
    name: str
    line: int
    length: int  # lines from the signature to the closing brace
    parameters: int


# What may be blanked without moving a line: comments, raw strings, strings, characters, preprocessor lines.
NOISE = re.compile(
    r'//[^\n]*|/\*.*?\*/|R"(?P<tag>\w*)\(.*?\)(?P=tag)"|"(?:\\.|[^"\\\n])*"|(?<![0-9a-zA-Z])\'(?:\\.|[^\'\\\n])+\''
    r"|^[ \t]*#(?:[^\n]*\\\n)*[^\n]*",
    re.DOTALL | re.MULTILINE,
)
TYPE_HEAD = re.compile(r"\b(namespace|class|struct|union|enum)\b[^()]*$")
PREFIX = re.compile(r"^(template\s*<[^{}]*?>\s*(?=[\w:\[])|layout\s*\([^)]*\))")
NAME = re.compile(r"(operator\s*\(\)|operator\s*[^\s(]+|~?[\w:~]+)\s*\($")


JAVA_TYPE = re.compile(r"@?\binterface\b|\brecord\b(?=\s+\w+)(?:(?P<name>\s+\w+)\s*\([^()]*\))?")
ANNOTATION = re.compile(r"@(?!interface\b)[\w.]+(\s*\((?:[^()]|\([^()]*\))*\))?")


def blank(text):
    """The text without noise, lines kept."""
    return NOISE.sub(lambda match: "\n" * match.group().count("\n") + '""' * (match.group()[0] in "\"R"), text)


def closing(text, begin, pair):
    """Index behind the bracket that closes the one at `begin`."""
    depth = 0
    for i in range(begin, len(text)):
        depth += (text[i] == pair[0]) - (text[i] == pair[1])
        if depth == 0:
            return i + 1
    return len(text)


def count_parameters(arguments):
    """Top-level commas plus one."""
    depth, commas = 0, 0
    for char in arguments:
        depth += (char in "(<[{") - (char in ")>]}")
        commas += char == "," and depth == 0
    return commas + 1 if arguments.strip() not in ("", "void") else 0


def parse_head(head):
    """(name, parameter text) when a `{` after this text opens a function body."""
    head = PREFIX.sub("", head.strip())
    if "(" not in head or TYPE_HEAD.match(head):
        return None
    begin = head.index("(")
    if head[:begin].rstrip().endswith("operator"):
        begin = head.index("(", begin + 1)
    name = NAME.search(head[: begin + 1])
    if not name or "=" in head[:begin].replace("operator=", "").replace("==", ""):
        return None
    return name.group(1), head[begin + 1 : closing(head, begin, "()") - 1]


def is_member_initialiser(head):
    """`Foo::Foo() : a_` before `{`: the brace initialises a_, the body is still to come."""
    parameters_end = closing(head, head.index("("), "()")
    rest = head[parameters_end:].lstrip()
    return rest.startswith(":") and re.search(r"[\w>]\s*$", rest) is not None


def functions(source):
    text = blank(source)
    found, start, i = [], 0, 0
    while i < len(text):
        char = text[i]
        if char in ";}":
            start = i + 1
        elif char == "{":
            head = text[start:i]
            parsed = parse_head(head)
            if parsed and is_member_initialiser(head.strip()):
                i = closing(text, i, "{}")
                continue
            if parsed:
                end = closing(text, i, "{}")
                first = text.count("\n", 0, start + len(head) - len(head.lstrip())) + 1
                found.append(Function(parsed[0], first, text.count("\n", 0, end) + 2 - first, count_parameters(parsed[1])))
                i = start = end
                continue
            if re.search(r"[=,(]\s*$|\breturn\s*$|[\w>\]]\s*$", head) and not TYPE_HEAD.search(head.strip()):
                i = closing(text, i, "{}")  # the braces of a value
                continue
            start = i + 1
        i += 1
    return found


def java_functions(source):
    """The methods, measured from the line behind their annotations."""
    text = ANNOTATION.sub(lambda match: "\n" * match.group().count("\n"), blank(source))
    return functions(JAVA_TYPE.sub(lambda match: "class" + (match.group("name") or ""), text))
