"""Plans: made from drawings, read, changed, proved, simulated, exported."""

from __future__ import annotations

import functools
import json
import os
import warnings
from collections.abc import Callable, Iterable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any, Union, overload

import numpy as np

from . import _core, _texts
from ._errors import InputError, Notice, StrandlineWarning
from ._simulation import Simulation

#: Called with what is being done and how much of it is done, 0 to 1. False: stop, keep the best so far.
Progress = Callable[[str, float], Any]
Edit = Mapping[str, Any]

#: What `Trajectory.motion` counts in: rake down; rake up on a stroke's extension, round a corner, between
#: strokes; turning on the spot.
MOTIONS = ("draw", "lead", "loop", "connect", "pivot")


def _frozen(columns: dict[str, np.ndarray]) -> dict[str, np.ndarray]:
    for column in columns.values():
        column.setflags(write=False)
    return columns


@dataclass(frozen=True, eq=False)
class Trajectory:
    """The timed drive, a row a sample; all arrays have the shape (N,) and cannot be written to.

    P is the robot's turning point, Q the middle of its rake. Metres, seconds, radians, y up, angles
    counter-clockwise; headings are not wrapped.
    """

    s: np.ndarray  #: m driven by P
    t: np.ndarray  #: s
    x: np.ndarray  #: m, of P
    y: np.ndarray  #: m, of P
    heading: np.ndarray  #: rad, of P
    curvature: np.ndarray  #: 1/m of P's path, positive to the left
    v: np.ndarray  #: m/s
    omega: np.ndarray  #: rad/s
    pins: np.ndarray  #: uint32, mask of the pins down to the next sample; highest used bit: the leftmost
    rake_x: np.ndarray  #: m, of Q
    rake_y: np.ndarray  #: m, of Q
    motion: np.ndarray  #: uint8, to the next sample, counts in MOTIONS
    stroke: np.ndarray  #: int32, drawn from here to the next sample, in driving order; -1: none

    def __len__(self) -> int:
        return len(self.t)


@dataclass(frozen=True, eq=False)
class Element:
    """Something that is to be drawn: a line, or an area with holes. Metres."""

    id: str
    kind: str  #: "line" or "area"
    layer: str
    points: np.ndarray  #: (N, 2): the line, or the area's outline, its first point not repeated
    closed: bool
    pins: int  #: of a line; 0 of an area
    holes: tuple[np.ndarray, ...]  #: of an area, (N, 2) each
    inside: int  #: the smallest element that encloses this one, -1: none
    hints: dict[str, str]  #: what the drawing asks for it


@dataclass(frozen=True, eq=False)
class Stroke:
    """One go of the rake, as it is driven."""

    element: int  #: counts in Plan.elements
    points: np.ndarray  #: (N, 2), m: the rake's path
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
    states: np.ndarray  #: (N, 4): x, y, heading, curvature of P


