"""Strandline: a drawing becomes one drivable path for a drawing robot.

    import strandline
    plan = strandline.plan("lion.svg", robot="beachbot", canvas="14x14")
    plan.trajectory.x, plan.trajectory.pins  # NumPy arrays
    plan.check()["sound"]
    plan.export("csv", "lion.csv")

Metres, seconds, radians, y up, angles counter-clockwise. docs/python.md has the whole of it.
"""

from ._core import version as __version__
from ._errors import InputError, Notice, StrandlineWarning
from ._lists import fonts, formats, robot, robot_toml, robots, settings
from ._parts import MOTIONS, Connection, Element, Stroke, Trajectory
from ._plan import Plan
from ._planning import load, plan, plan_svg, plan_text
from ._simulation import Sand, Simulation
from ._stages import DrivenCurve, Filled, Move, RobotPath, Tour, connect, convert, fill, tour

__all__ = [
    "MOTIONS",
    "Connection",
    "DrivenCurve",
    "Element",
    "Filled",
    "InputError",
    "Move",
    "Notice",
    "Plan",
    "RobotPath",
    "Sand",
    "Simulation",
    "StrandlineWarning",
    "Stroke",
    "Tour",
    "Trajectory",
    "__version__",
    "connect",
    "convert",
    "fill",
    "fonts",
    "formats",
    "load",
    "plan",
    "plan_svg",
    "plan_text",
    "robot",
    "robot_toml",
    "robots",
    "settings",
    "tour",
]
