"""The fill-vehicles section of the bench: the shapes of the fill tables, as beachbot drives them.

A shape becomes an SVG of one black area, so large that its rake is beachbot's, and goes through plan and check.
What is raked is measured from the plan's samples alone (tracks_of, shares): cells of w/16, passes as the fill
judge counts them, but of true pins, across the heading at the rake's centre, not across its path. Needs numpy.
"""
import json, math
from dataclasses import dataclass
from multiprocessing import Pool

from fill import CORES, LARGE, cases_of, median
from harness import run, table

RAKE = 0.42  # metres: beachbot's 7 pins
MARGIN = 0.5  # metres of canvas round the shape
CELLS = 16  # a rake width
TURN = 0.5  # radians, of the cells against the drawing: edges along rows would be rounded to one side
VEHICLES = {"beachbot without turns on the spot (its profile)": [],
            "beachbot with turns on the spot": ["robot.can_pivot=on"]}
STYLES = {"beachbot (loops)": {"rings": [], "spiral": ["fill.style=spiral"], "zigzag": ["fill.style=zigzag"],
                               "zigzag, `fill.rake_turns=off`": ["fill.style=zigzag", "fill.rake_turns=off"]},
          "beachbot that turns on the spot": {"rings": ["robot.can_pivot=on"], "zigzag": ["robot.can_pivot=on", "fill.style=zigzag"]}}
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
    seconds: float = math.nan  # of the whole drive, for a m^2 of the shape
    checked: tuple = ()  # check's coverage, overdraw, spill

    @property
    def error(self): return 1 - self.coverage + self.overdraw + self.spill


# ---- the drawing ------------------------------------------------------------------------------------------

def placed(case):
    """-> rings in metres, y up, lower left corner at (MARGIN, MARGIN), and the box's size"""
    data = json.loads(case.text)
    scale = RAKE / data["width"]
    rings = [data["polygon"]["outer"], *data["polygon"].get("holes", [])]
    left, low = (min(p[axis] for r in rings for p in r) for axis in (0, 1))
    rings = [[(MARGIN + scale * (x - left), MARGIN + scale * (y - low)) for x, y in r] for r in rings]
    return rings, *(max(p[axis] for r in rings for p in r) - MARGIN for axis in (0, 1))


def svg_of(rings, width, height):
    at = lambda x, y: f"{x - MARGIN:.7f},{height + MARGIN - y:.7f}"
    outline = " ".join("M " + " ".join(at(*p) for p in r) + " Z" for r in rings)
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{1000 * width:.4f}mm" '
            f'height="{1000 * height:.4f}mm" viewBox="0 0 {width:.7f} {height:.7f}">'
            f'<path id="area" fill-rule="evenodd" d="{outline}"/></svg>')


# ---- true pin tracks: numpy is loaded here only, so that the section can say that it is missing -------------

def column(samples, name):
    """a column of the plan, runs written out"""
    import numpy as np
    runs = samples[name]
    if name not in ("mask", "motion", "stroke"): return np.asarray(runs, float)
    return np.repeat(np.asarray(runs[::2]), np.asarray(runs[1::2], int))


def places(samples, of=""):
    """-> (n, 2), of the turning point, or of the rake's centre"""
    import numpy as np
    return np.stack([column(samples, of + "x"), column(samples, of + "y")], 1)


def travel_of(places):
    import numpy as np
    return np.concatenate([[0], np.cumsum(np.hypot(*np.diff(places, axis=0).T))])


