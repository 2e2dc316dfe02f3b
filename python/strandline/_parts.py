"""The parts of a plan as values and NumPy arrays."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any

import numpy as np

from ._types import Bytes, Floats, Indices, Masks

#: What `Trajectory.motion` counts in: rake down; rake up on a stroke's extension, round a corner, between
#: strokes; turning on the spot.
MOTIONS = ("draw", "lead", "loop", "connect", "pivot")


@dataclass(frozen=True, eq=False)
class Trajectory:
    """The timed drive, a row a sample; all arrays have the shape (N,) and cannot be written to.

    P is the robot's turning point, Q the middle of its rake. Metres, seconds, radians, y up, angles
    counter-clockwise; headings are not wrapped.
    """

    s: Floats  #: m driven by P
    t: Floats  #: s
    x: Floats  #: m, of P
    y: Floats  #: m, of P
    heading: Floats  #: rad, of P
    curvature: Floats  #: 1/m of P's path, positive to the left
    v: Floats  #: m/s
    omega: Floats  #: rad/s
    pins: Masks  #: uint32, mask of the pins down to the next sample; highest used bit: the leftmost
    rake_x: Floats  #: m, of Q
    rake_y: Floats  #: m, of Q
    motion: Bytes  #: uint8, to the next sample, counts in MOTIONS
    stroke: Indices  #: int32, drawn from here to the next sample, in driving order; -1: none

    def __len__(self) -> int:
        return len(self.t)


@dataclass(frozen=True, eq=False)
class Element:
    """Something that is to be drawn: a line, or an area with holes. Metres."""

    id: str
    kind: str  #: "line" or "area"
    layer: str
    points: Floats  #: (N, 2): the line, or the area's outline, its first point not repeated
    closed: bool
    pins: int  #: of a line; 0 of an area
    holes: tuple[Floats, ...]  #: of an area, (N, 2) each
    inside: int  #: the smallest element that encloses this one, -1: none
    hints: dict[str, str]  #: what the drawing asks for it


@dataclass(frozen=True, eq=False)
class Stroke:
    """One go of the rake, as it is driven."""

    element: int  #: counts in Plan.elements
    points: Floats  #: (N, 2), m: the rake's path
    closed: bool
    fill: bool  #: of an area
    pins: int
    entry: int  #: the node where it is entered
    reversed: bool


@dataclass(frozen=True, eq=False)
class Connection:
    """What is driven rake up from one stroke to the next."""

    start: int  #: the stroke that was drawn; -1: where the robot was parked
    end: int  #: the stroke that is drawn next; -1: the exit
    turn_before: float  #: rad, on the spot
    turn_after: float
    states: Floats  #: (N, 4): x, y, heading, curvature of P


def driven(columns: dict[str, Any]) -> Floats:
    """m driven by P up to each sample: circular arcs between neighbours."""
    s = np.zeros(len(columns["t"]))
    if len(s) > 1:
        half = np.diff(columns["heading"]) / 2
        half -= np.pi * np.round(half / np.pi)
        chord = np.hypot(np.diff(columns["x"]), np.diff(columns["y"]))
        np.cumsum(chord / np.sinc(half / np.pi), out=s[1:])
    s.setflags(write=False)
    return s


def frozen(columns: dict[str, Any]) -> dict[str, Any]:
    for column in columns.values():
        column.setflags(write=False)
    return columns


def element_of(row: dict[str, Any]) -> Element:
    if row["kind"] == "line":
        return Element(holes=(), **row)
    points, holes = row.pop("outer"), tuple(row.pop("holes"))
    return Element(points=points, holes=holes, closed=True, pins=0, **row)
