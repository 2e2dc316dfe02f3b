"""A finished plan: read, changed, proved, simulated, exported."""

from __future__ import annotations

import functools
import json
import warnings
from collections.abc import Iterable, Mapping, Sequence
from typing import Any, Union, overload

import numpy as np

from . import _core, _texts
from ._errors import InputError, Notice, StrandlineWarning
from ._parts import Connection, Element, Stroke, Trajectory, driven, element_of, frozen
from ._simulation import Simulation
from ._types import Edit, PathText, Progress


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
        columns = frozen(self._core.samples())
        return Trajectory(s=driven(columns), **columns)

    @functools.cached_property
    def elements(self) -> list[Element]:
        """What was to be drawn; curves as chords within 2 mm (a sheet of paper: less)."""
        tolerance = float(self.settings["drawing.tolerance"])
        return [element_of(row) for row in self._core.elements(tolerance)]

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
            seed: of the noise, 0 to 2**64 - 1; the same seed gives the same drive.
            late_pins: pins are told when they should be there, not before.
            cell: m, of the raster; 0: 0.01, or a sixth of a pin where that is less.

        Raises:
            InputError: a value out of its range, by name.
        """
        controlled = controller or any(value is not None for value in (noise, wander, delay))
        seed = _texts.unsigned(seed, "seed")
        return Simulation(_core.simulate(self._core, cell, controlled, noise, wander, delay, seed, late_pins,
                                         progress))

    @overload
    def export(self, format: str, path: None = None, *, robot_path: bool = ...,
               config: Union[PathText, Iterable[PathText]] = ...,
               settings: Mapping[str, Any] | None = ..., **more: Any) -> dict[str, bytes]: ...

    @overload
    def export(self, format: str, path: PathText, *, robot_path: bool = ...,
               config: Union[PathText, Iterable[PathText]] = ...,
               settings: Mapping[str, Any] | None = ..., **more: Any) -> list[str]: ...

    def export(self, format: str, path: PathText | None = None, *, robot_path: bool = False,
               config: Union[PathText, Iterable[PathText]] = (),
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

    def save(self, path: PathText) -> None:
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
        return _from_text, (self._core.plan_text(), self.title)


def _from_text(text: bytes, title: str) -> Plan:
    return Plan(_core.read_plan(text, title))