class Plan:
    """A finished plan; it never changes. Made by plan(), plan_svg(), plan_text() or load()."""

    def __init__(self, core: _core.Planned) -> None:
        self._core = core

    @property
    def title(self) -> str:
        """The name of the drawing."""
        return self._core.title

    @property
    def canvas(self) -> tuple[float, float]:
        """Width and height, m."""
        return self._core.canvas

    @functools.cached_property
    def figures(self) -> dict[str, Any]:
        """What the planner states, by name: metres, seconds, counts (docs/plan-format.md, figures)."""
        return dict(json.loads(self._core.figures_json()))

    @functools.cached_property
    def robot(self) -> dict[str, Any]:
        """The robot's profile: metres, seconds, radians."""
        return dict(json.loads(self._core.robot_json()))

    @functools.cached_property
    def settings(self) -> dict[str, str]:
        """Every setting by its key, as text."""
        return self._core.settings()

    @property
    def edits(self) -> list[dict[str, Any]]:
        """The edits it was made with (docs/plan-format.md, edits)."""
        return list(json.loads(self._core.edits_json()))

    @property
    def idle_edits(self) -> list[str]:
        """Edits whose place is gone, a sentence each."""
        return self._core.idle_edits

    @functools.cached_property
    def warnings(self) -> list[Notice]:
        """What was left out, repaired or replaced, and where."""
        return [Notice(*pair) for pair in self._core.warnings]

    @functools.cached_property
    def trajectory(self) -> Trajectory:
        """The timed drive as NumPy arrays."""
        columns = _frozen(self._core.samples())
        return Trajectory(s=_driven(columns), **columns)

    @functools.cached_property
    def elements(self) -> list[Element]:
        """What was to be drawn; curves as chords within 2 mm (a sheet of paper: less)."""
        tolerance = float(self.settings["drawing.tolerance"])
        return [_element(row) for row in self._core.elements(tolerance)]

    @functools.cached_property
    def strokes(self) -> list[Stroke]:
        """The goes of the rake in driving order, sampled as finely as the trajectory."""
        return [Stroke(**row) for row in self._core.strokes(self._step)]

    @functools.cached_property
    def connections(self) -> list[Connection]:
        """What is driven between them, sampled as finely."""
        rows = self._core.connections(self._step)
        return [Connection(start=row.pop("from"), end=row.pop("to"), **row) for row in rows]

    @property
    def stops(self) -> list[dict[str, Any]]:
        """Where the drive waits for a hand: "why", "stroke", "time" (s)."""
        return self._core.stops()

    @property
    def undrivable(self) -> list[dict[str, Any]]:
        """Where the rake cannot follow its path: "what", "at" (m), "amount"."""
        return self._core.spots("undrivable")

    @property
    def blemishes(self) -> list[dict[str, Any]]:
        """Where finished sand is driven over rake up, because no better way was found."""
        return self._core.spots("blemishes")

    @property
    def bare(self) -> list[dict[str, Any]]:
        """Sand of areas that no stroke rakes, m2, largest first."""
        return self._core.spots("bare")

    @property
    def _step(self) -> float:
        return float(self.settings["trajectory.step"])

    def edited(self, edits: Edit | Iterable[Edit] = (), *, settings: Mapping[str, Any] | None = None,
               keep: bool = True, draft: bool = False, progress: Progress | None = None,
               **more: Any) -> Plan:
        """The drawing planned again with edits; only what they touch is made again.

        Args:
            edits: one, or several, as dicts: ``{"edit": "direction", "element": "lid", "direction": "cw"}``
                (docs/plan-format.md, edits).
            settings: settings to change, as plan() takes them; so are keywords.
            keep: with the plan's own edits before them; False: with these alone.
            draft: quickly: the order is mended, not searched for again.
            progress: as plan() has it.

        Raises:
            InputError: an edit or a setting is not understood, edits contradict each other, or the plan was
                read from a file, which does not hold the drawing.
        """
        new = [edits] if isinstance(edits, Mapping) else list(edits)
        text = _texts.json_text((self.edits if keep else []) + new)
        pairs = _texts.setting_pairs(settings, more, "edited")
        return Plan(self._core.edited(text, pairs, draft, progress))

    def check(self, *, progress: Progress | None = None) -> dict[str, Any]:
        """Proves the plan from its values alone, with none of the code that planned it.

        Returns:
            "sound": whether nothing was found; "faults", "blemishes", "bare", figures measured anew, and
            under "fidelity" how true the sand is to the drawing (docs/check.md, docs/fidelity.md).
        """
        return dict(json.loads(self._core.check_json(progress)))

    def simulate(self, *, controller: bool = False, noise: float | None = None, wander: float | None = None,
                 delay: float | None = None, seed: int = 1, late_pins: bool = False, cell: float = 0,
                 progress: Progress | None = None) -> Simulation:
        """Lays the drive in the sand and holds that against the drawing.

        Without a controller the plan is driven exactly. With one (it is asked for, or any of noise, wander
        and delay is given) a robot drives that knows its place late and with noise (docs/tracking.md).

        Args:
            noise: m, of each fix of its place; None: the robot's fix_noise.
            wander: m, of the slow drift of that place; None: 0.01.
            delay: s, of fixes; None: 0.12.
            seed: of the noise; the same seed gives the same drive.
            late_pins: pins are told when they should be there, not before.
            cell: m, of the raster; 0: 0.01, or a sixth of a pin where that is less.

        Raises:
            InputError: a value out of its range, by name.
        """
        controlled = controller or any(value is not None for value in (noise, wander, delay))
        return Simulation(_core.simulate(self._core, cell, controlled, noise, wander, delay, seed, late_pins,
                                         progress))

    @overload
    def export(self, format: str, path: None = None, *, robot_path: bool = ...,
               config: Union[_texts.PathText, Iterable[_texts.PathText]] = ...,
               settings: Mapping[str, Any] | None = ..., **more: Any) -> dict[str, bytes]: ...

    @overload
    def export(self, format: str, path: _texts.PathText, *, robot_path: bool = ...,
               config: Union[_texts.PathText, Iterable[_texts.PathText]] = ...,
               settings: Mapping[str, Any] | None = ..., **more: Any) -> list[str]: ...

    def export(self, format: str, path: _texts.PathText | None = None, *, robot_path: bool = False,
               config: Union[_texts.PathText, Iterable[_texts.PathText]] = (),
               settings: Mapping[str, Any] | None = None,
               **more: Any) -> Union[dict[str, bytes], list[str]]:
        """The plan for other programs and machines (docs/exports.md; strandline.formats() lists them).

        Args:
            format: "csv", "beachbot", "geojson", "gcode" ...
            path: the file to write; a pair NAME.txt becomes NAME_robot.txt and NAME_rake.txt. None: nothing
                is written.
            robot_path: trace: of the turning point instead of the rake.
            config: settings files (TOML).
            settings: what the format can be told, as ``{"site.latitude": 47.37}`` or ``site_latitude=47.37``.

        Returns:
            With a path the names of the files that were written; without, what they hold by their suffix:
            ``{".csv": b"..."}``.

        Raises:
            InputError: no such format; the plan cannot be written in it; the file cannot be written.

        Warns:
            StrandlineWarning: something was taken for granted, thinned or rounded.
        """
        lines = _texts.setting_lines(settings, more, "export")
        name = "" if path is None else _texts.path_text(path)
        files, notices = self._core.exported(format, name, robot_path, _texts.paths(config), lines)
        for pair in notices:
            warnings.warn(str(Notice(*pair)), StrandlineWarning, stacklevel=2)
        return dict(files) if path is None else files

    def save(self, path: _texts.PathText) -> None:
        """Writes the plan file, which every command of the program reads; InputError where it cannot."""
        _core.write_file(_texts.path_text(path), self._core.plan_text())

    def resume(self, start: Union[float, str, Sequence[float]]) -> Plan:
        """The rest of the plan after a stop, from a time (s), an element's id or a place (x, y) on.

        The stroke that was being drawn is drawn again from its beginning.
        """
        if isinstance(start, str):
            return Plan(self._core.resumed(start))
        if isinstance(start, (Sequence, np.ndarray)):
            x, y = _texts.numbers(start, (2,), "start")
            return Plan(self._core.resumed((x, y)))
        return Plan(self._core.resumed(_texts.number(start, "start")))

    def split(self, *, seconds: float = 0, metres: float = 0) -> list[Plan]:
        """The plan in parts of at most so many seconds, or metres driven, cut at stroke ends."""
        if not (seconds > 0) != (metres > 0):
            raise InputError("split", "takes seconds or metres, one of them above 0")
        return [Plan(part) for part in self._core.split(seconds, metres)]

    def svg(self) -> str:
        """The picture as SVG: rake down black at true width, rake up red."""
        return self._core.svg().decode()

    def png(self, pixels: int = 1200) -> bytes:
        """The same as PNG, the longer side of so many pixels."""
        return self._core.png(pixels)

    def _repr_svg_(self) -> str:
        return self.svg()

    def _repr_png_(self) -> bytes:
        return self.png(800)

    def __repr__(self) -> str:
        f = self.figures
        return (f"<strandline.Plan {self.title!r} for {self.robot['name']}: {f['strokes']} strokes, "
                f"{f['drawn']:.1f} m drawn, {f['up_driven']:.1f} m rake up, {f['time'] / 60:.1f} min, "
                f"{len(self.warnings) + len(self.idle_edits)} warnings>")

    def __reduce__(self) -> tuple[Any, ...]:
        return _read, (self._core.plan_text(), self.title)


