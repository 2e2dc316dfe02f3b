"""The fill section of the bench: every shape by every job, and the goals of docs/fill.md beside what was measured.

Shapes: the judge's, where ../shared is at hand, and apart from them fresh ones by seed and our own drawings. What a goal is conditional on (3 w
wide, tips, corridors, leaves, floor) is measured in fill_measures.py, fills by the judge. "3 w wide" is read as: an opening by a disc whose
diameter is 3 w.
"""
import importlib.util, json, math, statistics
from dataclasses import dataclass, field
from multiprocessing import Pool

from fill_shapes import fresh, own, random_region
from harness import run, table

EDGE, CORES = 0.1, 2
JOBS = {"rings": [], "rings, 7 pins": ["--pins", "7"], "spiral": ["--style", "spiral"], "zigzag": ["--style", "zigzag"],
        "rings, one stroke": ["--one-stroke"]}
# The joins beside each other; half-step is the default, so that it stands in the table of the rings, too.
JOINS = {f"rings, join {name}": ["--join", name] for name in ("half-step", "nearest", "alternating", "longest-edge")}
LARGE = ("5k", "5000", "50 holes", "holes50")  # take most of the judge's time; left out of the joins but for --all
TRANSFORMS = [(17, 1), (45, 1), (101, 1), (0, 0.1), (0, 7)]  # degrees, scale


@dataclass
class Case:
    name: str
    judges: bool
    text: str  # what the command reads
    shape: object = None  # fill_measures.Shape
    wrong: str = ""  # why there is none


@dataclass
class Result:
    wrong: str = ""  # crash, hang, nothing raked
    same: bool = True  # bit for bit at a second run
    figures: dict = field(default_factory=dict)  # of the judge

    def percent(self, name): return 100 * self.figures.get(name, float("nan"))

    @property
    def error(self): return 100 - self.percent("coverage") + self.percent("overdraw") + self.percent("spill")


# ---- in the workers: numpy and shapely are loaded there only, so that the section can say what is missing -----------

def judge_of(path):
    spec = importlib.util.spec_from_file_location("evaluate", path)
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def measure(job):
    case, judge = job
    from fill_measures import measured
    data = json.loads(case.text)
    try:
        case.shape = measured(judge_of(judge).target_of(data), data["width"])
    except Exception as problem:  # a degenerate outline: shown, not counted
        case.wrong = repr(problem)[:80]
    return case


def fill_and_judge(job):
    program, judge, text, arguments, again = job
    call = [program, "fill", "-", "-q", *arguments]
    code, out, err, _, _ = run(call, stdin=text, timeout=60)
    if code != 0: return Result(wrong="hang" if code is None else f"exit {code}: {err.strip()[:80]}")
    result = Result(same=not again or run(call, stdin=text, timeout=60)[1] == out)
    try:
        result.figures = judge_of(judge).evaluate(json.loads(out))
    except Exception as problem:
        result.wrong = f"the judge: {problem!r}"[:80]
    if not result.wrong and "overdraw" not in result.figures: result.wrong = "nothing raked"
    return result


# ---- cases -------------------------------------------------------------------------------------------------------

def cases_of(shared, everything):
    cases = [Case(p.stem, True, p.read_text()) for p in sorted((shared / "judge/fill/polygons").glob("*.json"))]
    return cases + [Case(n, False, json.dumps({"polygon": p, "width": 1})) for n, p in own() + fresh(each=6 if everything else 2)]


def moved(text, degrees, scale):
    c, s = scale * math.cos(math.radians(degrees)), scale * math.sin(math.radians(degrees))
    data = json.loads(text)
    turn = lambda ring: [[c * x - s * y, s * x + c * y] for x, y in ring]
    data["polygon"] = {"outer": turn(data["polygon"]["outer"]), "holes": [turn(h) for h in data["polygon"].get("holes", [])]}
    data["width"] *= scale
    return json.dumps(data)


# ---- tables ------------------------------------------------------------------------------------------------------

def median(values):
    values = [v for v in values if not math.isnan(v)]
    return statistics.median(values) if values else float("nan")


