"""What there is: settings, robots, formats, fonts."""

from __future__ import annotations

import json
from typing import Any

from . import _core, _texts
from ._types import Robot


def settings() -> list[dict[str, Any]]:
    """Everything that can be set: "key", "kind", "unit", "default", "low" and "high" or "choices", "meaning".
    SI units."""
    return list(json.loads(_core.settings_json()))


def robots() -> list[str]:
    """The names of the built-in robots."""
    return _core.robots()


def robot(robot: Robot) -> dict[str, Any]:
    """A robot's whole profile: every field, metres, seconds and radians; wheels (x, y, width) and rake_rules
    (up_to, pins) as lists. What comes back can be changed and given to plan(). InputError: no such robot, or a
    field out of its range."""
    return dict(json.loads(_core.robot_json(*_texts.robot_texts(robot))))


def robot_toml(robot: Robot) -> str:
    """The same as the text of a profile file, each field with its unit and meaning."""
    return _core.robot_toml(*_texts.robot_texts(robot))


def formats() -> list[dict[str, Any]]:
    """What Plan.export() writes: "name", "what", "suffixes" of the files."""
    return [dict(zip(("name", "what", "suffixes"), row)) for row in _core.formats()]


def fonts() -> list[dict[str, str]]:
    """The fonts of plan_text(): "name", "what". InputError: none are installed."""
    return [dict(zip(("name", "what"), row)) for row in _core.fonts()]
