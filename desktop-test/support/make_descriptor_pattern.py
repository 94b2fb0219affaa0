#!/usr/bin/env python3
"""Writes core/feature/descriptor_pattern.cpp: the 256 intensity tests of the binary descriptor.

Candidates are isotropic Gaussian pairs (Calonder et al., "BRIEF", ECCV 2010, layout G II). They are ranked by how
well one bit tells patches apart and survives a second view of the same patch, and picked greedily so that no two
are strongly correlated (Rublee et al., "ORB", ICCV 2011, section 4.3). Training patches come from synthetic dead-leaves
images (Lee, Mumford, Huang, IJCV 2001), so the table depends on no picture. Needs numpy only; same seed, same table.

    python3 desktop-test/support/make_descriptor_pattern.py core/feature/descriptor_pattern.cpp
"""
import sys

import numpy as np

SEED = 20240607
TESTS = 256
RADIUS = 15  # px: the tests and the orientation disc
CANDIDATES = 16000
SHORT_LIST = 6000  # best candidates by quality, among which the greedy search picks
IMAGES = 30
IMAGE_SIZE = 320
CORNERS_PER_IMAGE = 120
HALF = 24  # px: half side of a training patch; holds RADIUS plus the blur
BLUR_SIGMA = 2.0  # px, as in the extractor


def dead_leaves(rng):
    """Opaque discs and rectangles with power-law sizes, painted back to front, slightly blurred."""
    size = IMAGE_SIZE
    image = np.full((size, size), rng.uniform(0, 255))
    ys, xs = np.mgrid[0:size, 0:size]
    for _ in range(900):
        radius = 4.0 * rng.uniform(0.003, 1.0) ** -0.5
        cx, cy, angle = rng.uniform(0, size), rng.uniform(0, size), rng.uniform(0, np.pi)
        u = (xs - cx) * np.cos(angle) + (ys - cy) * np.sin(angle)
        v = -(xs - cx) * np.sin(angle) + (ys - cy) * np.cos(angle)
        aspect = rng.uniform(0.3, 1.0)
        disc = u * u + (v / aspect) ** 2 < radius * radius
        box = (np.abs(u) < radius) & (np.abs(v) < radius * aspect)
        slope = rng.normal(0, 0.6, 2)
        shade = rng.uniform(0, 255) + slope[0] * u + slope[1] * v
        image = np.where(disc if rng.uniform() < 0.4 else box, shade, image)
    return np.clip(blur(image[None], rng.uniform(0.5, 1.2))[0], 0, 255)


def blur(stack, sigma):
    taps = np.exp(-0.5 * (np.arange(-3, 4) / sigma) ** 2)
    taps /= taps.sum()
    for axis in (1, 2):
        pad = [(0, 0), (0, 0), (0, 0)]
        pad[axis] = (3, 3)
        padded = np.pad(stack, pad, mode="edge")
        n = stack.shape[axis]
        stack = sum(t * np.take(padded, range(i, i + n), axis=axis) for i, t in enumerate(taps))
    return stack


def corners(rng, image):
    """Local maxima of the smaller eigenvalue of the structure tensor, strongest first with noise in the ranking."""
    gy, gx = np.gradient(image)
    xx, xy, yy = (blur((a * b)[None], 1.5)[0] for a, b in ((gx, gx), (gx, gy), (gy, gy)))
    score = 0.5 * (xx + yy) - np.sqrt(0.25 * (xx - yy) ** 2 + xy * xy)
    inner = score[1:-1, 1:-1]
    shifted = [score[1 + dy:-1 + dy or None, 1 + dx:-1 + dx or None][:inner.shape[0], :inner.shape[1]]
               for dy in (-1, 0, 1) for dx in (-1, 0, 1) if (dx, dy) != (0, 0)]
    peak = np.all([inner > s for s in shifted], axis=0) & (inner > 20)
    ys, xs = np.nonzero(peak)
    ys, xs = ys + 1, xs + 1
    margin = int(HALF * 1.5 + 3)
    inside = (np.minimum(xs, ys) > margin) & (np.maximum(xs, ys) < IMAGE_SIZE - margin)
    xs, ys = xs[inside], ys[inside]
    order = rng.permutation(len(xs))[:CORNERS_PER_IMAGE]
    return np.stack([xs[order], ys[order]], axis=1)