def both(cases, show):
    """one cell for the judge's shapes and one for the fresh ones"""
    return [show([c for c in cases if c.judges == judges]) for judges in (True, False)]


def shape_table(cases):
    rows = []
    for c in cases:
        s = c.shape
        rows.append([c.name, c.wrong] + [""] * 6 if not s else [c.name, f"{100 * s.kept:.1f}" + (" *" if s.wide else ""), f"{100 * s.floor:.1f}", s.tips, s.narrow, s.leaves, f"{s.widest:.1f}"])
    table("Fill: the shapes (* 3 w wide: an opening by a disc of diameter 3 w keeps 99 %)",
          ["shape", "kept by the opening %", "floor %", "tips < 45°", "corridors < 1.5 w", "leaves", "widest, w"], rows)


def job_table(name, cases, results):
    rows = []
    for c, r in zip(cases, results):
        f = r.figures
        rows.append([c.name, r.wrong] + [""] * 10 if r.wrong else
                    [c.name] + [f"{r.percent(k):.2f}" for k in ("coverage", "overdraw", "spill")] + [f"{r.error:.2f}", f"{f['ratio']:.3f}", f["hops"], f["pivots"],
                     f["driveover"], f"{100 * f.get('edge_ok', 0):.1f}", f"{f['end_in_w']:.2f}", f"{f['gap_max_w']:.2f} / {f['spill_max_w']:.2f}"])
    for judges, title in ((True, "judge's"), (False, "fresh and own")):
        good = [r for c, r in zip(cases, results) if c.judges == judges and not r.wrong]
        if not good: continue
        m = lambda key: median([r.figures[key] for r in good])
        total = lambda key: sum(r.figures[key] for r in good)
        rows.append([f"**{title}: median, sum**"] + [f"{100 * m(k):.2f}" for k in ("coverage", "overdraw", "spill")] + [f"{median([r.error for r in good]):.2f}", f"{m('ratio'):.3f}",
                    total("hops"), total("pivots"), total("driveover"), f"{100 * m('edge_ok'):.1f}", f"{m('end_in_w'):.2f}", ""])
    table(f"Fill: {name}, vehicle free", ["shape", "coverage %", "overdraw %", "spill %", "E %", "length x w / area", "hops", "pivots", "drives over",
                                          "outline within 0.1 w %", "ends from border, w", "largest gap / spill, w"], rows)


class Goals:
    """rows of goal, met by how many of the judge's, of the fresh, and who falls short"""
    def __init__(self, cases): self.cases, self.rows = cases, []

    def each(self, goal, results, met, counts=lambda c: True, needed=1.0):
        if results is None: return self.rows.append([goal, "not in this program yet", "", ""])
        at = {c.name: r for c, r in zip(self.cases, results)}
        asked = [c for c in self.cases if (c.shape or not c.wrong) and counts(c)]
        holds = lambda c: not at[c.name].wrong and met(c, at[c.name])
        show = lambda some: f"{sum(map(holds, some))} of {len(some)}" + (" met" if sum(map(holds, some)) >= needed * len(some) else "") if some else "none"
        self.rows.append([goal, *both(asked, show), ", ".join(c.name for c in asked if not holds(c)) or "-"])

    def median(self, goal, results, value, met, text="{:.2f}"):
        if results is None: return self.rows.append([goal, "not in this program yet", "", ""])
        at = {c.name: r for c, r in zip(self.cases, results)}
        def show(some):
            m = median([value(at[c.name]) for c in some if not at[c.name].wrong])
            return "none" if math.isnan(m) else text.format(m) + (" met" if met(m) else "")
        self.rows.append([goal, *both(self.cases, show), ""])


