"""What a shape allows, measured apart from the program: everything the goals of the fill table are conditional on.

measured(polygon, w) -> Shape. The polygon is a valid shapely (multi)polygon, w the rake's width. Needs shapely, numpy and scipy.

Medial axis: the Voronoi edges of the outline, thinned by w/20 and sampled every w/10, that lie inside. Each edge knows its two feet (the samples
it is equally far from), so T = twice the distance to them, and the angle between the feet seen from the edge: 180 degrees between the sides of
a corridor, 180 - a on the branch into a corner of a degrees. Branches into corners of 60 degrees and more are left out by that angle (Foskey,
Lin and Manocha 2003), and so is what is narrower than the rake: rings bend round a corner, they do not pass it in ceil(T/w) lines.
"""
from dataclasses import dataclass
import math
import numpy as np
from scipy.spatial import Voronoi
from shapely.geometry import LineString, Point, Polygon
from shapely.ops import polylabel, unary_union
from shapely.prepared import prep

CORNER = 120  # degrees between the feet: less is the branch into a corner
CORRIDOR = 150  # more is a corridor, or a tip under 30 degrees
PARALLEL = 165  # more is a ridge that a spine serves
ALMOST = 0.01  # of w: a corridor that is wider than k passes by less is served by k


@dataclass
class Shape:
    area: float
    kept: float  # share that an opening by a disc of 3 w in diameter leaves
    floor: float  # overdraw of whole passes in corridors that do not fit them
    tips: int  # convex corners under 45 degrees
    narrow: int  # stretches of corridor under 1.5 w
    leaves: int  # of the nesting forest of rings and spines
    widest: float  # T of the largest disc, in w

    @property
    def wide(self): return self.kept >= 0.99

    @property
    def plain(self): return self.tips == 0 and self.narrow == 0


def parts_of(geometry):
    if geometry.is_empty: return []
    if geometry.geom_type == "Polygon": return [geometry]
    return [g for g in getattr(geometry, "geoms", []) if g.geom_type == "Polygon" and g.area > 0]


def thinned(polygon, tolerance):
    plain = polygon.simplify(tolerance)
    return plain if plain.is_valid and not plain.is_empty else polygon


def rings_of(geometry):
    return [r for p in parts_of(geometry) for r in [p.exterior, *p.interiors]]


def sampled(ring, step):
    """-> points along the ring, and for each the two edges it may lie on: (n, 2), (n, 2, 2, 2)"""
    c = np.asarray(ring.coords)
    points, edges = [], []
    for i, (a, b) in enumerate(zip(c[:-1], c[1:])):
        n = max(1, math.ceil(math.dist(a, b) / step))
        points.append(a + (b - a) * (np.arange(n) / n)[:, None])
        before = c[i - 1] if i else c[-2]
        edges.append(np.array([[[before, a] if k == 0 else [a, b], [a, b]] for k in range(n)]))
    return np.concatenate(points), np.concatenate(edges)


def foot_on(edges, p):
    a, b = edges[:, :, 0], edges[:, :, 1]
    u = b - a
    t = np.clip(((p[:, None] - a) * u).sum(2) / np.maximum((u * u).sum(2), 1e-300), 0, 1)
    feet = a + t[:, :, None] * u
    nearer = np.hypot(*(feet - p[:, None]).transpose(2, 0, 1)).argmin(1)
    return feet[np.arange(len(p)), nearer]


def medial_axis(polygon, w):
    """-> arrays over Voronoi edges inside: end points (n, 2, 2), T, angle between the feet in degrees"""
    plain = thinned(polygon, w / 20)
    points, edges = (np.concatenate(x) for x in zip(*(sampled(r, w / 10) for r in rings_of(plain))))
    points, first = np.unique(points, axis=0, return_index=True)
    edges = edges[first]
    voronoi = Voronoi(points)
    pairs, ends = np.asarray(voronoi.ridge_points), np.asarray(voronoi.ridge_vertices)
    finite = (ends >= 0).all(1)
    pairs, ends = pairs[finite], ends[finite]
    lines = voronoi.vertices[ends]
    middle = lines.mean(axis=1)
    near = np.hypot(*(points[pairs[:, 0]] - middle).T) < np.ptp(points, axis=0).max()
    pairs, lines, middle = pairs[near], lines[near], middle[near]
    a, b = foot_on(edges[pairs[:, 0]], middle) - middle, foot_on(edges[pairs[:, 1]], middle) - middle
    ra, rb = np.hypot(*a.T), np.hypot(*b.T)
    angle = np.degrees(np.arccos(np.clip((a * b).sum(1) / np.maximum(ra * rb, 1e-300), -1, 1)))
    steep = angle > 90  # the rest are branches into wide corners, and edges between neighbouring samples
    inside = prep(plain)
    steep[steep] = [inside.contains(Point(m)) for m in middle[steep]]
    return lines[steep], ra[steep] + rb[steep], angle[steep]