def _driven(columns: dict[str, np.ndarray]) -> np.ndarray:
    """m driven by P up to each sample: circular arcs between neighbours."""
    s = np.zeros(len(columns["t"]))
    if len(s) > 1:
        half = np.diff(columns["heading"]) / 2
        half -= np.pi * np.round(half / np.pi)
        chord = np.hypot(np.diff(columns["x"]), np.diff(columns["y"]))
        np.cumsum(chord / np.sinc(half / np.pi), out=s[1:])
    s.setflags(write=False)
    return s


def _element(row: dict[str, Any]) -> Element:
    if row["kind"] == "line":
        return Element(holes=(), **row)
    points, holes = row.pop("outer"), tuple(row.pop("holes"))
    return Element(points=points, holes=holes, closed=True, pins=0, **row)


def _call(robot: _texts.Robot | None, config: Any, pairs: list[str]) -> _core.Call:
    call = _core.Call()
    call.robot, call.profile = _texts.robot_texts(robot)
    call.configs = _texts.paths(config)
    call.settings = pairs
    return call


def _planned(source: bytes, title: str, place: str, *, robot: _texts.Robot | None, canvas: Any,
             fit: str, margin: Any, config: Any, settings: Mapping[str, Any] | None,
             edits: Iterable[Edit], border: Any, keep_out: Any, start: Any, end: Any, park: Any, exit: Any,
             progress: Progress | None, more: Mapping[str, Any]) -> Plan:
    call = _call(robot, config, _texts.setting_lines(settings, more, "plan"))
    call.canvas = _texts.canvas_text(canvas)
    call.place = fit
    call.margin = _texts.quantity(margin, "margin")
    call.border = _texts.outline_text(border, "border")
    call.keep_outs = _texts.outline_texts(keep_out, "keep_out")
    call.start = _texts.pose_text(start, "start", (2,))
    call.end = _texts.pose_text(end, "end", (2,))
    call.park = _texts.pose_text(park, "park")
    call.exit = _texts.pose_text(exit, "exit")
    return Plan(_core.plan(source, title, place, call, _texts.json_text(list(edits)), progress))