def goal_rows(cases, judged):
    goals = Goals(cases)
    rings, pins, zigzag, one = (judged.get(k) for k in ("rings", "rings, 7 pins", "zigzag", "rings, one stroke"))
    wide = lambda c: c.shape and c.shape.wide
    plain = lambda c: c.shape and c.shape.plain
    for name in JOBS:
        goals.each(f"{name}: no crash, hang, empty result; the same bit for bit again", judged[name], lambda c, r: r.same)
    goals.each("7 pins: coverage >= 99.5 % where 3 w wide", pins, lambda c, r: r.percent("coverage") >= 99.5, wide)
    goals.median("7 pins: coverage, median >= 99.8 %", pins, lambda r: r.percent("coverage"), lambda m: m >= 99.8)
    goals.median("7 pins: overdraw, median <= 1 %", pins, lambda r: r.percent("overdraw"), lambda m: m <= 1)
    goals.each("7 pins: overdraw, each <= 2 %", pins, lambda c, r: r.percent("overdraw") <= 2)
    goals.each("7 pins: spill, each <= 0.2 %", pins, lambda c, r: r.percent("spill") <= 0.2)
    goals.each("7 pins: never further outside than w/7 + w/16", pins, lambda c, r: r.figures["spill_max_w"] <= 1 / 7 + 1 / 16)
    goals.each("solid: coverage >= 99.5 % on 80 %", rings, lambda c, r: r.percent("coverage") >= 99.5, needed=0.8)
    goals.each("solid: overdraw, each <= floor + 1.5 points", rings, lambda c, r: c.shape and r.percent("overdraw") <= 100 * c.shape.floor + 1.5)
    goals.median("solid: E, median <= 2.5 %", rings, lambda r: r.error, lambda m: m <= 2.5)
    for name, results in (("solid", rings), ("7 pins", pins), ("zigzag", zigzag), ("spiral", judged.get("spiral"))):
        goals.each(f"{name}: no drive-over, >= 1.5 w wide and tips >= 45°", results, lambda c, r: r.figures["driveover"] == 0, plain)
        goals.each(f"{name}: drive-overs elsewhere <= tips + corridors", results, lambda c, r: r.figures["driveover"] <= c.shape.tips + c.shape.narrow,
                   lambda c: c.shape and not c.shape.plain)
        goals.each(f"{name}: ends on the border", results, lambda c, r: r.figures["end_in_w"] <= EDGE)
        goals.each(f"{name}: outline within 0.1 w, >= 99.5 % of its length", results, lambda c, r: r.figures.get("edge_ok", 0) >= 0.995)
    for name, results in (("solid", rings), ("7 pins", pins)):
        goals.each(f"{name}: hops <= leaves - 1 + tips", results, lambda c, r: c.shape and r.figures["hops"] <= c.shape.leaves - 1 + c.shape.tips)
    goals.each("one stroke: no hop", one, lambda c, r: r.figures["hops"] == 0)
    goals.each("one stroke: coverage >= 99 % where 3 w wide", one, lambda c, r: r.percent("coverage") >= 99, wide)
    goals.median("rings: length x w / area, median <= 1.05", rings, lambda r: r.figures["ratio"], lambda m: m <= 1.05, "{:.3f}")
    goals.median("zigzag: the same, <= 1.02", zigzag, lambda r: r.figures["ratio"], lambda m: m <= 1.02, "{:.3f}")
    table("Fill: the goals beside what was measured", ["goal", "judge's shapes", "fresh and own shapes", "falls short"], goals.rows)


def moved_rows(program, judge, cases, rings, pool, everything):
    names = None if everything else {"letter #1", "star #1", "blob #1", "heart", "glyph_A", "L"}
    some = [(c, r) for c, r in zip(cases, rings) if not r.wrong and (names is None or c.name in names)]
    found = iter(pool.map(fill_and_judge, [(program, judge, moved(c.text, *t), [], False) for c, _ in some for t in TRANSFORMS], chunksize=1))
    rows, far = [], {True: 0, False: 0}
    for c, r in some:
        changes = [other.error - r.error if not other.wrong else math.nan for _, other in zip(TRANSFORMS, found)]
        far[c.judges] += not all(abs(d) <= 0.5 for d in changes)
        rows.append([c.name, f"{r.error:.2f}"] + [f"{d:+.2f}" for d in changes])
    rows.append(["**shapes that move by over 0.5**", f"judge's {far[True]}, fresh {far[False]}"] + [""] * len(TRANSFORMS))
    table("Fill: rings, E when turned or scaled with the rake (goal: within 0.5 points)", ["shape", "E %"] + [f"{d}°" if s == 1 else f"x {s}" for d, s in TRANSFORMS], rows)


