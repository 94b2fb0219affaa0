"""The results as JSON and as the tables of docs/benchmarks.md."""
import checks

BEGIN = "<!-- ./glide bench mobile-compilers writes from here -->"
END = "<!-- to here -->"
# Columns of a cell: heading, the driver's word, and which of a shader's variants is the worst.
CELLS = {
    "bifrost": (("inst", "inst", max), ("cycles", "cycles", max), ("threads", "threads", min)),
    "midgard": (("inst", "inst", max), ("regs", "registers", max), ("threads", "threads", min)),
    "ir3": (("inst", "inst", max), ("regs", "full", max), ("waves", "waves", min)),
}


def number(value):
    return f"{value:.1f}".rstrip("0").rstrip(".")


def cell(gpu, variants):
    """"inst / cycles / threads" of the worst variant in each; spills stand out."""
    numbers = [variant.numbers for variant in variants if variant.numbers]
    if not numbers:
        return "-"
    parts = [number(worst(n.get(word, 0) for n in numbers)) for _, word, worst in CELLS[gpu.compiler]]
    spills = max(checks.spills(n) for n in numbers)
    return " / ".join(parts) + (f" / **{spills} spills**" if spills else "")


def row(*cells):
    return "| " + " | ".join(cells) + " |"


def shader_table(results, compilers):
    """One line per shader, one column per GPU of these compilers."""
    chosen = [result for result in results if result.gpu.compiler in compilers]
    if not chosen:
        return []
    heads = [f"{r.gpu.name}: {', '.join(head for head, _, _ in CELLS[r.gpu.compiler])}" for r in chosen]
    lines = [row("shader (variants)", *heads), "|" + "---|" * (len(heads) + 1)]
    for shader in dict.fromkeys(v.shader for v in chosen[0].variants):
        of_shader = [[v for v in r.variants if v.shader == shader] for r in chosen]
        cells = [cell(r.gpu, variants) for r, variants in zip(chosen, of_shader)]
        lines.append(row(f"{shader} ({len(of_shader[0])})", *cells))
    return lines


UNITS = ("instructions", "tuples", "cycles")


def worst_costs(costs):
    """Per shader and unit the most that a pixel costs in any of its variants."""
    worst = {}
    for name, cost in costs.items():
        of_shader = worst.setdefault(name.split(" ")[0], {})
        for unit in UNITS:
            if unit in cost:
                of_shader[unit] = max(cost[unit], of_shader.get(unit, 0))
    return worst


def loop_table(results):
    """Cost of a pixel in the inner loop, and how many times the yardstick's."""
    lines = [row("inner loop, per pixel", "GPU", *UNITS, "x yardstick"), "|" + "---|" * 6]
    for result in results:
        plain = checks.yardstick_cost(result.costs)
        for shader, cost in worst_costs(result.costs).items():
            ratio = max((cost[unit] / plain[unit] for unit in cost if unit in plain), default=0)
            values = [f"{cost[unit]:.1f}" if unit in cost else "" for unit in UNITS]
            lines.append(row(shader, result.gpu.name, *values, f"{ratio:.2f}"))
    return lines


def markdown(results, faults):
    lines = shader_table(results, ("bifrost", "midgard")) + [""] + shader_table(results, ("ir3",)) + [""]
    lines += loop_table(results) + [""]
    lines += [f"Broken: {fault}." for fault in faults] or ["All checks hold."]
    return "\n".join(lines)


def as_json(results, faults):
    return {
        "mobile_compilers": [
            {
                "gpu": result.gpu.name,
                "renderer": result.renderer,
                "variants": [
                    {"name": v.name, "spilled": checks.spills(v.numbers), "driver": v.numbers} for v in result.variants
                ],
                "inner_loop_per_pixel": result.costs,
            }
            for result in results
        ],
        "broken": faults,
    }


def between_markers(text, tables):
    """The page with its tables replaced; an error where the markers are missing."""
    head, begin, rest = text.partition(BEGIN)
    _, end, tail = rest.partition(END)
    if not begin or not end:
        raise ValueError(f"the markers {BEGIN!r} and {END!r} are missing")
    return f"{head}{BEGIN}\n{tables}\n{END}{tail}"
