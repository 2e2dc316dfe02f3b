"""Fresh drawings for the simulate section, by family and seed: areas with holes, stars, lines with corners, smooth lines, bands, and all of them mixed.

fresh(folder, seed, each) -> paths of SVG files in `folder`. Units are about centimetres on 14 x 14 m. Every shape has a cell of the sheet for itself,
so that what is measured is how a shape is drawn, not how two of them run into each other.
"""
import math, random

SHEET = 1400
WIDTHS = (1, 3, 5, 8)  # of strokes: 1, 3, 5 and 7 pins of a beachbot


def path(rings, style, smooth=False):
    written = " ".join((curve if smooth else corners)(points, closed) for points, closed in rings)
    return f'<path d="{written}" fill-rule="evenodd" {style}/>'


def corners(points, closed): return "M" + " L".join(f"{x:.2f},{y:.2f}" for x, y in points) + (" Z" if closed else "")


def curve(points, closed):
    """cubics through the points (Catmull and Rom 1974)"""
    n = len(points)
    at = lambda k: points[k % n] if closed else points[min(max(k, 0), n - 1)]
    text = f"M{points[0][0]:.2f},{points[0][1]:.2f}"
    for k in range(n if closed else n - 1):
        (ax, ay), (bx, by), (cx, cy), (dx, dy) = (at(k + i) for i in (-1, 0, 1, 2))
        text += f" C{bx + (cx - ax) / 6:.2f},{by + (cy - ay) / 6:.2f} {cx - (dx - bx) / 6:.2f},{cy - (dy - by) / 6:.2f} {cx:.2f},{cy:.2f}"
    return text + (" Z" if closed else "")


def line_style(r): return f'fill="none" stroke="black" stroke-width="{r.choice(WIDTHS)}"'


AREA = 'fill="black"'


def wavy(r, centre, radius, share, points=72):
    waves = [(k, r.uniform(-1, 1) / k, r.uniform(0, 2 * math.pi)) for k in range(2, 6)]
    at = lambda t: radius * (1 + share * sum(a * math.cos(k * t + p) for k, a, p in waves))
    return [(centre[0] + at(t) * math.cos(t), centre[1] + at(t) * math.sin(t)) for t in (2 * math.pi * j / points for j in range(points))]


def blob(r, centre, size):
    """up to three holes, in thirds of the outline's own circle"""
    rings, start = [(wavy(r, centre, 0.75 * size, 0.25), True)], r.uniform(0, 2 * math.pi)
    for k in range(r.randint(0, 3)):
        t, far = start + 2 * math.pi * k / 3, 0.36 * size
        rings.append((wavy(r, (centre[0] + far * math.cos(t), centre[1] + far * math.sin(t)), r.uniform(0.08, 0.16) * size, 0.3, 24), True))
    return path(rings, AREA)


def star(r, centre, size):
    n, start, near = r.randint(4, 9), r.uniform(0, 2 * math.pi), r.uniform(0.4, 0.75)
    turn = lambda k: start + math.pi * k / n
    return path([([(centre[0] + (1, near)[k % 2] * size * math.cos(turn(k)), centre[1] + (1, near)[k % 2] * size * math.sin(turn(k))) for k in range(2 * n)], True)], AREA)


def band(r, centre, size):
    """a ring of even breadth, or a bar"""
    if r.random() < 0.5:
        outer, inner = size, size - r.uniform(50, 120)
        ring = lambda radius: [(centre[0] + radius * math.cos(2 * math.pi * k / 96), centre[1] + radius * math.sin(2 * math.pi * k / 96)) for k in range(96)]
        return path([(ring(outer), True), (ring(inner), True)], AREA)
    t, half = r.uniform(0, math.pi), r.uniform(25, 60)
    along, across = (size * math.cos(t), size * math.sin(t)), (-half * math.sin(t), half * math.cos(t))
    return path([([(centre[0] + a * along[0] + b * across[0], centre[1] + a * along[1] + b * across[1]) for a, b in ((-1, -1), (1, -1), (1, 1), (-1, 1))], True)], AREA)


def zigzag(r, centre, size):
    """corners of all angles on the way round or across the cell"""
    n, closed = r.randint(4, 8), r.random() < 0.3
    if closed: points = [(centre[0] + far * math.cos(t), centre[1] + far * math.sin(t)) for k in range(n) for far, t in [(r.uniform(0.5, 1) * size, 2 * math.pi * (k + r.uniform(-0.3, 0.3)) / n)]]
    else: points = [(centre[0] + size * (2 * k / (n - 1) - 1), centre[1] + r.uniform(-1, 1) * size) for k in range(n)]
    return path([(points, closed)], line_style(r))


def smooth(r, centre, size):
    if r.random() < 0.3: return path([(wavy(r, centre, 0.75 * size, 0.25, 12), True)], line_style(r), True)
    n = r.randint(4, 6)
    return path([([(centre[0] + size * (2 * k / (n - 1) - 1), centre[1] + r.uniform(-0.7, 0.7) * size) for k in range(n)], False)], line_style(r), True)


FAMILIES = {"blobs": ([blob], 2), "stars": ([star], 3), "bands": ([band], 3), "zigzags": ([zigzag], 2), "smooth": ([smooth], 2),
            "mixed": ([blob, star, band, zigzag, smooth], 3)}


def drawing(r, shapes, side):
    cell = SHEET / side
    body = "\n".join(r.choice(shapes)(r, ((i + 0.5) * cell, (j + 0.5) * cell), r.uniform(0.36, 0.44) * cell) for j in range(side) for i in range(side))
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="{SHEET}" height="{SHEET}" viewBox="0 0 {SHEET} {SHEET}">\n{body}\n</svg>\n'


def fresh(folder, seed=11, each=2):
    paths = []
    for name, (shapes, side) in FAMILIES.items():
        r = random.Random(f"{seed} {name}")
        for k in range(each):
            paths.append(folder / f"{name} {k + 1}.svg")
            paths[-1].write_text(drawing(r, shapes, side))
    return paths
