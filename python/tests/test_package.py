"""The package as such: its types, its wheel, its examples, its page."""

import email
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

import pytest

import strandline
from conftest import PACKAGE, ROOT

#: Under a Python that is not told where the package is.
CLEAN = {key: value for key, value in os.environ.items() if key not in ("PYTHONPATH", "STRANDLINE_PACKAGE")}


def run(*command, **more):
    done = subprocess.run(command, capture_output=True, text=True, **more)
    assert done.returncode == 0, done.stdout + done.stderr
    return done.stdout


@pytest.fixture(scope="module")
def wheel(tmp_path_factory):
    """Packed from the module that is built already, by the package's own backend, with pip."""
    folder = tmp_path_factory.mktemp("wheel")
    core = strandline._core.__file__
    run(sys.executable, "-m", "pip", "-q", "wheel", ROOT / "python", "--no-index", "--no-deps", "-w", folder,
        "--config-settings", f"core={core}", env=CLEAN)
    (file,) = folder.glob("*.whl")
    return file


def test_the_wheel_holds_what_its_record_says(wheel):
    with zipfile.ZipFile(wheel) as archive:
        assert archive.testzip() is None
        names = archive.namelist()
        info = next(name for name in names if name.endswith("METADATA")).rsplit("/", 1)[0]
        record = archive.read(f"{info}/RECORD").decode().split()
        assert sorted(line.split(",")[0] for line in record) == sorted(names)
        metadata = email.message_from_bytes(archive.read(f"{info}/METADATA"))
    assert metadata["Name"] == "strandline" and metadata["Version"] == strandline.__version__
    assert {"strandline/__init__.py", "strandline/_core.pyi", "strandline/py.typed"} <= set(names)
    assert f"strandline/_core{sysconfig.get_config_var('EXT_SUFFIX')}" in names


def test_a_fresh_environment_takes_the_wheel_plans_and_gives_it_up(wheel, tmp_path):
    # Debian's NumPy is in sight; nothing is fetched. pip itself is the system's, so that making it is quick.
    run(sys.executable, "-m", "venv", "--without-pip", "--system-site-packages", tmp_path / "venv", env=CLEAN)
    python = tmp_path / "venv" / "bin" / "python"
    pip = (python, "-m", "pip", "-q", "--disable-pip-version-check")
    run(*pip, "install", "--no-index", wheel, env=CLEAN)
    said = run(python, "-c", "import strandline; print(strandline.__file__); "
               "print(strandline.plan_text('l', canvas=3).figures['strokes'])", cwd=tmp_path, env=CLEAN)
    assert said.startswith(str(tmp_path / "venv")) and said.split()[-1] == "1"
    run(*pip, "uninstall", "-y", "strandline", env=CLEAN)
    gone = subprocess.run([python, "-c", "import strandline"], cwd=tmp_path, env=CLEAN, capture_output=True)
    assert gone.returncode != 0


def test_an_editable_install_is_the_folder_that_cmake_fills(tmp_path):
    sys.path.insert(0, str(ROOT / "python" / "backend"))
    import strandline_build

    name = strandline_build.build_editable(tmp_path, {"core": strandline._core.__file__})
    with zipfile.ZipFile(tmp_path / name) as archive:
        assert archive.read("strandline.pth").decode().strip() == str(PACKAGE.resolve())


def test_a_module_of_another_python_is_not_packed(tmp_path):
    sys.path.insert(0, str(ROOT / "python" / "backend"))
    import strandline_build

    with pytest.raises(SystemExit, match="is not called _core"):
        strandline_build.build_wheel(tmp_path, {"core": "_core.cpython-27.so"})