def floor_of(length, T, angle, w, widest):
    use = (angle >= CORNER) & (T >= w)
    if length[use].sum() < w / 20: T, length, use = np.array([widest]), np.ones(1), np.array([True])  # a disc: its centre alone
    T = T[use] / w
    return float(np.average(np.maximum(0, np.ceil(T - ALMOST) - T) / T, weights=length[use]))


def tips_of(polygon, w):
    """corners of less than 45 degrees inside, both edges at least w/2 long, after thinning by w/20"""
    count = 0
    for part in parts_of(thinned(polygon, w / 20)):
        for ring, sign in [(part.exterior, 1)] + [(i, -1) for i in part.interiors]:
            c = np.asarray(ring.coords)[:-1]
            if ring.is_ccw != (sign > 0): c = c[::-1]
            into, out = c - np.roll(c, 1, 0), np.roll(c, -1, 0) - c
            turn = np.degrees(np.arctan2(into[:, 0] * out[:, 1] - into[:, 1] * out[:, 0], (into * out).sum(1)))
            count += int(((turn > 135) & (np.minimum(np.hypot(*into.T), np.hypot(*out.T)) >= w / 2)).sum())
    return count


def clusters(lines, w):
    return parts_of(unary_union([LineString(l).buffer(w / 8, 2) for l in lines])) if len(lines) else []


def leaves_of(polygon, lines, length, angle, w):
    """rings: all outlines of all insets by w/2 + k w. Spines: what the rings leave bare along at least w/2 of the axis between two sides."""
    polygon = thinned(polygon, w / 50)
    nested, bare = [], []
    outside, here = polygon, polygon.buffer(-w / 2, 16)
    while not outside.is_empty:
        nested += [Polygon(r) for r in rings_of(here)]
        gap = outside.difference(here.buffer(0.51 * w, 16))
        bare += [g for g in parts_of(gap) if g.area > 0.05 * w * w]
        outside, here = (g.buffer(-w, 16).simplify(w / 100) for g in (outside, here))
    spine = angle >= PARALLEL
    middle, size = lines[spine].mean(axis=1), length[spine]
    for gap in bare:
        x0, y0, x1, y1 = gap.bounds
        near = (middle[:, 0] > x0) & (middle[:, 0] < x1) & (middle[:, 1] > y0) & (middle[:, 1] < y1)
        inside = prep(gap)
        if sum(s for m, s in zip(middle[near], size[near]) if inside.contains(Point(m))) >= w / 2: nested.append(Polygon(gap.exterior))
    boxes = np.array([p.bounds for p in nested]).reshape(-1, 4)
    seeds = [p.exterior.coords[0] for p in nested]
    leaves = 0
    for i, p in enumerate(nested):
        b = boxes[i]
        held = np.flatnonzero((boxes[:, 0] > b[0]) & (boxes[:, 1] > b[1]) & (boxes[:, 2] < b[2]) & (boxes[:, 3] < b[3]))
        inside = prep(p)
        leaves += not any(inside.contains(Point(seeds[j])) for j in held)
    return max(1, leaves)


def measured(polygon, w):
    opened = polygon.buffer(-1.5 * w, 16).buffer(1.5 * w, 16).intersection(polygon)
    lines, T, angle = medial_axis(polygon, w)
    length = np.hypot(*(lines[:, 1] - lines[:, 0]).T) if len(lines) else np.zeros(0)
    widest = max(2 * polylabel(p, w / 50).distance(p.boundary) for p in parts_of(thinned(polygon, w / 50)))
    tight = (angle >= CORRIDOR) & (T < 1.5 * w)
    narrow = sum(1 for c in clusters(lines[tight], w) if c.area > w / 4 * w / 4)  # a quarter of w long, w/4 thick
    return Shape(polygon.area, opened.area / polygon.area, floor_of(length, T, angle, w, widest), tips_of(polygon, w), narrow,
                 leaves_of(polygon, lines, length, angle, w), widest / w)
