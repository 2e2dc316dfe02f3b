"""Fresh shapes to fill, by families and seed: nothing of them is in the judge's folder, and nothing is tuned to it.

fresh(seed, each) -> [(name, polygon)] with a rake of width 1; own() -> the shapes drawn by hand in bench/shapes. A polygon is a dict of outer and
holes as the fill command reads it. Needs shapely (letters and rings grow from their middle lines).
"""
import json, math, random
from pathlib import Path
from shapely.geometry import LineString, Polygon
from shapely.ops import unary_union
from shapely.affinity import rotate

# Middle lines on a field 4 wide and 6 high.
LETTERS = {
    "A": [[(0, 0), (2, 6), (4, 0)], [(0.8, 2), (3.2, 2)]],
    "E": [[(4, 0), (0, 0), (0, 6), (4, 6)], [(0, 3), (3, 3)]],
    "K": [[(0, 0), (0, 6)], [(4, 6), (0, 2.6), (4, 0)]],
    "M": [[(0, 0), (0, 6), (2, 2.5), (4, 6), (4, 0)]],
    "R": [[(0, 0), (0, 6), (2.6, 6), (4, 5.2), (4, 3.8), (2.6, 3), (0, 3)], [(1.6, 3), (4, 0)]],
    "S": [[(4, 5.2), (3, 6), (1, 6), (0, 5), (0, 4), (1, 3), (3, 3), (4, 2), (4, 1), (3, 0), (1, 0), (0, 0.8)]],
    "X": [[(0, 0), (4, 6)], [(0, 6), (4, 0)]],
    "8": [[(2, 3), (0.4, 3.8), (0.4, 5.4), (2, 6), (3.6, 5.4), (3.6, 3.8), (2, 3), (0, 2.2), (0, 0.8), (2, 0), (4, 0.8), (4, 2.2), (2, 3)]],
}


def written(shape):
    """the largest part, as the command reads it"""
    if shape.geom_type != "Polygon": shape = max(shape.geoms, key=lambda g: g.area)
    ring = lambda r: [[round(x, 4), round(y, 4)] for x, y in list(r.coords)[:-1]]
    return {"outer": ring(shape.exterior), "holes": [ring(i) for i in shape.interiors]}


def turned(shape, r):
    return rotate(shape, r.uniform(0, 360), origin=(0, 0))


def letter(r):
    name = r.choice(sorted(LETTERS))
    size, thick, round_ends = r.uniform(3, 5), r.uniform(2, 4.5), r.random() < 0.3
    lines = [LineString([(size * x, size * y) for x, y in line]) for line in LETTERS[name]]
    style = dict(cap_style=1, join_style=1, resolution=8) if round_ends else dict(cap_style=3, join_style=2, mitre_limit=2)
    return turned(unary_union([line.buffer(thick / 2, **style) for line in lines]), r)


def star(r):
    n, far = r.randint(4, 9), r.uniform(7, 14)
    near = far * r.uniform(0.35, 0.7)
    return turned(Polygon([((far, near)[k % 2] * math.cos(math.pi * k / n), (far, near)[k % 2] * math.sin(math.pi * k / n)) for k in range(2 * n)]), r)


def wavy(r, radius, share, points=90, centre=(0, 0)):
    waves = [(k, r.uniform(-1, 1) / k, r.uniform(0, 2 * math.pi)) for k in range(2, 7)]
    at = lambda t: radius * (1 + share * sum(a * math.cos(k * t + p) for k, a, p in waves))
    return Polygon([(centre[0] + at(t) * math.cos(t), centre[1] + at(t) * math.sin(t)) for t in (2 * math.pi * j / points for j in range(points))])


def blob(r):
    shape, holes = wavy(r, r.uniform(7, 14), 0.5), r.randint(1, 4)
    for _ in range(50):
        if len(shape.interiors) == holes: break
        x0, y0, x1, y1 = shape.bounds
        hole = wavy(r, r.uniform(0.8, 2.5), 0.3, 24, (r.uniform(x0, x1), r.uniform(y0, y1)))
        if shape.buffer(-2).contains(hole): shape = shape.difference(hole)
    return shape


def comb(r):
    teeth, wide, gap, long = r.randint(3, 7), r.uniform(1.2, 4.5), r.uniform(1, 4), r.uniform(6, 14)
    back = r.uniform(1.5, 5)
    points, x = [(0, 0)], 0
    for k in range(teeth):
        points += [(x, back + long), (x + wide, back + long), (x + wide, back)] if k else [(0, back + long), (wide, back + long), (wide, back)]
        x += wide + gap
        if k + 1 < teeth: points.append((x, back))
    points[-1] = (x - gap, 0)
    return turned(Polygon(points), r)


