"""Python values -> the texts that the command line takes."""

from __future__ import annotations

import functools
import json
import math
import os
from collections.abc import Iterable, Mapping, Sequence
from numbers import Integral, Real
from typing import Any, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _core
from ._errors import InputError
from ._types import Floats, PathText, Robot


def path_text(path: PathText) -> str:
    text = os.fspath(path)
    if not isinstance(text, str):
        raise TypeError(f"a path is a str or a path of str, not {type(path).__name__}")
    return "./-" if text == "-" else text


def paths(given: Union[PathText, Iterable[PathText]]) -> list[str]:
    if isinstance(given, (str, os.PathLike)):
        return [path_text(given)]
    return [path_text(path) for path in given]


def number(value: Any, place: str) -> float:
    """A finite number; a bool is none."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Real):
        raise TypeError(f"{place} must be a number, not {type(value).__name__}")
    result = float(value)
    if not math.isfinite(result):
        raise InputError(place, f"{result} is not finite")
    return result


def unsigned(value: Any, place: str) -> int:
    """0 to 2**64 - 1; a bool is none."""
    if isinstance(value, (bool, np.bool_)) or not isinstance(value, Integral):
        raise TypeError(f"{place} must be a whole number, not {type(value).__name__}")
    result = int(value)
    if not 0 <= result < 2**64:
        raise InputError(place, f"{result} is out of range", "use 0 to 2**64 - 1")
    return result


def quantity(value: Any, place: str, unit: str = "") -> str:
    """Texts stay ("36cm"); numbers get the unit."""
    if value is None:
        return ""
    return value if isinstance(value, str) else repr(number(value, place)) + unit


def numbers(values: Any, count: Sequence[int], place: str) -> list[float]:
    if isinstance(values, str) or not isinstance(values, Iterable):
        raise TypeError(f"{place} must be a text or a sequence of numbers, not {type(values).__name__}")
    listed = [number(value, place) for value in values]
    if len(listed) not in count:
        raise InputError(place, f"has {len(listed)} numbers", "it takes " + " or ".join(map(str, count)))
    return listed


def canvas_text(canvas: Any) -> str:
    """"14x14", "A4", a side, or (width, height)."""
    if canvas is None or isinstance(canvas, str):
        return canvas or ""
    if isinstance(canvas, Real):
        canvas = (canvas, canvas)
    width, height = numbers(canvas, (2,), "canvas")
    return f"{width!r}x{height!r}"


def pose_text(pose: Any, place: str, counts: Sequence[int] = (2, 3)) -> str:
    """A text, or (x, y), or (x, y, heading in radians)."""
    if pose is None or isinstance(pose, str):
        return pose or ""
    parts = numbers(pose, counts, place)
    return ",".join(repr(p) + ("rad" if k == 2 else "") for k, p in enumerate(parts))


def outline_text(outline: Any, place: str) -> str:
    """A text, the path of a GeoJSON file, or an array of shape (N, 2)."""
    if outline is None:
        return ""
    if isinstance(outline, (str, os.PathLike)):
        return path_text(outline)
    return " ".join(f"{x!r},{y!r}" for x, y in points(outline, place).tolist())


def outline_texts(outlines: Any, place: str) -> list[str]:
    if isinstance(outlines, (str, os.PathLike)):
        return [path_text(outlines)]
    if isinstance(outlines, np.ndarray) and outlines.ndim == 2:
        outlines = [outlines]
    return [outline_text(outline, f"{place}[{k}]") for k, outline in enumerate(outlines)]


def points(values: ArrayLike, place: str, columns: int = 2) -> Floats:
    """(N, columns) of finite float64."""
    try:
        array = np.asarray(values, dtype=np.float64)
    except (TypeError, ValueError):
        raise InputError(place, f"is not an array of shape (N, {columns})") from None
    if array.ndim != 2 or array.shape[1] != columns:
        raise InputError(place, f"has the shape {array.shape}", f"it takes (N, {columns})")
    if not np.isfinite(array).all():
        raise InputError(place, "holds a number that is not finite", "remove nan and inf")
    return array


def toml_value(value: Any) -> str:
    if isinstance(value, (bool, np.bool_)):
        return "true" if value else "false"
    if isinstance(value, str):
        return json.dumps(value)
    if isinstance(value, Mapping):
        return "{" + ", ".join(f"{json.dumps(str(k))} = {toml_value(v)}" for k, v in value.items()) + "}"
    if isinstance(value, Iterable):
        return "[" + ", ".join(map(toml_value, value)) + "]"
    if isinstance(value, (int, np.integer)):
        return repr(int(value))
    return repr(number(value, "robot"))


_ROWS = {"wheels": ("x", "y", "width"), "rake_rules": ("up_to", "pins")}


def robot_texts(robot: Robot | None) -> tuple[str, str | None]:
    """(name or file, None), or ("", the profile as TOML) of a dict."""
    if robot is None:
        return "", None
    if isinstance(robot, (str, os.PathLike)):
        return path_text(robot), None
    if not isinstance(robot, Mapping):
        raise TypeError(f"robot must be a name, a path or a dict, not {type(robot).__name__}")
    lines = []
    for field, value in robot.items():
        if field in _ROWS:
            value = [r if isinstance(r, Mapping) else dict(zip(_ROWS[field], r)) for r in value]
        lines.append(f"{json.dumps(str(field))} = {toml_value(value)}\n")
    return "", "".join(lines)


@functools.lru_cache(maxsize=None)
def setting_kinds() -> dict[str, str]:
    return {row["key"]: row["kind"] for row in json.loads(_core.settings_json())}


def setting_text(key: str, value: Any) -> str:
    """Numbers are SI: metres, seconds, radians. Texts are as on the command line."""
    if isinstance(value, (bool, np.bool_)):
        return "on" if value else "off"
    if isinstance(value, str):
        return value
    if isinstance(value, Iterable):
        return "; ".join(setting_text(key, part) for part in value)
    value = number(value, key)
    kind = setting_kinds().get(key)
    if kind == "integer" and value.is_integer():
        return str(int(value))
    return quantity(value, key, "rad" if kind == "angle" else "")


def setting_pairs(settings: Mapping[str, Any] | None, more: Mapping[str, Any], call: str) -> list[tuple[str, str]]:
    """`settings` by key ("fill.style"), then keywords (fill_style)."""
    if settings is not None and not isinstance(settings, Mapping):
        raise TypeError(f"settings must be a dict, not {type(settings).__name__}")
    pairs = [(str(key), setting_text(str(key), value)) for key, value in (settings or {}).items()]
    for name, value in more.items():
        group, underscore, field = name.partition("_")
        if not underscore:
            raise TypeError(f"{call}() got an unexpected keyword argument {name!r}; "
                            "settings are written fill_style=..., strandline.settings() lists them")
        key = f"{group}.{field}"
        pairs.append((key, setting_text(key, value)))
    return pairs


def setting_lines(settings: Mapping[str, Any] | None, more: Mapping[str, Any], call: str) -> list[str]:
    return [f"{key}={text}" for key, text in setting_pairs(settings, more, call)]


def json_text(value: Any) -> str:
    """With NumPy's arrays and numbers as lists and numbers."""

    def plain(item: Any) -> Any:
        if isinstance(item, (np.ndarray, np.generic)):
            return item.tolist()
        raise TypeError(f"{type(item).__name__} is nothing that can be written as JSON")

    try:
        return json.dumps(value, default=plain, allow_nan=False)
    except ValueError as error:
        raise InputError("", f"a number is not finite ({error})", "remove nan and inf") from None
