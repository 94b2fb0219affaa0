"""Trajectories as glide-replay and glide-synth write them, and their alignment. Only the standard library."""
import math


def read_tum(path):
    """Timestamp (microseconds) -> (position, quaternion xyzw)."""
    poses = {}
    with open(path, encoding="utf-8") as text:
        for line in text:
            if line.startswith("#") or not line.strip():
                continue
            t, *values = (float(x) for x in line.split())
            poses[round(t * 1e6)] = (values[:3], values[3:7])
    return poses


def multiply(p, q):
    px, py, pz, pw = p
    qx, qy, qz, qw = q
    return [pw * qx + px * qw + py * qz - pz * qy, pw * qy - px * qz + py * qw + pz * qx,
            pw * qz + px * qy - py * qx + pz * qw, pw * qw - px * qx - py * qy - pz * qz]


def rotate(q, v):
    conjugate = [-q[0], -q[1], -q[2], q[3]]
    return multiply(multiply(q, [*v, 0.0]), conjugate)[:3]


def angle_deg(p, q):
    """Angle between two rotations, degrees."""
    dot = abs(sum(a * b for a, b in zip(p, q)))
    return math.degrees(2.0 * math.acos(min(1.0, dot)))


def mean(points):
    return [sum(p[i] for p in points) / len(points) for i in range(3)]


def difference(a, b):
    return [x - y for x, y in zip(a, b)]


def largest_eigenvector(matrix):
    """Of a symmetric 4x4 matrix, by cyclic Jacobi rotations."""
    a = [row[:] for row in matrix]
    v = [[float(i == j) for j in range(4)] for i in range(4)]
    for _ in range(50):
        for p in range(3):
            for q in range(p + 1, 4):
                if a[p][q] == 0.0:
                    continue
                theta = 0.5 * math.atan2(2.0 * a[p][q], a[q][q] - a[p][p])
                c, s = math.cos(theta), math.sin(theta)
                for row in (*a, *v):
                    row[p], row[q] = c * row[p] - s * row[q], s * row[p] + c * row[q]
                for k in range(4):
                    a[p][k], a[q][k] = c * a[p][k] - s * a[q][k], s * a[p][k] + c * a[q][k]
    best = max(range(4), key=lambda i: a[i][i])
    return [v[i][best] for i in range(4)]


class Similarity:
    """truth = scale * R * estimate + t, least squares over the timestamps that both have (Horn 1987)."""

    def __init__(self, truth, estimate):
        times = sorted(set(truth) & set(estimate))
        if len(times) < 3:
            raise ValueError("fewer than three poses in common")
        a, b = [truth[t][0] for t in times], [estimate[t][0] for t in times]
        mean_a, mean_b = mean(a), mean(b)
        a, b = [difference(p, mean_a) for p in a], [difference(p, mean_b) for p in b]
        s = [[sum(p[i] * q[j] for p, q in zip(b, a)) for j in range(3)] for i in range(3)]
        trace = s[0][0] + s[1][1] + s[2][2]
        skew = [s[1][2] - s[2][1], s[2][0] - s[0][2], s[0][1] - s[1][0]]
        n = [[s[i][j] + s[j][i] - (trace if i == j else 0.0) for j in range(3)] + [skew[i]] for i in range(3)]
        n.append([*skew, trace])
        self.q = largest_eigenvector(n)
        turned = [rotate(self.q, q) for q in b]
        self.scale = sum(x * y for p, q in zip(a, turned) for x, y in zip(p, q)) / sum(x * x for q in b for x in q)
        self.t = difference(mean_a, [self.scale * x for x in rotate(self.q, mean_b)])

    def __call__(self, pose):
        position, q = pose
        moved = [self.scale * x + t for x, t in zip(rotate(self.q, position), self.t)]
        return moved, multiply(self.q, q)


def error(truth, estimate):
    """(metres, degrees) between two poses in the same world."""
    return math.dist(truth[0], estimate[0]), angle_deg(truth[1], estimate[1])


def path_length(poses):
    points = [poses[t][0] for t in sorted(poses)]
    return sum(math.dist(a, b) for a, b in zip(points, points[1:]))
