"""What follows from a plan: proof, simulation, exports."""

import json
import pathlib
import subprocess

import numpy as np
import pytest

import strandline
from strandline import Sand


def test_a_plan_is_sound_and_a_spoilt_one_is_not(tmp_path, small):
    report = small.check()
    assert report["sound"] and report["faults"] == [] and report["fidelity"]["coverage"] > 0.9
    small.save(tmp_path / "plan.json")
    text = json.loads((tmp_path / "plan.json").read_text())
    text["samples"]["x"][100] += 0.05
    (tmp_path / "plan.json").write_text(json.dumps(text))
    assert not strandline.load(tmp_path / "plan.json").check()["sound"]


def test_the_sand_is_raked_where_strokes_went(small):
    sim = small.simulate()
    assert sim.report["coverage"] > 0.9 and not sim.lost
    rows, columns = sim.sand.shape
    assert (columns, rows) == pytest.approx(np.array(small.canvas) / sim.cell, abs=1)
    assert sim.extent == pytest.approx((0, 14, 0, 14), abs=sim.cell)
    for stroke in small.strokes:
        i, j = (stroke.points / sim.cell).astype(int).T
        assert (sim.sand[j, i] & Sand.RAKED).mean() > 0.95
    raked = (sim.sand & Sand.RAKED).astype(bool)
    wanted = (sim.sand & (Sand.WANTED_FILL | Sand.WANTED_LINE)).astype(bool)
    assert (raked & wanted).sum() / (raked | wanted).sum() == pytest.approx(
        sim.report["intersection_over_union"], abs=0.02)
    assert sim.height.shape == sim.sand.shape and sim.height.min() < 0
    assert sim.log["t"].shape == (0,)


def test_a_controller_with_noise_draws_worse_and_the_same_for_a_seed(small):
    exact = small.simulate()
    once, again, other = (small.simulate(noise=0.02, seed=seed) for seed in (7, 7, 8))
    assert once.report == again.report != other.report
    assert once.report["intersection_over_union"] < exact.report["intersection_over_union"]
    assert len(once.log["t"]) == len(once.log["off"]) > 100


def test_the_sand_is_shown(small):
    sim = small.simulate()
    picture = sim.picture(300)
    assert picture.shape == (300, 300, 3) and picture.dtype == np.uint8 and picture.std() > 1
    assert not np.array_equal(picture, sim.picture(300, flaws=True))
    assert sim.png(100).startswith(b"\x89PNG") and sim._repr_png_().startswith(b"\x89PNG")
    assert sim.gif(64, seconds=1).startswith(b"GIF89a")


@pytest.mark.parametrize("call, place", [
    ({"seed": -1}, "seed"), ({"seed": 2**64}, "seed"),
    ({"noise": -1}, "noise"), ({"delay": 3}, "delay"), ({"cell": -0.1}, "cell"), ({"cell": 2}, "cell"),
])
def test_a_simulation_refuses_by_name(small, call, place):
    with pytest.raises(strandline.InputError) as caught:
        small.simulate(**call)
    assert place in caught.value.place


@pytest.mark.filterwarnings("ignore::strandline.StrandlineWarning")
@pytest.mark.parametrize("format", [row["name"] for row in strandline.formats()])
def test_every_format_is_written(tmp_path, small, format):
    suffixes = next(row["suffixes"] for row in strandline.formats() if row["name"] == format)
    files = small.export(format)
    assert list(files) == suffixes and all(files.values())
    last = suffixes[-1][suffixes[-1].rindex("."):]
    names = small.export(format, tmp_path / f"plan{last}")
    assert [pathlib.Path(name).read_bytes() for name in names] == list(files.values())


def test_exports_are_told_and_tell(small):
    with pytest.warns(strandline.StrandlineWarning, match="latitude"):
        nowhere = small.export("geojson")
    there = small.export("geojson", site_latitude=47.37, settings={"site.longitude": 8.54})
    assert json.loads(there[".geojson"]) != json.loads(nowhere[".geojson"])
    for call, place in [(("stone",), "format stone"), (("csv", "/nowhere/plan.csv"), "/nowhere/plan.csv")]:
        with pytest.raises(strandline.InputError) as caught:
            small.export(*call)
        assert caught.value.place == place
    with pytest.raises(strandline.InputError):
        small.export("gcode", fill_style="zigzag")


def test_the_program_reads_what_python_saves(tmp_path, small, program):
    small.save(tmp_path / "plan.json")
    csv = subprocess.run([program, "-q", "export", tmp_path / "plan.json", "--format", "csv"],
                         check=True, capture_output=True).stdout
    assert csv == small.export("csv")[".csv"]


def test_the_program_makes_the_same_plan(tmp_path, drawings, program):
    subprocess.run([program, "-q", "plan", drawings / "sailboat.svg", "-o", tmp_path / "plan.json",
                    "--set", "fill.style=zigzag"], check=True)
    assert strandline.load(tmp_path / "plan.json").export("csv") == strandline.plan(
        drawings / "sailboat.svg", fill_style="zigzag").export("csv")
