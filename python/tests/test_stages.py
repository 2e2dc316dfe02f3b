"""Single stages on arrays, held against what can be worked out by hand."""

import itertools

import numpy as np
import pytest

import strandline

SQUARE = np.array([[0, 0], [4, 0], [4, 3], [0, 3.0]])
HOLE = np.array([[1.5, 1], [2.5, 1], [2.5, 2], [1.5, 2.0]])


def area(ring):
    x, y = np.asarray(ring).T
    return abs(np.dot(x, np.roll(y, -1)) - np.dot(y, np.roll(x, -1))) / 2


@pytest.mark.parametrize("style", ["rings", "spiral", "zigzag"])
def test_a_fill_rakes_the_area_and_not_the_hole(style):
    filled = strandline.fill(SQUARE, [HOLE], width=0.2, style=style)
    assert filled.account["area"] == pytest.approx(area(SQUARE) - area(HOLE))
    assert filled.account["coverage"] > 0.95 and filled.account["spill"] < 0.05
    for stroke in filled.strokes:
        inside = np.all((stroke > HOLE.min(0) + 0.1) & (stroke < HOLE.max(0) - 0.1), axis=1)
        assert not inside.any()


def test_a_zigzag_goes_in_the_direction_that_is_asked_for():
    filled = strandline.fill(SQUARE, width=0.2, style="zigzag", direction=np.pi / 2)
    steps = np.concatenate([np.diff(stroke, axis=0) for stroke in filled.strokes])
    lengths = np.hypot(*steps.T)
    assert lengths[np.abs(steps[:, 0]) < 1e-6].sum() > 0.6 * lengths.sum()


def test_pins_that_lift_have_masks():
    filled = strandline.fill(SQUARE, width=0.42, pins=7)
    masks = {move.pins for move in filled.moves}
    assert (1 << 7) - 1 in masks and len(masks) > 1 and max(masks) < 1 << 7


def test_a_fill_says_what_it_did_otherwise():
    with pytest.warns(strandline.StrandlineWarning, match="parts nothing"):
        filled = strandline.fill(SQUARE, width=0.2, style="zigzag", cuts=[[[9, 9], [10, 9]]])
    assert len(filled.warnings) == 1


@pytest.mark.parametrize("call, place", [
    ({"width": 0.0}, "width"), ({"width": -1}, "width"), ({"width": 0.2, "style": "dots"}, "style"),
    ({"width": 0.2, "spacing": 0.3}, "spacing"), ({"width": 0.2, "pins": 33}, "pins"),
    ({"width": 9.0, "narrow": "warn"}, "polygon"), ({"width": 0.2, "vehicle": "horse"}, "robot"),
])
def test_a_fill_refuses_by_name(call, place):
    with pytest.raises(strandline.InputError) as caught:
        strandline.fill(SQUARE, **call)
    assert place in caught.value.place


def legs(points_at, steps, start=None):
    """Length of the straight legs of open lines in this order."""
    at, total = start, 0.0
    for element, backwards in steps:
        first, last = points_at[element][0], points_at[element][-1]
        if backwards:
            first, last = last, first
        if at is not None:
            total += np.hypot(*(first - at))
        at = last
    return total


def test_a_tour_is_the_best_of_all_tours():
    rng = np.random.default_rng(5)
    lines = [rng.uniform(0, 10, (3, 2)) for _ in range(5)]
    best = min(legs(lines, list(zip(order, turned)), np.zeros(2))
               for order in itertools.permutations(range(5))
               for turned in itertools.product((False, True), repeat=5))
    tour = strandline.tour(lines, start=(0, 0))
    assert tour.length == pytest.approx(best) and tour.proven_optimal and tour.reproducible
    assert sorted(tour.order) == list(range(5))
    assert legs(lines, list(zip(tour.order, tour.reversed)), np.zeros(2)) == pytest.approx(best)


def test_a_tour_keeps_the_rules_it_is_given():
    lines = [np.array([[k, 0], [k, 1.0]]) for k in range(6)]
    tour = strandline.tour(lines, before=[(5, 0)], groups=[(1, 4)], links=[((2, 0), (3, 0))])
    place = {int(element): k for k, element in enumerate(tour.order)}
    assert place[5] < place[0] and abs(place[1] - place[4]) == 1 and abs(place[2] - place[3]) == 1


def test_closed_lines_may_be_entered_on_their_edges():
    square = np.array([[0, 0], [4, 0], [4, 4], [0, 4.0]])
    tour = strandline.tour([square], closed=True, start=(2, -3), on_edges=True)
    assert tour.length == pytest.approx(np.hypot(2, 3))
    assert tour.length_on_edges == pytest.approx(3) and tour.at[0] == pytest.approx((2, 0))


