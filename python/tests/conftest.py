"""What the tests share: where things are, and a plan that is made once."""

import os
import pathlib
import sys

import pytest

ROOT = pathlib.Path(__file__).resolve().parents[2]
#: The package that CMake built; ctest says where.
PACKAGE = pathlib.Path(os.environ.get("STRANDLINE_PACKAGE", ROOT / "build" / "dev" / "python"))
sys.path.insert(0, str(PACKAGE))

import strandline  # noqa: E402

#: A bow, a ring and a square with a hole: lines and an area, quickly planned.
SMALL = """<svg xmlns="http://www.w3.org/2000/svg" width="200" height="200" viewBox="0 0 200 200">
  <g fill="none" stroke="#000" stroke-width="3">
    <path id="bow" d="M 20,20 C 60,60 120,-20 180,30"/>
    <circle id="ring" cx="50" cy="140" r="25"/>
  </g>
  <path id="tile" fill-rule="evenodd" d="M 110,90 h 70 v 70 h -70 z M 135,115 h 20 v 20 h -20 z"/>
</svg>"""


@pytest.fixture(scope="session")
def drawings():
    return ROOT / "drawings"


@pytest.fixture(scope="session")
def small():
    return strandline.plan_svg(SMALL, title="small.svg")


@pytest.fixture(scope="session")
def program():
    """The command line's program, of the same build."""
    path = pathlib.Path(os.environ.get("STRANDLINE_PROGRAM", ROOT / "build" / "dev" / "apps" / "cli" / "strandline"))
    if not path.exists():
        pytest.skip(f"{path} is not built")
    return path