def random_rows(program, judge, pool, count):
    cases = [Case(f"seed {seed}", False, json.dumps({"polygon": random_region(seed), "width": 1})) for seed in range(1, count + 1)]
    cases = pool.map(measure, [(c, judge) for c in cases], chunksize=8)
    found = pool.map(fill_and_judge, [(program, judge, c.text, [], False) for c in cases], chunksize=8)
    rows = []
    for title, asked in (("at least 1.5 w wide, tips 45° and over: no drive-over", lambda c: c.shape and c.shape.plain),
                         ("the others: at most one a tip and corridor", lambda c: c.shape and not c.shape.plain)):
        some = [(c, r) for c, r in zip(cases, found) if asked(c)]
        bad = [(c, r) for c, r in some if r.wrong or r.figures["driveover"] > (0 if c.shape.plain else c.shape.tips + c.shape.narrow)]
        rows.append([title, len(some), len(some) - len(bad), sum(r.figures.get("driveover", 0) for _, r in some),
                     ", ".join(f"{c.name} ({r.wrong or r.figures['driveover']})" for c, r in bad[:20]) or "-"])
    table(f"Fill: {count} random regions with holes, rings", ["regions", "number", "met", "drive-overs in all", "falls short (drive-overs)"], rows)


def time_rows(program, cases):
    start = statistics.median(run([program, "--version"])[3] for _ in range(9))
    limits = lambda c: 5 if "letter" in c.name or c.name.startswith(("glyph", "asl")) else 30 if c.name in ("holes50", "50 holes #1") else 60 if "5k" in c.name or "5000" in c.name else None
    rows = []
    for c in cases:
        if limits(c) is None: continue
        whole = statistics.median(run([program, "fill", "-", "-q"], stdin=c.text)[3] for _ in range(5))
        rows.append([c.name, limits(c), f"{1000 * whole:.0f}", f"{1000 * (whole - start):.0f}", "met" if 1000 * (whole - start) <= limits(c) else ""])
    table(f"Fill: rings, CPU ms (median of 5; starting the program takes {1000 * start:.0f})", ["shape", "goal", "whole process", "less its start (reading and writing JSON stay in)", ""], rows)


def report(program, shared, folder, everything):
    cases, judge = cases_of(shared, everything), shared / "judge/fill/evaluate.py"
    if not judge.is_file():
        bad = [c.name for c in cases if fill_and_judge((program, judge, c.text, [], True)).wrong.startswith(("exit", "hang"))]
        print(f"\nFill: the judge is not at hand. Left out: its shapes, coverage, overdraw, spill, drive-overs and hops of the {len(cases)} others, their goals, and the random"
              f" regions; tests/fill holds the laws. Crashes, hangs, empty results: {', '.join(bad) or 'none'}.")
        return time_rows(program, cases)
    known = run([program, "fill", "--help"])[1]
    with Pool(CORES) as pool:
        cases = pool.map(measure, [(c, judge) for c in cases], chunksize=1)
        shape_table(cases)
        judged = {}
        def go(name, arguments, some):
            missing = [a for a in arguments if a.startswith("--") and a not in known]
            if missing: return print(f"\nFill: {name} is left out: the program has no {missing[0]}.")
            results = pool.map(fill_and_judge, [(program, judge, c.text, arguments, True) for c in some], chunksize=1)
            job_table(name, some, results)
            return results
        for name, arguments in JOBS.items(): judged[name] = go(name, arguments, cases)
        for name, arguments in JOINS.items(): go(name, arguments, [c for c in cases if everything or not any(word in c.name for word in LARGE)])
        goal_rows(cases, judged)
        moved_rows(program, judge, cases, judged["rings"], pool, everything)
        random_rows(program, judge, pool, 1000 if everything else 40)
    time_rows(program, cases)
