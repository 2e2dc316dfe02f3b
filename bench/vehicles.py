"""The fill-vehicles section of the bench: the shapes of the fill tables as drawings that beachbot drives, with and without turns on the spot.

A shape becomes an SVG of one black area, so large that its rake is beachbot's, and goes through plan and check. What is raked
is measured from the plan's samples alone (tracks_of, raked) and shares nothing with the program: cells of w/16,
passes as the fill judge counts them, but of true pins, which stand across the heading at the rake's centre, not
across its path. Needs numpy.
"""
import json, math
from dataclasses import dataclass
from multiprocessing import Pool

from fill import CORES, LARGE, cases_of, median
from harness import run, table

RAKE, PINS = 0.42, 7  # metres; beachbot's
MARGIN = 0.5  # metres of canvas round the shape
CELLS = 16  # a rake width
TURN = 0.5  # radians from the drawing's axes to the cells': edges along rows of cells would all be rounded to one side
VEHICLES = {"beachbot without turns on the spot (its profile)": [],
            "beachbot with turns on the spot": ["--set", "robot.can_pivot=on"]}
SHOWN = ("coverage", "overdraw", "spill")


@dataclass
class Driven:
    """of one shape and vehicle; areas are shares of the shape's"""
    wrong: str = ""
    coverage: float = math.nan
    overdraw: float = math.nan
    spill: float = math.nan
    planned: float = math.nan  # E as the plan states it for strokes that are followed exactly
    ratio: float = math.nan  # metres with any pin down x width / area
    up: float = math.nan  # metres of the turning point in connections, corner loops and leads
    loops: int = 0
    hops: int = 0
    faults: int = 0
    over: float = math.nan  # m^2 of finished ground under the wheels, by check
    checked: tuple = ()  # check's coverage, overdraw, spill

    @property
    def error(self): return 1 - self.coverage + self.overdraw + self.spill


# ---- the drawing -------------------------------------------------------------------------------------------------

def placed(case):
    """-> rings in metres, y up, lower left corner at (MARGIN, MARGIN), and the box's size"""
    data = json.loads(case.text)
    scale = RAKE / data["width"]
    rings = [data["polygon"]["outer"], *data["polygon"].get("holes", [])]
    left, low = (min(p[axis] for r in rings for p in r) for axis in (0, 1))
    rings = [[(MARGIN + scale * (x - left), MARGIN + scale * (y - low)) for x, y in r] for r in rings]
    return rings, *(max(p[axis] for r in rings for p in r) - MARGIN for axis in (0, 1))


def svg_of(rings, width, height):
    outline = " ".join("M " + " ".join(f"{x - MARGIN:.7f},{height + MARGIN - y:.7f}" for x, y in r) + " Z" for r in rings)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{1000 * width:.4f}mm" height="{1000 * height:.4f}mm" '
            f'viewBox="0 0 {width:.7f} {height:.7f}"><path id="area" fill-rule="evenodd" d="{outline}"/></svg>')


# ---- true pin tracks: in the workers, so that the section can say that numpy is missing -----------------------------

def column(samples, name):
    """a column of the plan, runs written out"""
    import numpy as np
    runs = samples[name]
    if name not in ("mask", "motion", "stroke"): return np.asarray(runs, float)
    return np.repeat(np.asarray(runs[::2]), np.asarray(runs[1::2], int))