def corridors(r):
    a, b, long = r.uniform(1.6, 6), r.uniform(1.6, 6), r.uniform(10, 20)
    box = lambda x, y, u, v: Polygon([(x, y), (x + u, y), (x + u, y + v), (x, y + v)])
    middle = long / 2
    shape = {"L": [box(0, 0, long, a), box(0, 0, b, long)],
             "T": [box(0, 0, long, a), box(middle - b / 2, 0, b, long)],
             "H": [box(0, 0, a, long), box(long, 0, a, long), box(0, middle - b / 2, long, b)],
             "U": [box(0, 0, a, long), box(long, 0, a, long), box(0, 0, long, b)]}[r.choice("LTHU")]
    return turned(unary_union(shape), r)


def wedge(r):
    angle, long = math.radians(r.uniform(12, 120)), r.uniform(12, 25)
    return turned(Polygon([(0, 0), (long, 0), (r.uniform(0.7, 1) * long * math.cos(angle), r.uniform(0.7, 1) * long * math.sin(angle))]), r)


def ring(r):
    if r.random() < 0.5: return LineString(wavy(r, r.uniform(6, 12), 0.2).exterior.coords).buffer(r.uniform(0.8, 3.2))
    side, thick = r.uniform(10, 20), r.uniform(1.6, 6)
    square = lambda s: Polygon([(-s, -s), (s, -s), (s, s), (-s, s)])
    return turned(square(side / 2 + thick).difference(square(side / 2)), r)


def ragged(points):
    def make(r):
        """rugged at every scale, as outlines traced from pictures are"""
        radius = r.uniform(8, 12) * (1 + math.log10(points) / 3)
        waves = [(k, 0.5 / k ** 1.3 * r.uniform(-1, 1), r.uniform(0, 2 * math.pi)) for k in range(2, max(4, points // 4))]
        at = [radius * (1 + sum(1.6 * a * math.cos(k * 2 * math.pi * j / points + p) for k, a, p in waves)) for j in range(points)]
        return Polygon([(at[j] * math.cos(2 * math.pi * j / points), at[j] * math.sin(2 * math.pi * j / points)) for j in range(points)]).buffer(0)
    return make


def holes50(r):
    long, high = r.uniform(45, 65), r.uniform(35, 50)
    shape = Polygon([(0, 0), (long, 0), (long, high), (0, high)])
    for k in range(50):
        x, y = (k % 10 + 0.5) * long / 10, (k // 10 + 0.5) * high / 5
        size = r.uniform(0.5, 1.2)
        shape = shape.difference(wavy(r, size, 0.2, r.choice([3, 4, 12, 24]), (x + r.uniform(-0.6, 0.6), y + r.uniform(-1.5, 1.5))))
    return shape


FAMILIES = {"letter": letter, "star": star, "blob": blob, "comb": comb, "corridors": corridors, "wedge": wedge, "ring": ring,
            "ragged 12": ragged(12), "ragged 400": ragged(400), "ragged 5000": ragged(5000), "50 holes": holes50}


def fresh(seed=4, each=2):
    """each: shapes of a family; of the two large families one"""
    shapes = []
    for name, family in FAMILIES.items():
        r = random.Random(f"{seed} {name}")
        for k in range(max(1, each // 2) if name in ("ragged 5000", "50 holes") else each):
            shapes.append((f"{name} #{k + 1}", written(family(r))))
    return shapes


def random_region(seed):
    """a round outline with one to three holes, small enough to be judged by the thousand"""
    r = random.Random(seed)
    shape = wavy(r, r.uniform(4, 8), r.uniform(0.1, 0.5), r.choice([9, 16, 60]))
    for _ in range(r.randint(1, 3)):
        x0, y0, x1, y1 = shape.bounds
        hole = wavy(r, r.uniform(0.5, 1.5), 0.3, r.choice([3, 5, 20]), (r.uniform(x0, x1), r.uniform(y0, y1)))
        if shape.buffer(-1.6).contains(hole): shape = shape.difference(hole)
    return written(shape)


def own():
    return [(p.stem, json.loads(p.read_text())["polygon"]) for p in sorted((Path(__file__).parent / "shapes").glob("*.json"))]
