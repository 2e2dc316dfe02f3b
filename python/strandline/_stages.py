"""Single stages on NumPy arrays: fill, tour, connect, convert (docs/stage-formats.md)."""

from __future__ import annotations

import json
import warnings
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core, _texts
from ._errors import InputError, Notice, StrandlineWarning
from ._types import Flags, Floats, Indices, Masks, Progress, Robot


def _warn(pairs: Iterable[tuple[str, str]]) -> list[Notice]:
    notices = [Notice(*pair) for pair in pairs]
    for notice in notices:
        warnings.warn(str(notice), StrandlineWarning, stacklevel=3)
    return notices


@dataclass(frozen=True, eq=False)
class Move:
    """A piece of the drive of a fill."""

    points: Floats  #: (N, 2), of the rake
    pins: int  #: mask of the pins that are down, highest used bit the leftmost; 0: rake up


@dataclass(frozen=True, eq=False)
class Filled:
    """The strokes that rake an area."""

    moves: list[Move]  #: in driving order, rake down and up
    account: dict[str, Any]  #: coverage, overdraw, spill, gaps ... (docs/rake.md, Account)
    warnings: list[Notice]

    @property
    def strokes(self) -> list[Floats]:
        """The moves with the rake down, (N, 2) each."""
        return [move.points for move in self.moves if move.pins]


def fill(outer: ArrayLike, holes: Iterable[ArrayLike] = (), *, width: float, style: str = "rings",
         spacing: float | None = None, inset: str = "offset", join: str = "half-step",
         direction: float | None = None, partition: str = "fitted", cuts: Iterable[ArrayLike] = (),
         segments: str = "", narrow: str = "single-pass", shift: float = 3, one_stroke: bool = False,
         pins: int | None = None, vehicle: Robot = "free",
         progress: Progress | None = None) -> Filled:
    """The strokes that rake a polygon.

    Any unit will do as long as it is one, unless `vehicle` is a robot: then metres.

    Args:
        outer, holes: arrays of shape (N, 2), the first point not repeated; repaired by the even-odd rule.
        width: of the rake.
        style: "rings" (nested insets, inside to outside), "spiral" or "zigzag".
        spacing: between neighbouring passes; None: the width, or a pin less where pins lift.
        inset: rings, spiral: "offset" (Euclidean) or "skeleton".
        join: rings: "half-step", "nearest", "alternating" or "longest-edge".
        direction: zigzag: of its lines, rad; None: what wastes least.
        partition: zigzag: "none", "monotone", "optimal-convex" or "fitted".
        cuts: zigzag: lines of shape (N, 2) that part the area first.
        segments: zigzag: "2,3 direction=30deg; 5,1 style=rings".
        narrow: what is narrower than the rake: "single-pass" or "warn" (left bare).
        shift: spiral: the stretch of a turn that shifts outwards, in widths.
        one_stroke: the rake does not lift inside the area.
        pins: 1 to 32 that lift one by one; None: a solid rake.
        vehicle: "free" (turns on the spot), or a robot as plan() takes it.

    Raises:
        InputError: no polygon, a value out of its range, nothing that can be raked.

    Methods and bounds: docs/fill.md, with sources.
    """
    call = _core.FillCall()
    call.width = _texts.quantity(width, "width")
    call.style, call.inset, call.join = style, inset, join
    call.spacing = _texts.quantity(spacing, "spacing")
    call.direction = _texts.quantity(direction, "direction", "rad")
    call.partition, call.narrow, call.segments = partition, narrow, segments
    call.cuts = "; ".join(_texts.outline_texts(list(cuts), "cuts"))
    call.shift, call.one_stroke = _texts.number(shift, "shift"), one_stroke
    if pins is not None and not 1 <= pins <= 32:
        raise InputError("pins", f"{pins} is out of range", "use 1 to 32")
    call.pins = pins
    rings = [_texts.points(hole, f"holes[{k}]").tolist() for k, hole in enumerate(holes)]
    polygon = {"polygon": {"outer": _texts.points(outer, "outer").tolist(), "holes": rings}}
    name, profile = _texts.robot_texts(vehicle)
    moves, account, pairs = _core.fill(_texts.json_text(polygon), call, name, profile, progress)
    return Filled([Move(*move) for move in moves], json.loads(account), _warn(pairs))


