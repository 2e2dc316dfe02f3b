"""The sand after a drive."""

from __future__ import annotations

import enum
import functools
import json
from typing import Any

from . import _core
from ._types import Bytes, Progress, SmallInts


class Sand(enum.IntFlag):
    """What a cell is, as bits of Simulation.sand."""

    RAKED = 1  #: a pin went through
    FILLED = 2  #: the last pin was of an area's fill
    ROLLED = 4  #: a wheel was there after every pin
    WANTED_FILL = 8  #: the drawing has an area here
    WANTED_LINE = 16  #: the drawing has a line's groove here
    BORDER = 32  #: near an area's outline


class Simulation:
    """What a drive left in the sand, and how true that is to the drawing. Made by Plan.simulate()."""

    def __init__(self, core: _core.Simulation) -> None:
        self._core = core

    @functools.cached_property
    def report(self) -> dict[str, Any]:
        """Figures, then places of flaws (docs/fidelity.md): metres, m2, shares."""
        return dict(json.loads(self._core.report_json()))

    @property
    def cell(self) -> float:
        """m, of the raster."""
        return self._core.cell

    @property
    def lost(self) -> bool:
        """Whether the robot fell so far behind that it was stopped."""
        return self._core.lost

    @functools.cached_property
    def sand(self) -> Bytes:
        """uint8, (rows, columns): bits of Sand. Row 0 lies at the canvas's lower edge, column 0 at its left."""
        return self._core.bits()

    @functools.cached_property
    def height(self) -> SmallInts:
        """int8, (rows, columns): of the sand, hundredths of a groove's depth; 0: as it lay."""
        return self._core.heights()

    @property
    def extent(self) -> tuple[float, float, float, float]:
        """Left, right, lower, upper edge of these arrays, m: imshow(sim.height, origin="lower",
        extent=sim.extent)."""
        rows, columns = self.sand.shape
        return 0.0, columns * self.cell, 0.0, rows * self.cell

    @functools.cached_property
    def log(self) -> dict[str, Any]:
        """How the controller drove, a tick a row, (N,) each: t, planned_t (s), x, y, heading, v, omega, rake_x,
        rake_y, pins, off (m from the rake to its planned path while drawing). Empty without a controller."""
        return self._core.log()

    def picture(self, pixels: int = 1200, *, flaws: bool = False) -> Bytes:
        """uint8, (rows, columns, 3) from the upper left: the sand seen from above with the sun in the upper
        left, or what is wrong with it, each kind in a colour. `pixels`: of the longer side, 16 to 16000."""
        return self._core.image(pixels, flaws)

    def png(self, pixels: int = 1200, *, flaws: bool = False) -> bytes:
        """The same as PNG; flaws with their key."""
        return self._core.png(pixels, flaws)

    def gif(self, pixels: int = 480, *, seconds: float = 15,
            progress: Progress | None = None) -> bytes:
        """The drawing as it appears, a film of so many seconds."""
        return self._core.gif(pixels, seconds, progress)

    def _repr_png_(self) -> bytes:
        return self.png(800)

    def __repr__(self) -> str:
        rows, columns = self.sand.shape
        return f"<strandline.Simulation: {columns} x {rows} cells of {self.cell:g} m>"
