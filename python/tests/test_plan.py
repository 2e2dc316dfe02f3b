"""Plans: how they are made, what they hold, how they are refused."""

import json
import pathlib
import pickle

import numpy as np
import pytest

import strandline
from conftest import SMALL


def test_a_path_and_its_text_give_the_same_plan(tmp_path, small):
    file = tmp_path / "small.svg"
    file.write_text(SMALL)
    for path in (file, str(file)):
        assert strandline.plan(path).export("beachbot") == small.export("beachbot")


def test_the_trajectory_is_the_csv_of_the_plan(small):
    trajectory = small.trajectory
    lines = small.export("csv")[".csv"].decode().splitlines()
    names = lines[0].split(",")
    table = np.array([[float(cell) for k, cell in enumerate(line.split(",")) if names[k] != "motion"]
                      for line in lines[1:]])
    names.remove("motion")
    assert len(trajectory) == len(table) > 100
    for name in ("s", "t", "x", "y", "heading", "curvature", "v", "omega", "rake_x", "rake_y", "pins", "stroke"):
        column = getattr(trajectory, name)
        assert column.shape == (len(table),)
        assert np.abs(column - table[:, names.index(name)]).max() < 1e-6, name
    assert not trajectory.x.flags.writeable


def test_the_rake_trails_the_turning_point_by_its_offset(small):
    t = small.trajectory
    offset = small.robot["rake_offset"]
    assert np.allclose(t.rake_x, t.x - offset * np.cos(t.heading), atol=1e-9)
    assert np.allclose(t.rake_y, t.y - offset * np.sin(t.heading), atol=1e-9)


def test_strokes_and_elements_say_what_is_drawn(small):
    elements = {e.id: e for e in small.elements}
    assert set(elements) == {"bow", "ring", "tile"}
    assert elements["bow"].kind == "line" and not elements["bow"].closed
    assert elements["ring"].closed
    tile = elements["tile"]
    assert tile.kind == "area" and tile.points.shape == (4, 2) and len(tile.holes) == 1
    assert small.figures["strokes"] == len(small.strokes)
    assert {small.elements[s.element].id for s in small.strokes if s.fill} == {"tile"}
    for stroke in small.strokes:
        assert stroke.points.shape[1] == 2
    drawn = sum(np.hypot(*np.diff(s.points, axis=0).T).sum() for s in small.strokes)
    assert drawn == pytest.approx(small.figures["drawn"], rel=0.01)


def test_connections_keep_the_least_radius(small):
    assert len(small.connections) == len(small.strokes) - 1
    for connection in small.connections:
        assert np.abs(connection.states[:, 3]).max() <= 1 / small.robot["min_radius"] + 1e-9


@pytest.mark.parametrize("more", [
    {"settings": {"fill.style": "zigzag", "fill.spacing": "36cm", "fill.direction": "30deg"}},
    {"settings": {"fill.style": "zigzag", "fill.spacing": 0.36, "fill.direction": np.radians(30)}},
    {"fill_style": "zigzag", "fill_spacing": np.float64(0.36), "fill_direction": np.radians(30)},
])
def test_settings_mean_the_same_however_they_are_given(more):
    plan = strandline.plan_svg(SMALL, **more)
    assert plan.settings["fill.style"] == "zigzag"
    assert float(plan.settings["fill.spacing"]) == 0.36
    assert plan.settings["fill.direction"].endswith("rad")
    assert float(plan.settings["fill.direction"][:-3]) == pytest.approx(np.pi / 6)


def test_a_settings_file_is_read_and_the_call_wins(tmp_path):
    file = tmp_path / "mine.toml"
    file.write_text('robot = "plotter"\n[canvas]\nwidth = "2m"\nheight = "1m"\n[fill]\nstyle = "zigzag"\n')
    plan = strandline.plan_svg(SMALL, config=file, fill_style="spiral")
    assert plan.robot["name"] == "plotter" and plan.canvas == (2, 1)
    assert plan.settings["fill.style"] == "spiral"


@pytest.mark.parametrize("canvas, size", [("20x10", (20, 10)), ((20, 10), (20, 10)), (9, (9, 9))])
def test_a_canvas_is_a_text_or_metres(canvas, size):
    assert strandline.plan_svg(SMALL, canvas=canvas, tour_method="nearest").canvas == size