def plan(drawing: _texts.PathText, *, robot: _texts.Robot | None = None, canvas: Any = None, place: str = "",
         margin: Any = None, config: Union[_texts.PathText, Iterable[_texts.PathText]] = (),
         settings: Mapping[str, Any] | None = None, edits: Iterable[Edit] = (), border: Any = None,
         keep_out: Any = (), start: Any = None, end: Any = None, park: Any = None, exit: Any = None,
         progress: Progress | None = None, **more: Any) -> Plan:
    """Plans a drawing: strokes, fills, their order, the whole drive, timed.

    Deterministic: the same input gives the same plan, unless `tour.time_limit` or you stop the search.

    Args:
        drawing: path of an SVG, PNG or JPEG.
        robot: a built-in name (strandline.robots()), the path of a profile (.toml), or a dict of its fields,
            ``{"base": "beachbot", "min_radius": 0.8}``; default beachbot.
        canvas: "14x14", "A4", a side in metres, or (width, height) in metres.
        place: "fit" (default), "actual", "width=10m" or "scale=1:50".
        margin: metres, or a text such as "40cm".
        config: settings files (TOML), later ones over earlier ones.
        settings: by key, ``{"fill.style": "zigzag", "fill.spacing": "36cm"}``; keywords do the same:
            ``fill_style="zigzag"``. Numbers are metres, seconds and radians, texts as on the command line.
            strandline.settings() lists them all.
        edits: dicts as in docs/plan-format.md.
        border, keep_out: where the robot may drive and where not: arrays of shape (N, 2) in metres, texts
            ("3,3 5,3 5,6") or paths of GeoJSON files; keep_out takes several.
        start, end: (x, y) where the drive begins and ends, m.
        park, exit: (x, y) or (x, y, heading in radians) where the robot stands before and goes after; exit
            may be "parked" or "outside".
        progress: called with what is being done and the share of it, 0 to 1, some thirty times a second. An
            exception in it ends the planning and is raised from here, as Ctrl-C does; if it returns False,
            the best plan so far comes back.

    Returns:
        The plan; what fell short is in its warnings, undrivable, blemishes, bare and idle_edits.

    Raises:
        InputError: the drawing or an argument cannot be used; it carries place, reason and remedy.
        TypeError: an argument of another kind.
    """
    path = _texts.path_text(drawing)
    source = _core.read_file(path)
    return _planned(source, os.path.basename(path), path, robot=robot, canvas=canvas, fit=place,
                    margin=margin, config=config, settings=settings, edits=edits, border=border,
                    keep_out=keep_out, start=start, end=end, park=park, exit=exit, progress=progress,
                    more=more)