def tracks_of(plan):
    """-> quads that single pins rake from a sample to the next (m, 4, 2), and the rake's travel by then (m)"""
    import numpy as np
    samples, robot = plan["samples"], plan["robot"]
    pins, pitch = robot["pins"], robot["pin_pitch"]
    centre, heading = places(samples, "rake_"), column(samples, "heading")
    mask = column(samples, "mask").astype(int)
    across = np.stack([-np.sin(heading), np.cos(heading)], 1)  # to the left
    travel = travel_of(centre)
    quads, when = [], []
    for k in range(pins):  # from the left
        here = np.flatnonzero(mask[:-1] >> (pins - 1 - k) & 1)
        left, right = (pins / 2 - k) * pitch, (pins / 2 - k - 1) * pitch
        edge = lambda i, offset: centre[i] + offset * across[i]
        ends = ((here, left), (here, right), (here + 1, right), (here + 1, left))
        quads.append(np.stack([edge(i, offset) for i, offset in ends], 1))
        when.append((travel[here] + travel[here + 1]) / 2)
    return np.concatenate(quads), np.concatenate(when)


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
            if not len(y): continue
            x = np.ceil(ax + (y - ay) * (bx - ax) / (by - ay)).astype(int)
            np.add.at(crossings, (y, x), 1)
    return (np.cumsum(crossings, 1)[:, :-1] % 2 == 1).ravel()


def shares(rings, quads, when):
    """-> area in m^2, and coverage, overdraw, spill as shares of it"""
    import numpy as np
    cell, c, s = RAKE / CELLS, math.cos(TURN), math.sin(TURN)
    turn = np.array([[c, s], [-s, c]])  # of rows (x, y)
    rings, quads = [np.asarray(r) @ turn for r in rings], quads @ turn
    corners = np.concatenate([*rings, quads.reshape(-1, 2)])
    low = corners.min(0) - cell
    columns, rows = np.ceil((corners.max(0) - low) / cell).astype(int) + 1
    inside = area_of([r - low for r in rings], cell, columns, rows)
    which, at = cells_under(quads - low, cell, columns)
    order = np.lexsort((when[which], at))
    at, time = at[order], when[which][order]
    # after more than a width of travel, as the judge counts
    again = (at[1:] == at[:-1]) & (time[1:] - time[:-1] > RAKE)
    area, touched = inside.sum(), inside[np.unique(at)]
    return area * cell * cell, touched.sum() / area, again.sum() / area, (~touched).sum() / area


def raked(plan, rings):
    """-> Driven without what check states"""
    import numpy as np
    area, coverage, overdraw, spill = shares(rings, *tracks_of(plan))
    stated, samples = plan["figures"], plan["samples"]
    if abs(area / stated["fill_area"] - 1) > 0.01:
        return Driven(wrong=f"{area:.2f} m^2 drawn, {stated['fill_area']:.2f} planned")
    mask, motion = (column(samples, name)[:-1] for name in ("mask", "motion"))
    centre = places(samples, "rake_")
    edges = lambda flags: np.flatnonzero(np.diff(np.concatenate([[0], flags.astype(int), [0]])))
    runs = lambda flags: edges(flags).reshape(-1, 2)
    step = lambda way, flags: np.diff(travel_of(way))[flags].sum()
    hops = [math.dist(centre[a], centre[b]) > RAKE for a, b in runs(mask == 0) if a and b < len(mask)]
    return Driven(coverage=coverage, overdraw=overdraw, spill=spill,
                  planned=1 - stated["fill_coverage"] + stated["fill_overdraw"] + stated["fill_spill"],
                  ratio=step(centre, mask != 0) * RAKE / area, up=step(places(samples), motion != "draw"),
                  loops=len(runs(motion == "loop")), hops=sum(hops))


