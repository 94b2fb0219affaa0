"""Reads what compile_shaders and the drivers print: numbers and disassembly per shader variant."""
import dataclasses
import re

# "MESA_SHADER_COMPUTE shader: 116 inst, 80 tuples, ..., 0:0 spills:fills" or "CL shader: 191 inst, 61 nops, ..."
STATISTICS = re.compile(r"^@message (?:.* )?\w+ shader: (\d+ inst, .*)$")
MESA_PREFIX = "MESA: info: "


@dataclasses.dataclass
class Variant:
    name: str
    numbers: dict  # the driver's words: {"inst": 116, "tuples": 80, ...}
    listing: list  # lines of the disassembly

    @property
    def shader(self):
        return self.name.split(" ")[0]

    @property
    def defines(self):
        return {key: int(value) for key, value in (word.split("=") for word in self.name.split(" ")[1:])}


def parse_statistics(text):
    """{"inst": 116, ..., "spills": 0, "fills": 0} of the text behind "shader: "."""
    numbers = {}
    for part in text.split(","):
        words = part.split()
        if len(words) < 2:
            continue
        values, names = words[0].split(":"), " ".join(words[1:]).split(":")
        numbers.update({name: float(value) for name, value in zip(names, values)})
    return numbers


def is_listing(line):
    """What belongs to a disassembly, and not to the compiler's inner languages, which are printed as well."""
    return line.startswith(("clause_", "ds(", "    *", "    +", MESA_PREFIX))


def read(lines):
    """(GPU's name, variants, errors)."""
    gpu, variants, errors = "", [], []
    for line in lines:
        if line.startswith("@gpu "):
            gpu = line[len("@gpu ") :]
        elif line.startswith("@variant "):
            variants.append(Variant(line[len("@variant ") :], {}, []))
        elif line.startswith("@error "):
            errors.append((variants[-1].name + ": " if variants else "") + line[len("@error ") :])
        elif line.startswith("@status ") and line != "@status 0" and not errors:
            errors.append(f"compile_shaders ended with {line[len('@status '):]}")
        elif variants:
            add_line(variants[-1], line)
    errors += [f"{variant.name}: the driver said nothing" for variant in variants if not variant.numbers]
    return gpu, variants, errors


def add_line(variant, line):
    statistics = STATISTICS.match(line)
    if statistics and not variant.numbers:  # what follows are further versions of the same, for instance for binning
        variant.numbers = parse_statistics(statistics.group(1))
    elif not variant.numbers and is_listing(line):
        variant.listing.append(line)
