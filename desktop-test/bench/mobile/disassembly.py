"""What a loop costs, from the disassembly of Bifrost (Mali-G52) and of ir3 (Adreno 630).

A program is a list of steps: a clause or an instruction, with a label, the labels that it jumps to, and counts. A loop
reaches from a label to a later jump back to it.
"""
import collections
import dataclasses
import re

from driver_output import MESA_PREFIX


@dataclasses.dataclass
class Step:
    label: str = ""
    targets: tuple = ()
    counts: collections.Counter = dataclasses.field(default_factory=collections.Counter)


def total(steps):
    return sum((step.counts for step in steps), collections.Counter())


def loops(steps):
    """(first, last) of each loop, by step."""
    at = {step.label: index for index, step in enumerate(steps) if step.label}
    return [
        (at[target], index)
        for index, step in enumerate(steps)
        for target in step.targets
        if target in at and at[target] <= index
    ]


def innermost_loop_with(steps, kind):
    """The steps of the smallest loop in which something of this kind is done; all steps where no loop does it."""
    found = [(last - first, first, last) for first, last in loops(steps) if total(steps[first : last + 1])[kind]]
    if not found:
        return steps
    _, first, last = min(found)
    return steps[first : last + 1]


# --- Bifrost: clauses of tuples, a tuple being an instruction for FMA (*) and one for ADD (+); at most one message a
# clause. Cycles as Mesa counts them: 24 arithmetic tuples, 2 texture messages or 1 load or store per cycle.
MESSAGES = {"tex": "texture", "load": "memory", "store": "memory", "attr": "memory", "atomic": "memory"}
TUPLES_PER_CYCLE, TEXTURES_PER_CYCLE, ACCESSES_PER_CYCLE = 24, 2, 1


def is_message(add, kind):
    """Whether the ADD half of a tuple is its clause's message."""
    return bool(kind) and ("@" in add or "BARRIER" in add)


def read_clause_line(step, line, clause):
    if line.startswith("ds("):
        words = line.split()
        clause["kind"] = next((word for word in words if word in MESSAGES or word == "barrier"), "")
        if clause["kind"] in MESSAGES:
            step.counts[MESSAGES[clause["kind"]]] += 1
    elif line.startswith("    *"):
        clause["fma"] = not line.startswith("    *NOP")
    else:
        add = not line.startswith("    +NOP")
        step.counts["tuples"] += 1
        step.counts["instructions"] += clause["fma"] + add
        step.counts["arithmetic"] += clause["fma"] or not is_message(line, clause["kind"])
        step.counts["scratch"] += ".tl" in line  # thread-local memory: spills, and arrays that are indexed
        step.targets += tuple(re.findall(r"clause_\d+", line))


def read_bifrost(listing):
    steps, clause = [], {}
    for line in listing:
        if line.startswith("clause_"):
            steps.append(Step(label=line.rstrip(":")))
            clause = {"kind": "", "fma": False}
        elif steps:
            read_clause_line(steps[-1], line, clause)
    return steps


def bifrost_cycles(counts):
    return max(
        counts["arithmetic"] / TUPLES_PER_CYCLE,
        counts["texture"] / TEXTURES_PER_CYCLE,
        counts["memory"] / ACCESSES_PER_CYCLE,
    )


# --- ir3: one instruction a line, behind flags such as (sy)(rpt2)(nop3).
IR3_LABEL = re.compile(r"(l\d+):$")
IR3_INSTRUCTION = re.compile(r"((?:\([a-z]+\d*\))*)\s*([a-z][a-z0-9_.]*)(.*)$")
IR3_TEXTURE = re.compile(r"(isam|sam|gather4)")
IR3_MEMORY = re.compile(r"(ldib|stib|ldg|stg|ldl|stl|atomic)")
IR3_SCRATCH = re.compile(r"(ldp|stp)")


def ir3_step(line):
    flags, operation, operands = IR3_INSTRUCTION.match(line).groups()
    step = Step(targets=tuple(re.findall(r"#(l\d+)", operands)))
    step.counts["instructions"] = 1 + sum(int(count) for count in re.findall(r"\((?:rpt|nop)(\d+)\)", flags))
    for kind, pattern in (("texture", IR3_TEXTURE), ("memory", IR3_MEMORY), ("scratch", IR3_SCRATCH)):
        step.counts[kind] = int(bool(pattern.match(operation)))
    return step


def ir3_lines(listing):
    """The main program: from behind the preamble, which a draw call runs once (shps to shpe), to its end."""
    lines = [line[len(MESA_PREFIX) :] for line in listing if line.startswith(MESA_PREFIX)]
    begin = max((index for index, line in enumerate(lines) if line.startswith("Native code for")), default=len(lines))
    lines = [line for line in lines[begin + 1 :] if line and not line.startswith((";", "@"))]
    begin = max((index + 1 for index, line in enumerate(lines) if re.match(r"(\(\w+\))*shpe", line)), default=0)
    end = next((index + 1 for index, line in enumerate(lines) if re.match(r"(\(\w+\))*\s*end", line)), len(lines))
    return lines[begin:end]


def read_ir3(listing):
    steps, label = [], ""
    for line in ir3_lines(listing):
        if IR3_LABEL.match(line):
            label = IR3_LABEL.match(line).group(1)
        elif IR3_INSTRUCTION.match(line):
            steps.append(ir3_step(line))
            steps[-1].label, label = label, ""
    return steps


def read(compiler, listing):
    return read_bifrost(listing) if compiler == "bifrost" else read_ir3(listing)


def disagreement(compiler, steps, numbers):
    """Where our sums over the whole program are not the driver's; nothing when they agree."""
    counts = total(steps)
    ours = {"inst": counts["instructions"]}
    if compiler == "bifrost":
        ours.update(tuples=counts["tuples"], cycles=bifrost_cycles(counts))
    return [f"{key}: {ours[key]:.3f}, driver {numbers[key]:.3f}" for key in ours if abs(ours[key] - numbers[key]) > 0.01]