def views(rng, image, centers):
    """Patches around `centers`, each seen under a random rotation, scale, sub-pixel offset, gain and noise."""
    n = len(centers)
    grid = np.stack(np.meshgrid(np.arange(-HALF, HALF + 1), np.arange(-HALF, HALF + 1)), axis=-1)
    angle, scale = rng.uniform(0, 2 * np.pi, n), np.exp(rng.uniform(-0.13, 0.13, n))
    offset = rng.normal(0, 0.6, (n, 2))
    c, s = scale * np.cos(angle), scale * np.sin(angle)
    x = centers[:, 0, None, None] + offset[:, 0, None, None] + c[:, None, None] * grid[..., 0] - s[:, None, None] * grid[..., 1]
    y = centers[:, 1, None, None] + offset[:, 1, None, None] + s[:, None, None] * grid[..., 0] + c[:, None, None] * grid[..., 1]
    x0, y0 = np.floor(x).astype(int), np.floor(y).astype(int)
    fx, fy = x - x0, y - y0
    patch = ((image[y0, x0] * (1 - fx) + image[y0, x0 + 1] * fx) * (1 - fy) +
             (image[y0 + 1, x0] * (1 - fx) + image[y0 + 1, x0 + 1] * fx) * fy)
    gain = rng.uniform(0.7, 1.3, (n, 1, 1))
    return np.clip(patch * gain + rng.normal(0, 3.0, patch.shape), 0, 255)


def orientations(patches):
    ys, xs = np.mgrid[-HALF:HALF + 1, -HALF:HALF + 1]
    disc = xs * xs + ys * ys <= RADIUS * RADIUS
    return np.arctan2((patches * ys * disc).sum((1, 2)), (patches * xs * disc).sum((1, 2)))


def bits(patches, tests):
    """Answers of the tests, turned by each patch's own orientation, on the blurred patches."""
    smooth = np.rint(blur(patches, BLUR_SIGMA))
    out = np.empty((len(patches), len(tests)), dtype=bool)
    points = tests.reshape(-1, 2, 2)
    for i, angle in enumerate(orientations(patches)):
        c, s = np.cos(angle), np.sin(angle)
        x = np.rint(c * points[..., 0] - s * points[..., 1]).astype(int) + HALF
        y = np.rint(s * points[..., 0] + c * points[..., 1]).astype(int) + HALF
        value = smooth[i][y, x]
        out[i] = value[:, 0] < value[:, 1]
    return out


def candidates(rng):
    sigma = (2 * RADIUS + 1) / 5.0
    tests = np.rint(rng.normal(0, sigma, (8 * CANDIDATES, 4))).astype(int)
    a, b = tests[:, :2], tests[:, 2:]
    inside = ((a * a).sum(1) <= RADIUS * RADIUS) & ((b * b).sum(1) <= RADIUS * RADIUS)
    long_enough = ((a - b) ** 2).sum(1) >= 9
    return np.unique(tests[inside & long_enough], axis=0)


def pick(tests, first, second):
    mean, flips = first.mean(0), (first != second).mean(0)
    order = np.argsort(0.5 * flips - 2 * mean * (1 - mean), kind="stable")[:SHORT_LIST]
    tests, mean, flips = tests[order], mean[order], flips[order]
    normal = ((first[:, order] - mean) / np.sqrt(mean * (1 - mean))).astype(np.float32)
    correlation = np.abs(normal.T @ normal) / len(first)
    for limit in np.arange(0.10, 1.0, 0.02):
        worst = np.zeros(len(tests))
        chosen = []
        for i in range(len(tests)):
            if worst[i] < limit and len(chosen) < TESTS:
                chosen.append(i)
                worst = np.maximum(worst, correlation[i])
        if len(chosen) == TESTS:
            print(f"correlation limit {limit:.2f}, bit mean {mean[chosen].mean():.3f}, flip rate {flips[chosen].mean():.3f}")
            return tests[chosen]
    raise SystemExit("too few candidates")


def write(path, tests):
    rows = ["    {{" + "}}, {{".join(", ".join(str(v) for v in t) for t in tests[i:i + 4]) + "}},"
            for i in range(0, TESTS, 4)]
    with open(path, "w", encoding="ascii") as out:
        out.write('#include "feature/descriptor_pattern.h"\n\nnamespace glide {\n\n'
                  "// Made by desktop-test/support/make_descriptor_pattern.py. Do not edit.\n// clang-format off\n"
                  f"const std::array<DescriptorTest, {TESTS}> kDescriptorPattern{{{{\n")
        out.write("\n".join(rows).replace("{{", "{").replace("}}", "}"))
        out.write("\n}};\n// clang-format on\n\n}  // namespace glide\n")


def main():
    rng = np.random.default_rng(SEED)
    tests = candidates(rng)
    tests = tests[rng.permutation(len(tests))[:CANDIDATES]]
    first, second = [], []
    for _ in range(IMAGES):
        image = dead_leaves(rng)
        centers = corners(rng, image)
        first.append(bits(views(rng, image, centers), tests))
        second.append(bits(views(rng, image, centers), tests))
    first, second = np.concatenate(first), np.concatenate(second)
    print(f"{len(first)} patches, {len(tests)} candidates")
    write(sys.argv[1], pick(tests, first, second))


if __name__ == "__main__":
    main()
