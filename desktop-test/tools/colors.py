"""The colours of trackers, the same as in the renderers and the report (core/include/glide/render_types.h)."""

DIRECT, INDIRECT, TRUTH = (255, 140, 0), (0, 69, 170), (0, 150, 105)


def of(tracker):
    return DIRECT if tracker == "direct" else INDIRECT


def share(color):
    """From 0 to 1."""
    return tuple(value / 255 for value in color)


def strips(run):
    """[(poses, colours)] of the stretches of the trajectory between which no frame was lost."""
    trackers, placed = run.trackers(), {pose.t_ns: pose for pose in run.trajectory}
    stretches, is_open = [], False
    for frame in run.frames:
        if frame.t_ns in placed:
            if not is_open:
                stretches.append(([], []))
            stretches[-1][0].append(placed[frame.t_ns])
            stretches[-1][1].append(of(trackers[frame.t_ns]))
        is_open = frame.t_ns in placed
    return [stretch for stretch in stretches if len(stretch[0]) > 1]
