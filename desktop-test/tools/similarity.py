"""Rotation, translation and scale between two sets of points, with the standard library alone.

Horn, "Closed-form solution of absolute orientation using unit quaternions", 1987.
"""
import dataclasses
import math

MIN_POINTS = 3
SQUARINGS = 40  # of a matrix: eigenvalues that differ by a millionth of a millionth are told apart


@dataclasses.dataclass(frozen=True)
class Similarity:
    """p -> scale * R p + translation."""

    scale: float
    q_xyzw: tuple
    translation: tuple

    def point(self, p):
        turned = rotate(self.q_xyzw, p)
        return tuple(self.scale * a + b for a, b in zip(turned, self.translation))

    def turn(self, q_xyzw):
        """The orientation of something whose orientation was q."""
        return multiply(self.q_xyzw, q_xyzw)


def multiply(a, b):
    """The product of two quaternions x y z w."""
    ax, ay, az, aw = a
    bx, by, bz, bw = b
    return (
        aw * bx + ax * bw + ay * bz - az * by,
        aw * by - ax * bz + ay * bw + az * bx,
        aw * bz + ax * by - ay * bx + az * bw,
        aw * bw - ax * bx - ay * by - az * bz,
    )


def rotate(q_xyzw, p):
    x, y, z, w = q_xyzw
    return multiply(multiply(q_xyzw, (*p, 0.0)), (-x, -y, -z, w))[:3]


def mean(points):
    return tuple(sum(axis) / len(points) for axis in zip(*points))


def centred(points, center):
    return [tuple(a - b for a, b in zip(point, center)) for point in points]


def horn_matrix(a, b):
    """Its eigenvector of the largest eigenvalue is the rotation from a to b, as w x y z."""
    s = [[sum(p[i] * q[j] for p, q in zip(a, b)) for j in range(3)] for i in range(3)]
    (xx, xy, xz), (yx, yy, yz), (zx, zy, zz) = s
    return [
        [xx + yy + zz, yz - zy, zx - xz, xy - yx],
        [yz - zy, xx - yy - zz, xy + yx, zx + xz],
        [zx - xz, xy + yx, -xx + yy - zz, yz + zy],
        [xy - yx, zx + xz, yz + zy, -xx - yy + zz],
    ]


def largest_eigenvector(matrix):
    """By squaring the matrix, made positive by a shift, until one direction is left."""
    shift = max(sum(abs(value) for value in row) for row in matrix) or 1.0
    power = [[value + (shift if i == j else 0.0) for j, value in enumerate(row)] for i, row in enumerate(matrix)]
    for _ in range(SQUARINGS):
        power = [[sum(a * b for a, b in zip(row, column)) for column in zip(*power)] for row in power]
        size = max(abs(value) for row in power for value in row)
        power = [[value / size for value in row] for row in power]
    column = max(zip(*power), key=lambda c: sum(v * v for v in c))
    length = math.sqrt(sum(v * v for v in column))
    return tuple(v / length for v in column)


def align(source, target):
    """The similarity that brings the source points closest to the target's; None for too few, or points in one place."""
    if len(source) < MIN_POINTS:
        return None
    center_source, center_target = mean(source), mean(target)
    a, b = centred(source, center_source), centred(target, center_target)
    spread = sum(v * v for p in a for v in p)
    if spread == 0.0:
        return None
    w, x, y, z = largest_eigenvector(horn_matrix(a, b))
    q = (x, y, z, w)
    scale = sum(sum(u * v for u, v in zip(rotate(q, p), r)) for p, r in zip(a, b)) / spread
    turned = rotate(q, center_source)
    return Similarity(scale, q, tuple(t - scale * c for t, c in zip(center_target, turned)))
