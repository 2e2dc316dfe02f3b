"""Names for what is given and what comes back."""

from __future__ import annotations

import os
from collections.abc import Callable, Mapping
from typing import Any, Union

import numpy as np
from numpy.typing import NDArray

Floats = NDArray[np.float64]
Masks = NDArray[np.uint32]
Indices = NDArray[np.int32]
Flags = NDArray[np.bool_]
Bytes = NDArray[np.uint8]
SmallInts = NDArray[np.int8]

PathText = Union[str, "os.PathLike[str]"]
#: A name, the path of a profile (.toml), or a dict of fields.
Robot = Union[str, "os.PathLike[str]", Mapping[str, Any]]
#: As docs/plan-format.md writes it.
Edit = Mapping[str, Any]
#: Called with what is being done and how much of it is done, 0 to 1. False: stop, keep the best so far.
Progress = Callable[[str, float], Any]
