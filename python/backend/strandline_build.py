"""Build backend (PEP 517, PEP 660) of the Python package: CMake builds the module, this packs the wheel.

In-tree, standard library only, no network. What CMake finds decides what is built: see docs/python.md.

Config settings (pip install ./python --config-settings KEY=VALUE):
    core   a compiled module to pack instead of building one
    build  the build folder; default build/wheel of the project
    jobs   compilers at once; default: as many as there are processors
"""

import base64
import csv
import hashlib
import io
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import zipfile

HERE = pathlib.Path(__file__).resolve().parents[1]
PROJECT = HERE.parent
#: The first that a zip can say: wheels of the same sources are the same, byte for byte.
EPOCH = (1980, 1, 1, 0, 0, 0)


def _version():
    text = (PROJECT / "CMakeLists.txt").read_text()
    return re.search(r"project\(strandline VERSION ([0-9.]+)", text).group(1)


def _tag():
    python = f"cp{sys.version_info.major}{sys.version_info.minor}"
    return f"{python}-{python}-{sysconfig.get_platform().replace('-', '_').replace('.', '_')}"


def _metadata():
    return (f"Metadata-Version: 2.1\nName: strandline\nVersion: {_version()}\n"
            "Summary: A drawing becomes one drivable path for a drawing robot\n"
            "License: GPL-3.0-or-later\nRequires-Python: >=3.9\nRequires-Dist: numpy\n")


def _wheel_file():
    return f"Wheel-Version: 1.0\nGenerator: strandline_build\nRoot-Is-Purelib: false\nTag: {_tag()}\n"


def _module_name():
    return "_core" + sysconfig.get_config_var("EXT_SUFFIX")


def _run(*command):
    print("+", *command, flush=True)
    try:
        subprocess.run(command, check=True)
    except FileNotFoundError:
        raise SystemExit(f"strandline: {command[0]} is not installed; docs/python.md lists what is needed") from None
    except subprocess.CalledProcessError as error:
        raise SystemExit(f"strandline: {command[0]} failed with {error.returncode}; its messages are above") from None


def _built_module(settings):
    """The compiled module: given, or built."""
    settings = settings or {}
    if settings.get("core"):
        core = pathlib.Path(settings["core"])
        if core.name != _module_name():
            raise SystemExit(f"strandline: {core} is not called {_module_name()}, as this Python wants it")
        return core
    folder = pathlib.Path(settings.get("build") or PROJECT / "build" / "wheel")
    jobs = str(settings.get("jobs") or os.cpu_count() or 1)
    _run("cmake", "-S", str(PROJECT), "-B", str(folder), "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
         "-DSTRANDLINE_PYTHON=ON", "-DSTRANDLINE_TESTS=OFF", "-DSTRANDLINE_BENCH=OFF", "-DSTRANDLINE_EDITOR=OFF",
         f"-DPython_EXECUTABLE={sys.executable}")
    _run("cmake", "--build", str(folder), "--target", "python_core", "--parallel", jobs)
    return folder / "python" / "strandline" / _module_name()


def _write_wheel(folder, files):
    """files: name in the wheel -> bytes."""
    version = _version()
    info = f"strandline-{version}.dist-info"
    files = {**files, f"{info}/METADATA": _metadata().encode(), f"{info}/WHEEL": _wheel_file().encode(),
             f"{info}/LICENSE": (PROJECT / "LICENSE").read_bytes()}
    record = io.StringIO()
    rows = csv.writer(record, lineterminator="\n")
    for name, content in files.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        rows.writerow((name, f"sha256={digest}", len(content)))
    rows.writerow((f"{info}/RECORD", "", ""))
    files[f"{info}/RECORD"] = record.getvalue().encode()
    wheel = f"strandline-{version}-{_tag()}.whl"
    with zipfile.ZipFile(pathlib.Path(folder) / wheel, "w", zipfile.ZIP_DEFLATED) as archive:
        for name, content in files.items():
            entry = zipfile.ZipInfo(name, EPOCH)
            entry.compress_type = zipfile.ZIP_DEFLATED
            entry.external_attr = (0o755 if name.endswith(".so") else 0o644) << 16
            archive.writestr(entry, content)
    return wheel


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    module = _built_module(config_settings)
    package = HERE / "strandline"
    files = {f"strandline/{path.name}": path.read_bytes() for path in sorted(package.iterdir())
             if path.suffix in (".py", ".pyi") or path.name == "py.typed"}
    files[f"strandline/{module.name}"] = module.read_bytes()
    return _write_wheel(wheel_directory, files)


def build_editable(wheel_directory, config_settings=None, metadata_directory=None):
    """The package as CMake lays it out: links to these Python files, beside the module."""
    folder = _built_module(config_settings).resolve().parents[1]
    return _write_wheel(wheel_directory, {"strandline.pth": f"{folder}\n".encode()})


class UnsupportedOperation(Exception):
    """What PEP 517 names it."""


def build_sdist(sdist_directory, config_settings=None):
    raise UnsupportedOperation("the package is built from a checkout of the whole project, which no source archive "
                               "of python/ would hold; use pip install ./python or pip wheel ./python")
