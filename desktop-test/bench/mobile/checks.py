"""What must hold of the compiled shaders; docs/benchmarks.md explains it."""
import disassembly

YARDSTICK = "plain.comp"
# What runs at every iteration and has the points side by side: its threads count. align_coarse.comp is one workgroup.
HOT = ("align_residual.comp",)
# Pixels of the inner loop per texture operation: a gather brings two more; the yardstick samples six times a pixel.
PIXELS_PER_FETCH = {"align_residual.comp": 2, "align_coarse.comp": 2, YARDSTICK: 1 / 6}
# Built as the paper says, to be compared with, not to be fast.
COMPARISON = "paper_"
USUAL_GROUP_SIZE = 64  # GpuTuning::group_size
MAX_RATIO = 1.5  # cost of a pixel, hot kernel to yardstick
# The GPUs that the checks are for, and what the driver calls the threads that run at a time.
CHECKED = {"Mali-G52": "threads", "Mali-G52 r1": "threads", "Adreno 630": "waves"}
SPILL_COUNTS = ("spills", "fills", "stp", "ldp")  # Mali's words, Adreno's words


def spills(numbers):
    return int(sum(numbers.get(key, 0) for key in SPILL_COUNTS))


def loop_cost(gpu, variant):
    """{"pixels", "instructions", ...} of the inner loop per pixel; {"error"} when it cannot be told."""
    steps = disassembly.read(gpu.compiler, variant.listing)
    faults = disassembly.disagreement(gpu.compiler, steps, variant.numbers)
    if faults:
        return {"error": "the disassembly does not add up: " + ", ".join(faults)}
    counts = disassembly.total(disassembly.innermost_loop_with(steps, "texture"))
    pixels = counts["texture"] * PIXELS_PER_FETCH[variant.shader]
    if not pixels:
        return {"error": "nothing is fetched"}
    cost = {"pixels": pixels, "instructions": counts["instructions"] / pixels}
    if gpu.compiler == "bifrost":
        cost["tuples"] = counts["tuples"] / pixels
        cost["cycles"] = disassembly.bifrost_cycles(counts) / pixels
    return cost


def loop_costs(gpu, variants):
    """Costs per variant name of the kernels of PIXELS_PER_FETCH, where the GPU's code was disassembled."""
    if not gpu.disassemble:
        return {}
    return {v.name: loop_cost(gpu, v) for v in variants if v.shader in PIXELS_PER_FETCH and v.numbers}


def check_spills(gpu, variants):
    return [
        f"{gpu.name}: {v.name} spills {spills(v.numbers)} times"
        for v in variants
        if spills(v.numbers) and not v.shader.startswith(COMPARISON)
    ]


def threads_at_a_time(gpu, variant):
    """In units of the driver. Workgroups of 128 run on an Adreno in waves of twice the lanes."""
    word = CHECKED[gpu.name]
    is_wide = word == "waves" and variant.defines["GROUP_SIZE"] >= 128
    return variant.numbers.get(word, 0) * (2 if is_wide else 1)


def check_threads(gpu, variants):
    """Against the yardstick, which takes few registers: it gets the most that the compiler grants."""
    plain = [threads_at_a_time(gpu, v) for v in variants if v.name == f"{YARDSTICK} GROUP_SIZE={USUAL_GROUP_SIZE}"]
    faults = []
    for variant in (v for v in variants if v.shader in HOT):
        granted, most = threads_at_a_time(gpu, variant), max(plain, default=0)
        if granted < most:
            word = CHECKED[gpu.name]
            faults.append(f"{gpu.name}: {variant.name} runs {granted:.0f} {word} at a time, {most:.0f} are possible")
    return faults


def yardstick_cost(costs):
    """The same for all group sizes."""
    return next((cost for name, cost in costs.items() if name.startswith(YARDSTICK)), {})


def check_loops(gpu, costs):
    faults = [f"{gpu.name}: {name}: {cost['error']}" for name, cost in costs.items() if "error" in cost]
    plain = yardstick_cost(costs)
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