def drive(job):
    program, case, settings = job
    rings, width, height = placed(case)
    corner = ["place.positioned=on", f"place.x={MARGIN}m", f"place.y={MARGIN}m"]
    call = [program, "plan", "-", "-q", "--robot", "beachbot", "--place", "actual",
            "--canvas", f"{width + 2 * MARGIN:.6f}x{height + 2 * MARGIN:.6f}",
            *(word for setting in corner + settings for word in ("--set", setting))]
    code, text, err, _, _ = run(call, stdin=svg_of(rings, width, height), timeout=120)
    if code != 0: return Driven(wrong="hang" if code is None else f"exit {code}: {err.strip()[:80]}")
    result = raked(json.loads(text), rings)
    report = json.loads(run([program, "check", "-", "--json"], stdin=text)[1])
    result.faults, result.over = len(report["faults"]), report["driven_over"]
    result.checked = tuple(report[name] for name in SHOWN)
    figures = json.loads(text)["figures"]
    result.seconds = figures["time"] / figures["fill_area"]
    return result


# ---- tables -----------------------------------------------------------------------------------------------

HEAD = ["shape", "coverage %", "overdraw %", "spill %", "E %", "E % as planned", "length x w / area",
        "rake up m", "corner loops", "hops", "faults of check", "driven over m^2"]
PERCENTS = (*SHOWN, "error", "planned")


def cells_of(value, sums):
    """a row but for its name: value of what is told for a shape, sums of what is counted"""
    percents = [f"{100 * value(key):.2f}" for key in PERCENTS]
    return [*percents, f"{value('ratio'):.3f}", f"{sums('up'):.1f}", *map(sums, ("loops", "hops", "faults")),
            f"{sums('over'):.2f}"]


def vehicle_table(name, cases, results):
    rows = []
    for c, r in zip(cases, results):
        of = lambda key: getattr(r, key)
        rows.append([c.name, r.wrong] + [""] * (len(HEAD) - 2) if r.wrong else [c.name, *cells_of(of, of)])
    for judges, title in ((True, "judge's"), (False, "fresh and own")):
        good = [r for c, r in zip(cases, results) if c.judges == judges and not r.wrong]
        if not good: continue
        of = lambda key: [getattr(r, key) for r in good]
        middle, total = (lambda key: median(of(key))), (lambda key: sum(of(key)))
        rows.append([f"**{title}: median, sum**", *cells_of(middle, total)])
    table(f"Fill after drive: rings, 7 pins, {name}", HEAD, rows)
    good = [r for r in results if not r.wrong]
    far = []
    for k, name in enumerate(SHOWN):
        points = [100 * abs(getattr(r, name) - r.checked[k]) for r in good]
        far.append(f"{name} {median(points):.2f}, {max(points, default=0):.2f}")
    print("\nPoints from the areas of `strandline check`, median and largest: " + ", ".join(far))


def report(program, shared, everything):
    try:
        import numpy  # noqa: F401
    except ImportError:
        return print("\nFill after drive: numpy is not at hand; left out.")
    large = lambda case: any(word in case.name for word in LARGE)
    cases = [c for c in cases_of(shared, everything) if everything or not large(c)]
    with Pool(CORES) as pool:
        for name, settings in VEHICLES.items():
            vehicle_table(name, cases, pool.map(drive, [(program, c, settings) for c in cases], chunksize=1))


def styles(program, shared):
    """docs/fill.md, "Which style for which robot": medians of shares, sums of metres, over all shapes but the large ones"""
    cases = [c for c in cases_of(shared, False) if not any(word in c.name for word in LARGE)]
    rows = []
    with Pool(CORES) as pool:
        for robot, named in STYLES.items():
            for style, settings in named.items():
                results = pool.map(drive, [(program, c, settings) for c in cases], chunksize=1)
                good = [r for r in results if not r.wrong]
                of = lambda key: [getattr(r, key) for r in good]
                rows.append([robot, style, len(good), f"{100 * median(of('coverage')):.1f}", f"{100 * median(of('overdraw')):.1f}", f"{sum(of('up')):,.0f}",
                             f"{sum(of('seconds')) / len(good):.1f}", f"{sum(of('over')):.0f}"])
    table("Fill after drive: styles, 7 pins", ["robot", "style", "shapes", "covered", "twice", "rake up m", "s a m^2, mean", "finished sand under the wheels m^2"], rows)
