"""commands.toml: what the test does with each line of the documents' shell blocks."""
import re
import tomllib

FIELDS = {"line", "run", "why", "check"}


class RuleError(Exception):
    """What is wrong with commands.toml, for people."""


def normal(line):
    """A line as the rules have it: without a prompt, its comment, and spaces to align it."""
    return " ".join(re.sub(r"(^|\s+)#\s.*$", "", re.sub(r"^\s*\$ ", "", line)).split())


def lines_of(block):
    """Pairs of line number and command of a shell block; a backslash at its end continues a line."""
    number, begun = block.first_line, ""
    for offset, line in enumerate(block.lines):
        if block.language == "console" and not begun and not line.lstrip().startswith("$ "):
            continue
        number = number if begun else block.first_line + offset
        if line.rstrip().endswith("\\"):
            begun += line.rstrip()[:-1] + " "
            continue
        command, begun = normal(begun + line), ""
        if command:
            yield number, command


def judge(rule):
    """What is wrong with one rule, or None."""
    line = rule.get("line")
    if not isinstance(line, str) or normal(line) != line:
        return f"{line!r}: line is not a command with single spaces and without a comment"
    if set(rule) - FIELDS:
        return f"{line}: unknown field {', '.join(sorted(set(rule) - FIELDS))}"
    if ("run" in rule) == ("check" in rule):
        return f"{line}: wants either run or check"
    if "check" in rule and len(str(rule["check"])) < 8:
        return f"{line}: check is to say why the command is not run"
    if isinstance(rule.get("run"), str) and "why" not in rule:
        return f"{line}: why is to say in what the command that is run differs"
    if not isinstance(rule.get("run", True), str) and rule.get("run", True) is not True:
        return f"{line}: run is true, or the command to run in its place"
    return None


def read(path):
    """{line: rule}"""
    try:
        listed = tomllib.loads(path.read_text()).get("command", [])
    except tomllib.TOMLDecodeError as error:
        raise RuleError(f"{path.name}: {error}") from error
    rules = {}
    for rule in listed:
        fault = judge(rule)
        if fault is None and rule["line"] in rules:
            fault = f"{rule['line']}: has two rules"
        if fault is not None:
            raise RuleError(f"{path.name}: {fault}")
        rules[rule["line"]] = rule
    return rules


def command_of(rule):
    """The command to run, or None."""
    run = rule.get("run")
    return rule["line"] if run is True else run
