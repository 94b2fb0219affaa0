"""The paper's four tables with our figures beside its own, as Markdown."""
import figures

# The paper's sequences have 2200 to 3700 frames: fewer are a part of one.
WHOLE_SEQUENCE_FRAMES = 2200
NONE = "-"


def row(*cells):
    return "| " + " | ".join(cells) + " |"


def table(head, rows):
    return "\n".join([row(*head), "|---|" + "---:|" * (len(head) - 1), *(row(*cells) for cells in rows)])


def number(value, pattern):
    return NONE if value is None else pattern.format(value)


def ratio(slow, fast):
    return f"{slow / fast:.1f} x" if slow and fast else NONE


def pairs(values, pattern, with_ratio=False):
    """The paper's pairs of one sequence, a cell a device; what is not in the paper is empty."""
    if values is None:
        return [NONE] * len(figures.DEVICES)
    cells = [" / ".join(pattern.format(value) for value in pair) for pair in values]
    return [f"{cell}, {ratio(*pair)}" for cell, pair in zip(cells, values)] if with_ratio else cells


def label(result):
    """The folder's name, and what part of which of the paper's sequences it is."""
    if result["paper"] is None:
        return result["name"]
    medians = [result[tracker]["median"] for tracker in ("hybrid", "indirect")]
    frames = max((m["frames_in"] or 0) + (m["frames_dropped"] or 0) for m in medians)
    part = f"{frames:.0f} frames of " if 0 < frames < WHOLE_SEQUENCE_FRAMES else ""
    return f"{result['name']} ({part}{result['paper']})"


def median(result, tracker, name):
    return result[tracker]["median"][name]


def time_table(results):
    def cells(result):
        indirect, hybrid = (median(result, tracker, "frame_ms") for tracker in ("indirect", "hybrid"))
        paper = figures.FRAME_MS.get(result["paper"])
        return [label(result), number(indirect, "{:.2f}"), number(hybrid, "{:.2f}"), ratio(indirect, hybrid),
                *pairs(paper, "{:.1f}", with_ratio=True)]

    head = ["sequence", "indirect only", "hybrid", "speed-up", *(f"paper, {d}: ORB / GLidE" for d in figures.DEVICES)]
    return "## Median frame time, ms\n\n" + table(head, map(cells, results))


def gpu_table(results):
    def cells(result):
        paper = figures.GPU_MS.get(result["paper"])
        hybrid = result["hybrid"]
        return [label(result), number(hybrid["median"]["pre_ms"], "{:.2f}"), number(hybrid["median"]["trk_ms"], "{:.2f}"),
                hybrid["timer"] or NONE, *pairs(paper, "{:.1f}")]

    head = ["sequence", "Pre", "Trk", "timer", *(f"paper, {device}: Pre / Trk" for device in figures.DEVICES)]
    return ("## Direct tracker, ms\n\nPre: pyramid + precompute; Trk: pyramid + track. Timer cpu: the tracker ran on "
            "the CPU.\n\n" + table(head, map(cells, results)))


def share_table(results):
    def cells(result):
        share = median(result, "hybrid", "direct_share")
        paper = figures.DIRECT_PERCENT.get(result["paper"], (None,) * len(figures.DEVICES))
        return [label(result), number(None if share is None else 100.0 * share, "{:.1f}"),
                *(number(percent, "{:.1f}") for percent in paper)]

    head = ["sequence", "hybrid", *(f"paper, {device}" for device in figures.DEVICES)]
    return "## Frames by the direct tracker, %\n\n" + table(head, map(cells, results))


def ate_table(results):
    def cells(result):
        ours = [number(median(result, tracker, "ate_m"), "{:.4f}") for tracker in ("indirect", "hybrid")]
        return [label(result), *ours, *pairs(figures.ATE_M.get(result["paper"]), "{:.3f}")]

    head = ["sequence", "indirect only", "hybrid", *(f"paper, {device}: ORB / GLidE" for device in figures.DEVICES)]
    return "## ATE, RMSE in metres or the truth's unit\n\n" + table(head, map(cells, results))


def runs_table(results):
    """How the runs went: nothing above is hidden by a median."""
    def cells(result, tracker):
        of_tracker = result[tracker]
        medians = of_tracker["median"]
        tracked = medians["tracked_ratio"]
        return [label(result), tracker, str(result["patch"]), f"{of_tracker['succeeded']} of {len(of_tracker['runs'])}",
                number(medians["frames_in"], "{:.0f}"), number(medians["frames_dropped"], "{:.0f}"),
                number(None if tracked is None else 100.0 * tracked, "{:.1f}"),
                "; ".join(dict.fromkeys(of_tracker["failed"])) or NONE]

    head = ["sequence", "tracker", "patch", "runs", "frames", "dropped", "tracked, %", "failures"]
    return "## Runs\n\n" + table(head, (cells(r, tracker) for r in results for tracker in ("hybrid", "indirect")))


def backend(results):
    """What the direct tracker ran on, in words."""
    for result in results:
        if result["hybrid"]["backend"]:
            return " ".join(filter(None, (result["hybrid"]["backend"], result["hybrid"]["renderer"])))
    return "nothing"


def document(report):
    """All of it."""
    results = report["sequences"]
    options = report["options"]
    return "\n\n".join([
        "# The paper's tables",
        f"{report['machine']}; direct tracker on {backend(results)}; medians over up to {options['runs']} runs, "
        f"{options['levels']} levels, sensor pace, no rendering. The paper compares with ORB-SLAM2, we with our own "
        "indirect tracker alone.",
        time_table(results), gpu_table(results), share_table(results), ate_table(results), runs_table(results),
    ]) + "\n"
