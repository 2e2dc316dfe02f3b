"""The converter on random smooth rake paths: how far the rake is off when the robot drives what came out."""
import math, random

from harness import run


def rake_path(seed, most, metres, fine=0.001):
    """points `fine` apart along a path whose curvature runs linearly between random values every half metre"""
    rng, x, y, heading, points = random.Random(seed), 0.0, 0.0, rng_heading(seed), []
    knots = [rng.uniform(-most, most) for _ in range(int(metres / 0.5) + 2)]
    for i in range(int(metres / fine) + 1):
        points.append((x, y))
        s = i * fine / 0.5
        k = knots[int(s)] + (s - int(s)) * (knots[int(s) + 1] - knots[int(s)])
        middle = heading + k * fine / 2
        x, y, heading = x + fine * math.cos(middle), y + fine * math.sin(middle), heading + k * fine
    return points


def rng_heading(seed): return random.Random(seed + 1000).uniform(-math.pi, math.pi)


def convert(program, folder, points):
    source = folder / "random.csv"
    source.write_text("x,y,pins\n" + "".join(f"{x:.9f},{y:.9f},127\n" for x, y in points))
    code, out, err, cpu, _ = run([program, "convert", source, "--robot", "beachbot", "-o", "-", "-q"])
    if code != 0: raise RuntimeError(err)
    return [list(map(float, line.split(",")[:4])) for line in out.split()[1:]], cpu


def on_arc(a, b, t):
    """pose of a robot that drives an arc from row to row"""
    turn, chord = math.remainder(b[2] - a[2], 2 * math.pi), math.hypot(b[0] - a[0], b[1] - a[1])
    ux, uy, bulge = (b[0] - a[0]) / chord, (b[1] - a[1]) / chord, chord * turn / 2 * t * (1 - t)
    return a[0] + t * chord * ux + bulge * uy, a[1] + t * chord * uy - bulge * ux, a[2] + t * turn


def by_curvature(a, b, t):
    """the same of one that steers by the rows' curvatures: cubic Hermite in place and heading"""
    turn, chord = math.remainder(b[2] - a[2], 2 * math.pi), math.hypot(b[0] - a[0], b[1] - a[1])
    s = chord * (1 + turn * turn / 24)
    begin, leave, end, come = 2 * t**3 - 3 * t * t + 1, t**3 - 2 * t * t + t, 3 * t * t - 2 * t**3, t**3 - t * t
    return (begin * a[0] + leave * s * math.cos(a[2]) + end * b[0] + come * s * math.cos(b[2]),
            begin * a[1] + leave * s * math.sin(a[2]) + end * b[1] + come * s * math.sin(b[2]), a[2] + leave * a[3] * s + end * turn + come * b[3] * s)


def rake_error(rows, truth, step, pose, offset=0.2, parts=5):
    """metres: the rake of a robot that drives from row to row by `pose`, off the true path; `step` true points a row"""
    worst = 0.0
    for i, (a, b) in enumerate(zip(rows, rows[1:])):
        if a[:2] == b[:2]: continue
        near = truth[max(0, (i - 1) * step):(i + 2) * step + 1]
        for k in range(parts):
            x, y, theta = pose(a, b, k / parts)
            qx, qy = x - offset * math.cos(theta), y - offset * math.sin(theta)
            worst = max(worst, min(to_segment(qx, qy, p, q) for p, q in zip(near, near[1:])))
    return worst


def to_segment(x, y, p, q):
    dx, dy = q[0] - p[0], q[1] - p[1]
    t = max(0.0, min(1.0, ((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy)))
    return math.hypot(x - p[0] - t * dx, y - p[1] - t * dy)


def rows(program, folder, seeds=range(5), offset=0.2):
    table = []
    for bend in (0.5, 0.8, 0.95):
        off = {(pose, centimetres): 0.0 for pose in (on_arc, by_curvature) for centimetres in (1, 5)}
        for seed in seeds:
            truth = rake_path(seed, bend / offset, 8)
            for pose, centimetres in off:
                step = 10 * centimetres
                converted, _ = convert(program, folder, truth[::step])
                off[pose, centimetres] = max(off[pose, centimetres], 100 * rake_error(converted, truth, step, pose))
        table.append([f"abs(curvature) up to {bend} / L"] + [f"{worst:.4f}" for worst in off.values()])
    _, cpu = convert(program, folder, rake_path(1, 0.5 / offset, 1000, 0.01)[:100_000])
    return table, cpu
