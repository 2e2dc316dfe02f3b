"""What goes wrong, and what is worth a warning."""

from __future__ import annotations

from typing import NamedTuple


class InputError(ValueError):
    """Something that was given cannot be used; its text is "place: reason; remedy".

    Attributes:
        place: where, as you know it: "lion.svg, line 12", "fill.spacing", "edits"; may be empty.
        reason: what is wrong there.
        remedy: what you can do; may be empty.
    """

    def __init__(self, place: str, reason: str = "", remedy: str = "") -> None:
        super().__init__(place, reason, remedy)
        self.place = place
        self.reason = reason
        self.remedy = remedy

    def __str__(self) -> str:
        text = f"{self.place}: {self.reason}" if self.place else self.reason
        return f"{text}; {self.remedy}" if self.remedy else text


class StrandlineWarning(UserWarning):
    """Something was taken for granted, thinned out or done another way than asked."""


class Notice(NamedTuple):
    """A warning that belongs to a result: what was left out, repaired or replaced, and where."""

    place: str
    reason: str

    def __str__(self) -> str:
        return f"{self.place}: {self.reason}" if self.place else self.reason
