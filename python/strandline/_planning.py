"""Drawings -> plans."""

from __future__ import annotations

import os
import warnings
from collections.abc import Iterable, Mapping
from typing import Any, Union

from . import _core, _texts
from ._errors import Notice, StrandlineWarning
from ._plan import Plan
from ._types import Edit, PathText, Progress, Robot


def _call(robot: Robot | None, config: Any, pairs: list[str]) -> _core.Call:
    call = _core.Call()
    call.robot, call.profile = _texts.robot_texts(robot)
    call.configs = _texts.paths(config)
    call.settings = pairs
    return call


def _planned(source: bytes, title: str, place: str, *, robot: Robot | None, canvas: Any,
             fit: str, margin: Any, config: Any, settings: Mapping[str, Any] | None,
             edits: Edit | Iterable[Edit], border: Any, keep_out: Any, start: Any, end: Any, park: Any, exit: Any,
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
    listed = [edits] if isinstance(edits, Mapping) else list(edits)
    return Plan(_core.plan(source, title, place, call, _texts.json_text(listed), progress))


def plan(drawing: PathText, *, robot: Robot | None = None, canvas: Any = None, place: str = "",
         margin: Any = None, config: Union[PathText, Iterable[PathText]] = (),
         settings: Mapping[str, Any] | None = None, edits: Edit | Iterable[Edit] = (), border: Any = None,
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
        edits: one dict as in docs/plan-format.md, or several.
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


def plan_svg(text: Union[str, bytes], *, title: str = "drawing", robot: Robot | None = None,
             canvas: Any = None, place: str = "", margin: Any = None,
             config: Union[PathText, Iterable[PathText]] = (),
             settings: Mapping[str, Any] | None = None, edits: Edit | Iterable[Edit] = (), border: Any = None,
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
              line_spacing: float = 1.6, robot: Robot | None = None, canvas: Any = None,
              place: str = "", margin: Any = None,
              config: Union[PathText, Iterable[PathText]] = (),
              settings: Mapping[str, Any] | None = None, edits: Edit | Iterable[Edit] = (), border: Any = None,
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


def load(path: PathText) -> Plan:
    """Reads a plan file, bit for bit. It does not hold the drawing's source, so edited() needs plan() again.

    Raises:
        InputError: not a plan, another version, or a value that is missing or wrong, by its place.
    """
    name = _texts.path_text(path)
    return Plan(_core.read_plan(_core.read_file(name), name))