def test_a_robot_may_be_a_dict_of_its_fields():
    own = {"base": "turf", "name": "mine", "min_radius": 1.5, "wheels": [(0, 0.3, 0.1), (0, -0.3, 0.1)],
           "can_pivot": True}
    profile = strandline.robot(own)
    assert profile["min_radius"] == 1.5 and profile["wheels"] == [[0, 0.3, 0.1], [0, -0.3, 0.1]]
    again = strandline.robot(profile)
    assert again == profile
    plan = strandline.plan_svg(SMALL, robot=own, robot_speed=0.33)
    assert plan.robot["name"] == "mine" and plan.robot["speed"] == 0.33


def test_fences_are_arrays_or_texts(small):
    # Right on the robot's longest way.
    way = max(small.connections, key=lambda connection: len(connection.states)).states
    fence = way[len(way) // 2, :2].round(2) + [[-0.3, -0.3], [0.3, -0.3], [0.3, 0.3], [-0.3, 0.3]]
    by_array = strandline.plan_svg(SMALL, keep_out=fence)
    by_text = strandline.plan_svg(SMALL, keep_out=" ".join(f"{x},{y}" for x, y in fence))
    assert by_array.export("csv") == by_text.export("csv") != small.export("csv")


def test_what_fences_from_maps_take_for_granted_stays_with_edited_plans(tmp_path):
    pole = tmp_path / "field.geojson"
    pole.write_text('{"type": "Polygon", "coordinates": '
                    '[[[-0.001, -0.001], [0.001, -0.001], [0.001, 0.001], [-0.001, 0.001], [-0.001, -0.001]]]}')
    plan = strandline.plan_svg(SMALL, border=pole)
    assert plan.warnings[0].place == str(pole) and "latitude 0" in plan.warnings[0].reason
    edited = plan.edited({"edit": "direction", "element": "bow", "direction": "forward"})
    for later in (edited, edited.edited(fill_style="zigzag"), edited.edited(draft=True)):
        assert later.warnings.count(plan.warnings[0]) == 1


def test_the_drive_begins_and_ends_where_it_is_told():
    plan = strandline.plan_svg(SMALL, park=(1, 1, np.pi / 2), exit="parked")
    t = plan.trajectory
    for k in (0, -1):
        assert (t.x[k], t.y[k]) == pytest.approx((1, 1), abs=1e-6)


def test_edits_change_what_they_touch(small):
    before = [s.reversed for s in small.strokes if small.elements[s.element].id == "bow"][0]
    edit = {"edit": "direction", "element": "bow", "direction": "forward" if before else "backward"}
    edited = small.edited(edit)
    after = [s.reversed for s in edited.strokes if edited.elements[s.element].id == "bow"][0]
    assert after != before and edited.edits == [edit] and small.edits == []
    fresh = strandline.plan_svg(SMALL, title="small.svg", edits=edit)
    assert fresh.export("csv") == edited.export("csv")
    assert edited.edited(keep=False).export("csv") == small.export("csv")
    assert edited.edited(fill_style="zigzag").settings["fill.style"] == "zigzag"


def test_an_edit_whose_place_is_gone_is_said(small):
    edited = small.edited({"edit": "entry", "at": ["nose", 0]})
    assert len(edited.idle_edits) == 1 and "nose" in edited.idle_edits[0]


def test_a_draft_says_that_it_is_one(small):
    draft = small.edited({"edit": "hint", "element": "ring", "name": "ink", "value": "off"}, draft=True)
    assert {draft.elements[s.element].id for s in draft.strokes} == {"bow", "tile"}
    assert not draft.figures["reproducible"]


def test_a_saved_plan_is_the_same_plan(tmp_path, small):
    file = tmp_path / "small.json"
    small.save(file)
    again = strandline.load(file)
    assert again.export("csv") == small.export("csv") and again.figures == small.figures
    assert pickle.loads(pickle.dumps(small)).export("csv") == small.export("csv")
    with pytest.raises(strandline.InputError, match="does not hold the drawing"):
        again.edited()


def test_a_plan_is_cut_and_gone_on_with(small):
    halves = small.split(seconds=small.figures["time"] / 2)
    assert len(halves) > 1
    assert sum(h.figures["strokes"] for h in halves) == small.figures["strokes"]
    last = len(small.strokes) - 1
    begin = float(small.trajectory.t[small.trajectory.stroke == last][0])
    assert len(small.resume(begin + 0.01).strokes) == 1
    first = small.elements[small.strokes[0].element].id
    assert len(small.resume(first).strokes) == len(small.strokes)
    x, y = small.strokes[-1].points[0]
    assert len(small.resume((x, y)).strokes) < len(small.strokes)


def test_words_are_planned():
    plan = strandline.plan_text("ab\nc", height=2, canvas=14)
    letters = {e.id.split(".")[3] for e in plan.elements}
    assert letters == {"a", "b", "c"}
    assert "rowmans" in [font["name"] for font in strandline.fonts()]


def test_notebooks_get_pictures(small):
    assert small._repr_svg_().startswith("<") and "</svg>" in small._repr_svg_()
    assert small._repr_png_().startswith(b"\x89PNG")
    assert "small.svg" in repr(small) and "beachbot" in repr(small)


def test_errors_carry_place_reason_and_remedy(tmp_path):
    with pytest.raises(strandline.InputError) as caught:
        strandline.plan(tmp_path / "none.svg")
    assert caught.value.place == str(tmp_path / "none.svg") and "No such file" in caught.value.reason
    (tmp_path / "broken.svg").write_text("<svg><path d=")
    with pytest.raises(strandline.InputError) as caught:
        strandline.plan(tmp_path / "broken.svg")
    assert caught.value.place.startswith(str(tmp_path / "broken.svg")) and caught.value.reason
    assert str(caught.value).startswith(caught.value.place)
    assert pickle.loads(pickle.dumps(caught.value)).reason == caught.value.reason


@pytest.mark.parametrize("call, place", [
    ({"fill_stile": "zigzag"}, "fill.stile"),
    ({"fill_style": "zickzack"}, "fill.style"),
    ({"settings": {"fill.spacing": "wide"}}, "fill.spacing"),
    ({"fill_spacing": float("nan")}, "fill.spacing"),
    ({"robot": "beachbott"}, "robot"),
    ({"robot": {"min_radius": -1}}, "robot"),
    ({"robot": {"wings": 2}}, "robot"),
    ({"place": "somewhere"}, "place somewhere"),
    ({"canvas": "0x5"}, "canvas"),
    ({"canvas": (1, 2, 3)}, "canvas"),
    ({"keep_out": [[[0, 0], [1, float("inf")], [2, 2]]]}, "keep_out[0]"),
    ({"edits": [{"edit": "jump"}]}, "edits"),
    ({"edits": [{"edit": "draw", "x": float("nan")}]}, ""),
])
def test_a_wrong_value_is_refused_by_its_name(call, place):
    with pytest.raises(strandline.InputError) as caught:
        strandline.plan_svg(SMALL, **call)
    assert place in caught.value.place, str(caught.value)
    assert caught.value.reason


@pytest.mark.parametrize("call", [
    {"rowbot": "beachbot"}, {"robot": 3}, {"canvas": object()}, {"settings": ["fill.style=zigzag"]},
    {"fill_spacing": None}, {"park": 3}, {"progress": 3}, {"edits": [object()]},
])
def test_a_value_of_another_kind_is_a_type_error(call):
    with pytest.raises(TypeError):
        strandline.plan_svg(SMALL, **call)
    with pytest.raises(TypeError):
        strandline.plan_svg(pathlib.Path("small.svg"))


def test_lists_say_what_there_is():
    keys = {row["key"]: row for row in strandline.settings()}
    assert keys["fill.style"]["choices"] == ["rings", "spiral", "zigzag"]
    assert "beachbot" in strandline.robots()
    assert strandline.robot("beachbot")["pins"] == 7
    assert 'name = "beachbot"' in strandline.robot_toml("beachbot")
    formats = {row["name"]: row["suffixes"] for row in strandline.formats()}
    assert formats["csv"] == [".csv"] and formats["beachbot"] == ["_robot.txt", "_rake.txt"]
    assert json.dumps(strandline.settings())