def plan_svg(text: Union[str, bytes], *, title: str = "drawing", robot: _texts.Robot | None = None,
             canvas: Any = None, place: str = "", margin: Any = None,
             config: Union[_texts.PathText, Iterable[_texts.PathText]] = (),
             settings: Mapping[str, Any] | None = None, edits: Iterable[Edit] = (), border: Any = None,
             keep_out: Any = (), start: Any = None, end: Any = None, park: Any = None, exit: Any = None,
             progress: Progress | None = None, **more: Any) -> Plan:
    """Plans a drawing that is at hand: the text of an SVG, or the bytes of one or of a PNG or JPEG.

    All else as plan(); errors name the drawing by `title`.
    """
    if not isinstance(text, (str, bytes)):
        raise TypeError(f"text must be str or bytes, not {type(text).__name__}")
    source = text.encode() if isinstance(text, str) else text
    return _planned(source, title, title, robot=robot, canvas=canvas, fit=place, margin=margin,
                    config=config, settings=settings, edits=edits, border=border, keep_out=keep_out,
                    start=start, end=end, park=park, exit=exit, progress=progress, more=more)


def plan_text(text: str, *, font: str = "rowmans", height: float | None = None, align: str = "left",
              line_spacing: float = 1.6, robot: _texts.Robot | None = None, canvas: Any = None,
              place: str = "", margin: Any = None,
              config: Union[_texts.PathText, Iterable[_texts.PathText]] = (),
              settings: Mapping[str, Any] | None = None, edits: Iterable[Edit] = (), border: Any = None,
              keep_out: Any = (), start: Any = None, end: Any = None, park: Any = None, exit: Any = None,
              progress: Progress | None = None, **more: Any) -> Plan:
    """Plans words, written in single lines (Hershey fonts; strandline.fonts() lists them).

    Args:
        height: m, of capital letters; None: as large as the canvas allows.
        align: "left", "centre" or "right".
        line_spacing: from line to line, in heights.

    All else as plan().
    """
    source, notices = _core.lettered(text, font, _texts.number(1 if height is None else height, "height"),
                                     align, _texts.number(line_spacing, "line_spacing"))
    for pair in notices:
        warnings.warn(str(Notice(*pair)), StrandlineWarning, stacklevel=2)
    if not place and height is not None:
        place = "actual"
    return _planned(source, "text", "text", robot=robot, canvas=canvas, fit=place, margin=margin,
                    config=config, settings=settings, edits=edits, border=border, keep_out=keep_out,
                    start=start, end=end, park=park, exit=exit, progress=progress, more=more)


def _read(text: bytes, place: str) -> Plan:
    return Plan(_core.read_plan(text, place))


def load(path: _texts.PathText) -> Plan:
    """Reads a plan file, bit for bit. It does not hold the drawing's source, so edited() needs plan() again.

    Raises:
        InputError: not a plan, another version, or a value that is missing or wrong, by its place.
    """
    name = _texts.path_text(path)
    return Plan(_core.read_plan(_core.read_file(name), name))