def tracks_of(plan):
    """-> quads of single pins (m, 4, 2) and the travel at which each is raked (m), travel of the rake's centre at every sample, masks, motions"""
    import numpy as np
    samples, robot = plan["samples"], plan["robot"]
    pins, pitch = robot["pins"], robot["pin_pitch"]
    centre = np.stack([column(samples, "rake_x"), column(samples, "rake_y")], 1)
    heading, mask, motion = (column(samples, name) for name in ("heading", "mask", "motion"))
    across = np.stack([-np.sin(heading), np.cos(heading)], 1)  # to the left
    travel = np.concatenate([[0], np.cumsum(np.hypot(*np.diff(centre, axis=0).T))])
    quads, when = [], []
    for k in range(pins):  # from the left
        here = np.flatnonzero(mask[:-1].astype(int) >> (pins - 1 - k) & 1)
        left, right = (pins / 2 - k) * pitch, (pins / 2 - k - 1) * pitch
        edge = lambda i, offset: centre[i] + offset * across[i]
        quads.append(np.stack([edge(here, left), edge(here, right), edge(here + 1, right), edge(here + 1, left)], 1))
        when.append((travel[here] + travel[here + 1]) / 2)
    return np.concatenate(quads), np.concatenate(when), travel, mask, motion


def cells_under(quads, cell, columns):
    """-> (number of the quad, number of the cell) for every cell whose middle lies in a quad, even-odd"""
    import numpy as np
    quads = quads / cell - 0.5  # middles of cells are whole numbers
    low, high = np.ceil(quads.min(1)).astype(int), np.floor(quads.max(1)).astype(int)
    size = np.maximum(high - low + 1, 0)
    count = size[:, 0] * size[:, 1]
    which = np.repeat(np.arange(len(quads)), count)
    inner = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    x, y = low[which, 0] + inner % size[which, 0], low[which, 1] + inner // size[which, 0]
    inside = np.zeros(len(which), bool)
    for k in range(4):
        a, b = quads[which, k], quads[which, (k + 1) % 4]
        crosses = (a[:, 1] <= y) != (b[:, 1] <= y)
        rise = np.where(crosses, b[:, 1] - a[:, 1], 1)
        inside ^= crosses & (a[:, 0] + (y - a[:, 1]) * (b[:, 0] - a[:, 0]) / rise > x)
    return which[inside], y[inside] * columns + x[inside]


def area_of(rings, cell, columns, rows):
    """cells whose middle is inside, even-odd over all rings, flat"""
    import numpy as np
    crossings = np.zeros((rows, columns + 1), int)
    for ring in rings:
        c = np.asarray(ring) / cell - 0.5
        for (ax, ay), (bx, by) in zip(c, np.roll(c, -1, 0)):
            y = np.arange(math.ceil(min(ay, by)), math.ceil(max(ay, by)))
            if len(y): np.add.at(crossings, (y, np.ceil(ax + (y - ay) * (bx - ax) / (by - ay)).astype(int)), 1)
    return (np.cumsum(crossings, 1)[:, :-1] % 2 == 1).ravel()


def raked(plan, rings):
    """-> Driven without what check states"""
    import numpy as np
    quads, when, travel, mask, motion = tracks_of(plan)
    cell, turn = RAKE / CELLS, np.array([[math.cos(TURN), -math.sin(TURN)], [math.sin(TURN), math.cos(TURN)]])
    rings, quads = [np.asarray(r) @ turn.T for r in rings], quads @ turn.T
    corners = np.concatenate([*rings, quads.reshape(-1, 2)])
    shift = corners.min(0) - cell
    columns, rows = np.ceil((corners.max(0) - shift) / cell).astype(int) + 1
    inside = area_of([r - shift for r in rings], cell, columns, rows)
    which, at = cells_under(quads - shift, cell, columns)
    order = np.lexsort((when[which], at))
    at, time = at[order], when[which][order]
    again = (at[1:] == at[:-1]) & (time[1:] - time[:-1] > RAKE)  # more than one width of travel, as the judge counts
    area = inside.sum()
    touched = np.unique(at)
    step, down = np.diff(travel), mask[:-1] != 0
    runs = lambda flags: np.flatnonzero(np.diff(np.concatenate([[False], flags, [False]]).astype(int))).reshape(-1, 2)
    turning, centre = (np.stack([column(plan["samples"], name) for name in names], 1) for names in (("x", "y"), ("rake_x", "rake_y")))
    up = motion[:-1] != "draw"
    hops = sum(math.dist(centre[a], centre[b]) > RAKE for a, b in runs(~down) if a and b < len(step))
    stated = plan["figures"]
    if abs(area * cell * cell / stated["fill_area"] - 1) > 0.01:
        return Driven(wrong=f"{area * cell * cell:.2f} m^2 drawn, {stated['fill_area']:.2f} planned")
    return Driven(coverage=inside[touched].sum() / area, overdraw=again.sum() / area, spill=(~inside[touched]).sum() / area,
                  planned=1 - stated["fill_coverage"] + stated["fill_overdraw"] + stated["fill_spill"],
                  ratio=step[down].sum() * RAKE / (area * cell * cell), up=np.hypot(*np.diff(turning, axis=0)[up].T).sum(),
                  loops=len(runs(motion[:-1] == "loop")), hops=int(hops))


