"""The suites: each renders or copies one sequence per seed, replays it and returns a row of its table."""
import os
import subprocess
import sys

import poses

IMAGES = ("--size", "320x240", "--noise", "2", "--overwrite")
RELOCALISED_WITHIN = 15  # frames
WRONG_M, WRONG_DEG = 0.05, 2.0  # a relocalisation that is off by more is wrong
AFTER = 90  # frames after the camera is back
BRICK_M = 0.3  # a frame of a facade that is off by more is one brick further


def kidnap_plan(seed):
    """Motion, first frame without sight, their number, what is seen instead."""
    motion = ("orbit", "handheld", "sweep")[seed % 3]
    return motion, 220 + 37 * seed % 100, 10 + 13 * seed % 51, ("black", "foreign")[seed % 2]


def kidnap_sequence(tools, seed):
    motion, begin, length, view = kidnap_plan(seed)
    end = begin + length
    return tools.render(f"kidnap_{seed}", "--seed", str(seed), "--motion", motion, "--frames", str(end + AFTER),
                        "--kidnap", f"{begin}:{end}:{view}", *IMAGES)


def kidnap(tools, seed):
    motion, begin, length, view = kidnap_plan(seed)
    end = begin + length
    run = tools.replay(f"kidnap_{seed}", kidnap_sequence(tools, seed))
    before = {t: pose for t, pose in run.live.items() if t < run.time(begin)}
    to_truth = poses.Similarity(run.truth, before)
    errors = {}  # of the tracked frames after the return
    for frame in range(end, len(run.frames)):
        if run.is_tracked(frame):
            errors[frame] = poses.error(run.truth[run.time(frame)], to_truth(run.live[run.time(frame)]))
    in_the_dark = sum(run.is_tracked(frame) for frame in range(begin, end))
    wrong = [frame for frame, (metres, degrees) in errors.items() if metres > WRONG_M or degrees > WRONG_DEG]
    first = min(errors, default=None)
    return {
        "seed": seed, "motion": motion, "view": view, "frames without sight": length,
        "tracked without sight": in_the_dark,
        "relocalised after": None if first is None else first - end + 1,
        "error m": None if first is None else errors[first][0],
        "error deg": None if first is None else errors[first][1],
        "worst m": max((e[0] for e in errors.values()), default=None),
        "first wrong frame": min(wrong, default=None),
        "resets": run.stats["map"]["resets"],
        "ok": first is not None and first - end < RELOCALISED_WITHIN and run.stats["map"]["resets"] == 0,
        "wrong": bool(wrong) or in_the_dark > 0,
    }


def loop_sequence(tools, seed):
    scene = "corridor" if seed % 2 else "hall"
    return scene, tools.render(f"loop_{seed}", "--seed", str(seed), "--scene", scene, "--motion", "walk", "--frames", "0",
                               *IMAGES)


def loops(tools, seed):
    scene, source = loop_sequence(tools, seed)
    closed = tools.replay(f"loop_{seed}", source)
    opened = tools.replay(f"loop_{seed}_off", source, "--set", "loop.closing=off")
    with_m, without_m = closed.ate(), opened.ate()
    return {
        "seed": seed, "scene": scene, "frames": len(closed.frames), "path m": poses.path_length(closed.truth),
        "lost frames": closed.lost_frames(), "loops closed": closed.stats["map"]["loops_closed"],
        "ATE m": with_m, "ATE m without": without_m,
        "ratio": with_m / without_m if with_m and without_m else None,
        "keyframes": closed.stats["map"]["keyframes"], "peak RSS MB": closed.stats["memory"]["peak_rss_mb"],
        "ok": closed.stats["map"]["loops_closed"] > 0,
    }


def facade_sequence(tools, seed):
    return tools.render(f"facade_{seed}", "--seed", str(seed), "--scene", "arcade", "--motion", "walk", "--frames", "0",
                        *IMAGES)


def errors_when_tracked(run, right_m):
    """Frame -> metres off the truth, of the tracked frames, after the similarity that fits those that are right."""
    tracked = {i: run.time(i) for i in range(len(run.frames)) if run.is_tracked(i)}
    right = dict(tracked)
    for _ in range(10):  # a few rounds settle which frames are right
        to_truth = poses.Similarity(run.truth, {t: run.live[t] for t in right.values()})
        errors = {i: poses.error(run.truth[t], to_truth(run.live[t]))[0] for i, t in tracked.items()}
        limit = max(right_m, sorted(errors.values())[len(errors) // 2])
        right = {i: tracked[i] for i, metres in errors.items() if metres <= limit}
    return errors


def facades(tools, seed):
    run = tools.replay(f"facade_{seed}", facade_sequence(tools, seed))
    errors = errors_when_tracked(run, BRICK_M)
    wrong = [i for i, metres in errors.items() if metres > BRICK_M]
    return {
        "seed": seed, "masonry": "repeated" if seed % 2 else "random", "frames": len(run.frames),
        "path m": poses.path_length(run.truth), "lost frames": run.lost_frames(),
        "loops closed": run.stats["map"]["loops_closed"], "relocalisations": run.stats["map"]["relocalisations"],
        "first pose": run.stats["first_pose_index"], "ATE m": run.ate(), "worst m": max(errors.values()),
        "tracked but wrong": len(wrong), "first wrong frame": min(wrong, default=None),
        "ok": run.stats["map"]["loops_closed"] == 0 and not wrong,
    }


MAKE_VARIANT = os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "e2e", "make_variant.py")
REAL = ("desk_fisheye_400", "euroc_MH01_5s-21s")
DARK = 60  # frames in the middle


def blackout(tools, name):
    """The same sequence with its middle frames black, against the undisturbed one."""
    source = os.path.join(tools.data, name)
    undisturbed = tools.replay(f"{name}", source)
    begin = (len(undisturbed.frames) - DARK) // 2
    copy = os.path.join(tools.out, "sequences", f"{name}_blackout")
    if not os.path.exists(copy):
        subprocess.run([sys.executable, MAKE_VARIANT, source, copy, "--blackout", f"{begin}:{begin + DARK}"], check=True)
    run = tools.replay(f"{name}_blackout", copy)
    back = next((i for i in range(begin + DARK, len(run.frames)) if run.is_tracked(i)), None)
    lost_later = sum(not run.is_tracked(i) for i in range(back, len(run.frames))) if back is not None else None
    return {
        "sequence": name, "black": f"{begin} to {begin + DARK - 1}", "of": len(run.frames),
        "tracked in the dark": sum(run.is_tracked(i) for i in range(begin, begin + DARK)),
        "tracked again after": None if back is None else back - begin - DARK + 1,
        "lost later": lost_later, "resets": run.stats["map"]["resets"],
        "ATE m": run.ate(), "undisturbed": undisturbed.ate(), "ratio": run.ate() / undisturbed.ate(),
        "ok": lost_later == 0 and run.stats["map"]["resets"] == 0 and run.ate() <= 1.5 * undisturbed.ate(),
    }