@dataclass(frozen=True, eq=False)
class Tour:
    """An order of elements and where each is entered; arrays of shape (N,), in drawing order."""

    order: Indices  #: int32: the element
    entry: Indices  #: int32: its point that it is entered at
    reversed: Flags  #: bool: an open line run backwards, a closed one with its sense turned
    length: float  #: of the straight rake-up legs
    proven_optimal: bool
    reproducible: bool  #: False: a time limit or you ended the search
    moves: int  #: of the budget, used
    at: Floats | None  #: (N, 2), with on_edges: where each is entered
    length_on_edges: float | None


def tour(elements: Iterable[Union[ArrayLike, Mapping[str, Any]]], *, start: Sequence[float] | None = None,
         end: Union[str, Sequence[float], None] = None, closed: Union[bool, Iterable[bool]] = False,
         links: Iterable[Any] = (), before: Iterable[Sequence[int]] = (),
         groups: Iterable[Sequence[int]] = (), keep_group_order: bool = False, method: str = "best",
         grouped: bool = False, on_edges: bool = False, threads: int = 1, seed: int = 1, moves: int = 0,
         time_limit: float = 0, progress: Progress | None = None) -> Tour:
    """The order of lines, and where each is entered, with the least straight rake-up length.

    An open generalised travelling-salesman problem: an open line is entered at either end, a closed one at
    any of its points and left there.

    Args:
        elements: arrays of shape (N, 2), or dicts as in docs/stage-formats.md (with "entry", "direction",
            "sense").
        start: (x, y); None: anywhere.
        end: (x, y), "start" for a closed tour; None: anywhere.
        closed: of all arrays, or of each.
        links: ((i, v), (j, w)): element i is left at its point v and j follows at its point w.
        before: (i, j): i is finished before j begins.
        groups: drawn without others between; keep_group_order: in the order given.
        method: "best" (a search, and a proof where it can be had), "exact" (the optimum of up to 40 elements,
            or an error), "nearest" and "file" (no search: to compare with).
        grouped: neighbours are finished together.
        on_edges: along the order found, closed elements are entered anywhere on their edges.
        threads: so many searches with seeds from `seed` on; the best is taken.
        moves: budget of the search; 0: from the size. time_limit: s of processor time a thread; 0: none.

    Raises:
        InputError: contradictory rules, by name; an element without points; no proof (method "exact").

    About 30 us a move; docs/tour.md has method, bounds and sources.
    """
    if method == "exact" and grouped:
        raise InputError("method exact", "proves the shortest tour, which grouped leaves",
                         "leave one of them out")
    rows: list[Any] = []
    listed = list(elements)
    flags = [closed] * len(listed) if isinstance(closed, (bool, np.bool_)) else list(closed)
    if len(flags) != len(listed):
        raise InputError("closed", f"has {len(flags)} values for {len(listed)} elements")
    for k, (element, flag) in enumerate(zip(listed, flags)):
        if isinstance(element, Mapping):
            rows.append({"closed": bool(flag), **element})
        else:
            rows.append({"closed": bool(flag), "points": _texts.points(element, f"elements[{k}]").tolist()})
    instance: dict[str, Any] = {
        "elements": rows, "links": list(links), "before": list(before), "groups": list(groups),
        "group_order": "kept" if keep_group_order else "any",
        "start": None if start is None else _texts.numbers(start, (2,), "start"),
        "end": end if end is None or isinstance(end, str) else _texts.numbers(end, (2,), "end")}
    if threads < 1 or threads > 64:
        raise InputError("threads", f"{threads} is out of range", "use 1 to 64")
    return Tour(**_core.tour(_texts.json_text(instance), method, grouped, on_edges, threads,
                             _texts.unsigned(seed, "seed"), _texts.unsigned(moves, "moves"),
                             _texts.number(time_limit, "time_limit"), progress))


@dataclass(frozen=True, eq=False)
class DrivenCurve:
    """A curve that the robot drives; columns of shape (N,) at equal steps."""

    s: Floats  #: m
    x: Floats  #: m
    y: Floats  #: m
    heading: Floats  #: rad
    curvature: Floats  #: 1/m, positive to the left
    pieces: Floats  #: (M, 3): clothoids end to end, each length, curvature at its start, sharpness (1/m^2)
    length: float  #: m
    round_obstacles: bool  #: the curve of its own came too near to an obstacle
    fallback: str  #: the limit that the style would break, where the curve is bounded instead; "" if none
    failure: str | None  #: why obstacles could not be kept clear of