@pytest.mark.parametrize("call, place", [
    ({"elements": [[[0, 0]]]}, "element 0"), ({"elements": [[[0, 0, 0]]]}, "elements[0]"),
    ({"elements": [[[0, 0], [np.nan, 1]]]}, "elements[0]"),
    ({"elements": [[[0, 0], [1, 1]]], "method": "magic"}, "method"),
    ({"elements": [[[0, 0], [1, 1]]], "closed": [True, False]}, "closed"),
    ({"elements": [[[0, 0], [1, 1]]] * 2, "before": [(0, 1), (1, 0)]}, ""),
])
def test_a_tour_refuses_by_name(call, place):
    with pytest.raises(strandline.InputError) as caught:
        strandline.tour(**call)
    assert place in caught.value.place and caught.value.reason


@pytest.mark.filterwarnings("ignore:.*the curve is bounded")
@pytest.mark.parametrize("style", ["bounded", "fair", "spiro", "bezier"])
def test_a_connection_meets_its_poses_within_the_limits(style):
    curve = strandline.connect((0, 0, 0), (3, 1, np.pi / 2), radius=0.5, sharpness=10, style=style)
    assert (curve.x[0], curve.y[0], curve.heading[0]) == pytest.approx((0, 0, 0))
    assert (curve.x[-1], curve.y[-1]) == pytest.approx((3, 1), abs=1e-6)
    assert np.cos(curve.heading[-1]) == pytest.approx(0, abs=1e-6)
    assert np.abs(curve.curvature).max() <= 2 + 1e-9
    assert np.abs(curve.pieces[:, 2]).max() <= 10 + 1e-6
    assert curve.pieces[:, 0].sum() == pytest.approx(curve.length) == curve.s[-1]


def test_a_connection_goes_round_an_obstacle():
    block = [[1.5, -0.5], [2.5, -0.5], [2.5, 0.5], [1.5, 0.5]]
    curve = strandline.connect((0, 0, 0), (4, 0, 0), obstacles=[block], clearance=0.3)
    assert curve.round_obstacles and curve.failure is None
    away = np.hypot(np.clip(np.abs(curve.x - 2) - 0.5, 0, None), np.clip(np.abs(curve.y) - 0.5, 0, None))
    assert away.min() >= 0.3 - 1e-6


def test_where_no_way_is_found_it_is_said():
    block = [[3.5, -0.5], [4.5, -0.5], [4.5, 0.5], [3.5, 0.5]]
    with pytest.warns(strandline.StrandlineWarning, match="nearer"):
        curve = strandline.connect((0, 0, 0), (4, 0, 0), obstacles=[block], clearance=0.3)
    assert curve.failure


@pytest.mark.parametrize("call, place", [
    (((0, 0), (1, 1, 0), {}), "start"), (((0, 0, 0), (1, 1, 0), {"radius": 0}), "connect"),
    (((0, 0, 0), (1, 1, 0), {"style": "wavy"}), "style"),
    (((0, 0, np.inf), (1, 1, 0), {}), "start"), (((0, 0, 0), (1, 1, 0), {"step": -1}), "step"),
])
def test_a_connection_refuses_by_name(call, place):
    start, end, more = call
    with pytest.raises(strandline.InputError) as caught:
        strandline.connect(start, end, **more)
    assert caught.value.place == place


def test_on_a_circle_the_robot_drives_a_circle():
    angle = np.linspace(0, 3 * np.pi / 2, 400)
    path = strandline.convert(2 * np.column_stack([np.cos(angle), np.sin(angle)]), robot="beachbot")
    offset = strandline.robot("beachbot")["rake_offset"]
    assert np.allclose(np.hypot(path.x, path.y), np.sqrt(4 - offset**2), atol=1e-3)
    assert np.allclose(np.hypot(path.rake_x, path.rake_y), 2, atol=1e-3)
    assert np.allclose(path.curvature, 1 / np.sqrt(4 - offset**2), atol=1e-2)
    assert (path.pins == 127).all() and path.warnings == []


def test_a_path_that_no_rake_can_follow_is_said():
    with pytest.warns(strandline.StrandlineWarning, match="cannot follow"):
        angle = np.linspace(0, 6 * np.pi, 600)
        path = strandline.convert(0.1 * np.column_stack([np.cos(angle), np.sin(angle)]))
    assert path.warnings


@pytest.mark.parametrize("pins", [128, -1, 1.5, [1, 2], "all", [[1, 2, 3]] * 2])
def test_pins_that_there_are_not_are_refused(pins):
    with pytest.raises(strandline.InputError):
        strandline.convert([[0, 0], [1, 0], [2, 0]], pins=pins)
