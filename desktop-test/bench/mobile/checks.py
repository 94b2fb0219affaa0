"""What must hold of the compiled shaders; docs/benchmarks.md explains it."""
import disassembly

YARDSTICK = "plain.comp"
YARDSTICK_FETCHES = 6  # texture operations of one pixel
# Kernels that run at every iteration, and in whose inner loop a row of PATCH_SIZE pixels takes one fetch more.
HOT = ("align_residual.comp",)
MAX_RATIO = 1.5  # cost of a pixel, hot kernel to yardstick
# The GPUs that the checks are for, and what the driver calls the threads that run at a time.
CHECKED = {"Mali-G52": "threads", "Mali-G52 r1": "threads", "Adreno 630": "waves"}
SPILL_COUNTS = ("spills", "fills", "stp", "ldp")  # Mali's words, Adreno's words


def spills(numbers):
    return int(sum(numbers.get(key, 0) for key in SPILL_COUNTS))


def pixels_of(variant, fetches):
    """Pixels that so many fetches stand for; None when they are not whole rows."""
    if variant.shader == YARDSTICK:
        pixels, rest = divmod(fetches, YARDSTICK_FETCHES)
    else:
        patch = variant.defines["PATCH_SIZE"]
        rows, rest = divmod(fetches, patch + 1)
        pixels = rows * patch
    return pixels if pixels and not rest else None


def loop_cost(gpu, variant):
    """{"pixels", "instructions", ...} of the inner loop per pixel; {"error"} when it cannot be told."""
    steps = disassembly.read(gpu.compiler, variant.listing)
    faults = disassembly.disagreement(gpu.compiler, steps, variant.numbers)
    if faults:
        return {"error": "the disassembly does not add up: " + ", ".join(faults)}
    counts = disassembly.total(disassembly.innermost_loop_with(steps, "texture"))
    pixels = pixels_of(variant, counts["texture"])
    if pixels is None:
        return {"error": f"{counts['texture']} fetches in the inner loop are no whole rows"}
    cost = {"pixels": pixels, "instructions": counts["instructions"] / pixels}
    if gpu.compiler == "bifrost":
        cost["tuples"] = counts["tuples"] / pixels
        cost["cycles"] = disassembly.bifrost_cycles(counts) / pixels
    return cost


def loop_costs(gpu, variants):
    """Costs per variant name of the hot kernels and the yardstick, where the GPU's code was disassembled."""
    if not gpu.disassemble:
        return {}
    watched = (*HOT, YARDSTICK)
    return {v.name: loop_cost(gpu, v) for v in variants if v.shader in watched and v.numbers}


def check_spills(gpu, variants):
    return [f"{gpu.name}: {v.name} spills {spills(v.numbers)} times" for v in variants if spills(v.numbers)]


def check_threads(gpu, variants):
    """Hot kernels run as many threads at a time as the yardstick, which has few registers."""
    word = CHECKED[gpu.name]
    most = max((v.numbers.get(word, 0) for v in variants if v.shader == YARDSTICK), default=0)
    return [
        f"{gpu.name}: {v.name} runs {v.numbers.get(word, 0):.0f} {word} at a time, {most:.0f} are possible"
        for v in variants
        if v.shader in HOT and v.numbers.get(word, 0) < most
    ]


def check_loops(gpu, costs):
    faults = [f"{gpu.name}: {name}: {cost['error']}" for name, cost in costs.items() if "error" in cost]
    plain = costs.get(YARDSTICK, {})
    for name, cost in costs.items():
        for unit in ("instructions", "tuples", "cycles"):
            if unit in cost and unit in plain and cost[unit] > MAX_RATIO * plain[unit]:
                faults.append(
                    f"{gpu.name}: {name} takes {cost[unit]:.2f} {unit} a pixel, more than "
                    f"{MAX_RATIO} x the {plain[unit]:.2f} of {YARDSTICK}"
                )
    return faults


def check(gpu, variants, costs):
    """Faults, as sentences. Nothing is asked of the GPUs that are only looked at."""
    if gpu.name not in CHECKED:
        return []
    return check_spills(gpu, variants) + check_threads(gpu, variants) + check_loops(gpu, costs)


def check_hot_kernels(variants):
    """A kernel that was renamed must not slip out of the checks."""
    shaders = {variant.shader for variant in variants}
    return [f"the hot kernel {name} is not there any more: see checks.py" for name in HOT if name not in shaders]