def connect(start: Sequence[float], end: Sequence[float], *, radius: float = 0.5,
            right_radius: float | None = None, sharpness: float | None = None, start_curvature: float = 0,
            end_curvature: float = 0, through: Iterable[Sequence[float]] = (),
            obstacles: Iterable[ArrayLike] = (), clearance: float = 0, style: str = "bounded",
            extra_length: float = 0.1, quick: bool = False, step: float | None = None) -> DrivenCurve:
    """A curve from pose to pose that keeps limits of curvature and sharpness.

    Args:
        start, end: (x, y, heading in radians).
        radius: m, the least one; right_radius: of turns to the right, None: the same.
        sharpness: 1/m^2, the largest change of curvature per metre; None: 2.5 / radius^2.
        start_curvature, end_curvature: 1/m, to be met.
        through: poses to be met on the way, in order.
        obstacles: rings of shape (N, 2) that are kept off by `clearance` metres.
        style: "bounded" (short), "fair" (longer by up to the share extra_length, with less bending), "spiro",
            "bezier", "straight".
        quick: the first good curve instead of the shortest.
        step: m, between samples; None: 0.01 radius.

    Raises:
        InputError: a value out of its range; poses that cannot be met.

    Warns:
        StrandlineWarning: an obstacle is nearer than the clearance, or another style was taken.

    CC turns after Fraichard and Scheuer, IEEE Trans. Robotics 2004, with end curvatures as in Banzhaf et al.,
    ITSC 2017; docs/connect.md and docs/route.md have the rest. 10 us quick, some 300 us otherwise.
    """
    radius = _texts.number(radius, "radius")
    pair: dict[str, Any] = {
        "start": _texts.numbers(start, (3,), "start"), "end": _texts.numbers(end, (3,), "end"),
        "R": radius, "kappa0": _texts.number(start_curvature, "start_curvature"),
        "kappa1": _texts.number(end_curvature, "end_curvature"),
        "clearance": _texts.number(clearance, "clearance"),
        "obstacles": [_texts.points(o, f"obstacles[{k}]").tolist() for k, o in enumerate(obstacles)],
        "through": [_texts.numbers(p, (3,), f"through[{k}]") for k, p in enumerate(through)]}
    if right_radius is not None:
        pair["R_right"] = _texts.number(right_radius, "right_radius")
    if sharpness is not None:
        pair["sigma"] = _texts.number(sharpness, "sharpness")
    curve = DrivenCurve(**_core.connect(_texts.json_text(pair), style, _texts.number(extra_length, "extra_length"),
                                        quick, step))
    if curve.fallback:
        _warn([("connect", f"{style} breaks a limit here ({curve.fallback}): the curve is bounded")])
    if curve.failure:
        _warn([("connect", curve.failure)])
    return curve


@dataclass(frozen=True, eq=False)
class RobotPath:
    """The robot path that makes the rake follow a path; columns of shape (N,), a row a point given."""

    x: Floats  #: m, of the turning point
    y: Floats  #: m
    heading: Floats  #: rad
    curvature: Floats  #: 1/m
    rake_x: Floats  #: m: where the rake really is
    rake_y: Floats  #: m
    pins: Masks  #: uint32, mask
    warnings: list[Notice]  #: spans that the rake cannot follow


def convert(rake_path: ArrayLike, *, robot: Robot = "beachbot",
            pins: Union[int, ArrayLike, None] = None) -> RobotPath:
    """The rake's path -> the robot's: one stroke.

    Args:
        rake_path: (N, 2), m, in driving order.
        robot: as plan() takes it.
        pins: mask of the pins that are down, of all points or of each; None: all of them.

    Raises:
        InputError: not such an array; pins that the robot does not have.

    Warns:
        StrandlineWarning: along a span the path bends more tightly than the rake can follow.

    A smooth curve is laid through the points, and one backward pass along it gives the robot's path
    (docs/follow.md has the derivation). O(length / 1 cm).
    """
    points = _texts.points(rake_path, "rake_path")
    name, profile = _texts.robot_texts(robot)
    if pins is None:
        pins = 2 ** int(json.loads(_core.robot_json(name, profile))["pins"]) - 1
    try:
        masks = np.broadcast_to(np.asarray(pins, dtype=np.float64), len(points))
    except (TypeError, ValueError):
        raise InputError("pins", "are not numbers, one or one a point", "give a mask, such as 127") from None
    paths, pairs = _core.convert([(points, masks.tolist())], name, profile)
    return RobotPath(warnings=_warn(pairs), **paths[0])