def test_stubs_and_module_have_the_same_names(tmp_path):
    """By mypy's stubtest; what it may pass over are types that only pybind11 has."""
    allowed = tmp_path / "allowed.txt"
    classes = ("Call", "FillCall", "Planned", "Simulation")
    allowed.write_text("".join(f"strandline._core.{name}\n" for name in classes)
                       + "strandline._core.(Planned|Simulation).__init__\n")
    environment = {**os.environ, "MYPY_CACHE_DIR": str(PACKAGE / ".mypy_cache")}
    config = ROOT / "python" / "pyproject.toml"
    said = run(sys.executable, "-m", "mypy.stubtest", "strandline._core", "--allowlist", allowed,
               "--mypy-config-file", config, cwd=PACKAGE, env=environment)
    assert "Success" in said
    # It can fail: a name that there is not.
    stub = (PACKAGE / "strandline" / "_core.pyi").read_text()
    copy = tmp_path / "strandline"
    copy.mkdir()
    for file in (PACKAGE / "strandline").iterdir():
        if file.is_file() and file.name != "_core.pyi":
            (copy / file.name).symlink_to(file.resolve())
    (copy / "_core.pyi").write_text(stub + "def no_such_thing() -> None: ...\n")
    done = subprocess.run([sys.executable, "-m", "mypy.stubtest", "strandline._core", "--allowlist", allowed,
                           "--mypy-config-file", config], cwd=tmp_path, env=environment,
                          capture_output=True, text=True)
    assert "no_such_thing" in done.stdout and done.returncode != 0


def test_the_package_is_typed_throughout():
    environment = {**os.environ, "MYPY_CACHE_DIR": str(PACKAGE / ".mypy_cache")}
    run(sys.executable, "-m", "mypy", "--config-file", ROOT / "python" / "pyproject.toml", "strandline",
        cwd=PACKAGE, env=environment)


def test_every_public_name_is_listed_and_explained():
    public = {name for name in vars(strandline) if not name.startswith("_")}
    modules = {name for name in public if type(getattr(strandline, name)).__name__ == "module"}
    assert public - modules == set(strandline.__all__) - {"__version__"}
    page = (ROOT / "docs" / "python.md").read_text()
    for name in set(strandline.__all__) - {"__version__"}:
        if name != "MOTIONS":
            assert getattr(strandline, name).__doc__, name
        assert re.search(rf"\b{name}\b", page), f"docs/python.md does not name {name}"


def blocks(page):
    """The Python of a page, a block each, with the line it stands at."""
    text = (ROOT / page).read_text()
    for block in re.finditer(r"^```python\n(.*?)^```$", text, re.M | re.S):
        yield text[:block.start(1)].count("\n"), block.group(1)


@pytest.mark.filterwarnings("ignore::strandline.StrandlineWarning")
def test_the_code_of_the_readme_runs(monkeypatch):
    monkeypatch.chdir(ROOT)
    found = list(blocks("README.md"))
    assert found
    for line, code in found:
        exec(compile("\n" * line + code, "README.md", "exec"), {})


@pytest.mark.filterwarnings("ignore::strandline.StrandlineWarning")
def test_the_code_of_the_page_runs(tmp_path, monkeypatch, drawings):
    monkeypatch.chdir(tmp_path)
    for name in ("lighthouse.svg", "sailboat.svg"):
        (tmp_path / name).write_bytes((drawings / name).read_bytes())
    found = list(blocks("docs/python.md"))
    assert len(found) > 5
    names = {}
    for line, code in found:
        exec(compile("\n" * line + code, "docs/python.md", "exec"), names)


def test_tours_are_compared(drawings):
    said = run(sys.executable, ROOT / "python" / "examples" / "compare_tours.py", drawings / "starfish.svg",
               "--seconds", "0.3", env={**os.environ, "PYTHONPATH": str(PACKAGE)})
    rows = dict(re.findall(r"^  ([a-zA-Z].*?) {2,}(\d+\.\d+)", said, re.M))
    ours = float(rows["strandline.tour"])
    assert all(ours <= float(length) + 1e-3 for name, length in rows.items() if not name.startswith("bound"))
    bounds = [float(length) for name, length in rows.items() if name.startswith("bound")]
    assert len(bounds) == 2 and all(bound <= ours + 1e-3 for bound in bounds)


def test_an_own_robot_is_planned_for(tmp_path):
    said = run(sys.executable, ROOT / "python" / "examples" / "own_robot.py", "--out", tmp_path,
               env={**os.environ, "PYTHONPATH": str(PACKAGE)})
    assert "a wrong profile is refused" in said and "not sound" not in said
    assert (tmp_path / "sand.png").read_bytes().startswith(b"\x89PNG")
    assert strandline.robot(tmp_path / "mine.toml")["pins"] == 9
    assert strandline.load(tmp_path / "plan.json").robot["name"] == "broad"