def drive(job):
    program, case, settings = job
    rings, width, height = placed(case)
    code, text, err, _, _ = run([program, "plan", "-", "-q", "--robot", "beachbot", "--place", "actual",
                                 "--canvas", f"{width + 2 * MARGIN:.6f}x{height + 2 * MARGIN:.6f}",
                                 "--set", "place.positioned=on", "--set", f"place.x={MARGIN}m", "--set", f"place.y={MARGIN}m",
                                 *settings], stdin=svg_of(rings, width, height), timeout=120)
    if code != 0: return Driven(wrong="hang" if code is None else f"exit {code}: {err.strip()[:80]}")
    result = raked(json.loads(text), rings)
    report = json.loads(run([program, "check", "-", "--json"], stdin=text)[1])
    result.faults, result.over = len(report["faults"]), report["driven_over"]
    result.checked = tuple(report[name] for name in SHOWN)
    return result


# ---- tables ------------------------------------------------------------------------------------------------------

def vehicle_table(name, cases, results):
    cell = lambda r: [f"{100 * getattr(r, k):.2f}" for k in SHOWN] + [f"{100 * r.error:.2f}", f"{100 * r.planned:.2f}", f"{r.ratio:.3f}",
                      f"{r.up:.1f}", r.loops, r.hops, r.faults, f"{r.over:.2f}"]
    rows = [[c.name, r.wrong] + [""] * 10 if r.wrong else [c.name, *cell(r)] for c, r in zip(cases, results)]
    for judges, title in ((True, "judge's"), (False, "fresh and own")):
        good = [r for c, r in zip(cases, results) if c.judges == judges and not r.wrong]
        if not good: continue
        middle = lambda key: median([getattr(r, key) for r in good])
        total = lambda key: sum(getattr(r, key) for r in good)
        rows.append([f"**{title}: median, sum**"] + [f"{100 * middle(k):.2f}" for k in (*SHOWN, "error", "planned")]
                    + [f"{middle('ratio'):.3f}", f"{total('up'):.1f}", total("loops"), total("hops"), total("faults"), f"{total('over'):.2f}"])
    table(f"Fill after drive: rings, 7 pins, {name}",
          ["shape", "coverage %", "overdraw %", "spill %", "E %", "E % as planned", "length x w / area", "rake up m", "corner loops", "hops",
           "faults of check", "driven over m^2"], rows)
    apart = [[100 * abs(getattr(r, k) - stated) for k, stated in zip(SHOWN, r.checked)] for r in results if not r.wrong]
    print("\nBeside the areas of `strandline check` (2 cm cells, a pass after 0.5 m, areas alone), points, median and largest: "
          + ", ".join(f"{k} {median(list(d)):.2f}, {max(d):.2f}" for k, d in zip(SHOWN, zip(*apart))))


def report(program, shared, everything):
    try:
        import numpy  # noqa: F401
    except ImportError:
        return print("\nFill after drive: numpy is not at hand; left out.")
    cases = [c for c in cases_of(shared, everything) if everything or not any(word in c.name for word in LARGE)]
    with Pool(CORES) as pool:
        for name, settings in VEHICLES.items():
            vehicle_table(name, cases, pool.map(drive, [(program, c, settings) for c in cases], chunksize=1))
