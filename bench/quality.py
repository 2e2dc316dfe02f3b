#!/usr/bin/python3
"""quality.py PROGRAM [--shared DIR] [--only SECTION,...] -> Markdown tables on stdout.

Measures what the program makes, from outside, by its commands. Two columns where a judge has cases of its own: the judge's cases and fresh
seeded ones made here, so that nothing is tuned to the first. Without the judges' folder only the second column is filled, by the checks in
this file. Sections: drawings, clipart, svg, tour, connect, fill, fill-vehicles, fill-styles, convert, simulate, backing, and
fill-pictures, which writes docs/fill. Needs python3; the judges need numpy and shapely.
"""
import argparse, json, math, random, statistics, subprocess, sys, tempfile, time
from pathlib import Path

import backing as backing_up
import connect as connections
import converter
import fill as fill_table
import simulate as simulation
import vehicles
from harness import peak_mb, percent, run, table

ROOT = Path(__file__).resolve().parent.parent
AGREEMENT = None  # the program of bench/agreement
LKH = None  # --lkh: LKH's program, built elsewhere (research licence: neither its code nor its binary belongs here)
EVERYTHING = False  # --all: 100,000 pairs, fills of all fresh shapes, and 1,000 random regions


# ---- drawings ------------------------------------------------------------------------------------------------

def plan_row(program, path, folder, extra=()):
    out = folder / "plan.json"
    times = []
    for _ in range(3):
        code, _, err, cpu, _ = run([program, "plan", path, "-o", out, "-q", *extra])
        times.append(cpu)
    if code != 0:
        return [path.stem, f"exit {code}: {err.strip()[:80]}"] + [""] * 9
    memory = peak_mb([program, "plan", path, "-o", out, "-q", *extra])
    figures = json.loads(run([program, "plan", path, "-o", out, "-q", "--json", *extra])[1])
    code, text, _, _, _ = run([program, "check", out, "--json"])
    report = json.loads(text)
    verdict = "sound" if report["sound"] else f"{len(report['faults'])} faults"
    areas = "" if not figures["regions"] else "%.1f / %.1f / %.1f" % tuple(100 * report[k] for k in ("coverage", "overdraw", "spill"))
    return [path.stem, f"{figures['lines']} + {figures['regions']}", f"{figures['drawn']:.1f}", f"{figures['up_straight']:.2f}",
            f"{figures['up_dubins']:.1f}", f"{figures['up_driven']:.1f}", f"{figures['loops_driven']:.1f}", areas,
            f"{report['crossings']} / {report['over_finished']:.2f} / {report['driven_over']:.2f}", verdict, f"{statistics.median(times):.2f} / {memory:.0f}"]


def drawings(program, shared, folder):
    head = ["drawing", "lines + areas", "drawn m", "rake up straight m", "Dubins m", "driven m", "corner loops m",
            "coverage / overdraw / spill %", "crossings / m over finished areas / m^2 rolled over", "check", "CPU s / MB"]
    for title, paths in (("The drawings of 2014", sorted((shared / "drawings").glob("*.svg"))), ("Our own drawings", sorted((ROOT / "drawings").glob("*.svg")))):
        if paths:
            table(title + " (`strandline plan`, beachbot, 14 x 14 m)", head, [plan_row(program, p, folder) for p in paths])
    ours = sorted((ROOT / "drawings").glob("*.svg"))
    table("Our own drawings on a plotter (A4)", head, [plan_row(program, p, folder, ["--robot", "plotter", "--canvas", "A4", "--margin", "10mm"]) for p in ours])


def clipart(program, shared, folder):
    source = Path("/usr/share/openclipart/svg")
    files = sorted(source.rglob("*.svg")) if source.is_dir() else []
    if not files:
        return print("\nClip-art: Debian's openclipart-svg is not installed; left out.")
    random.Random(2014).shuffle(files)
    counts, slow, odd, laws, cpus = {}, [], [], {}, []
    for path in files[:300]:
        out = folder / "clip.json"
        code, _, err, cpu, _ = run([program, "plan", path, "-o", out, "-q"], timeout=60)
        cpus.append(cpu)
        if cpu > 5: slow.append(f"{path.name} {cpu:.1f} s")
        if code is None: kind = "hang"
        elif code < 0: kind = f"crash ({-code})"
        elif code == 1: kind = "refused: " + err.strip().split(": ", 2)[-1].split(";")[0][:60]
        elif code == 0:
            checked, text, _, _, _ = run([program, "check", out, "--json"], timeout=60)
            report = json.loads(text)
            kind = "sound" if checked == 0 else "faults named"
            for law in {f["law"] for f in report["faults"]}: laws[law] = laws.get(law, 0) + 1
        else: kind = f"exit {code}"
        counts[kind] = counts.get(kind, 0) + 1
        if kind.startswith(("crash", "hang", "exit")): odd.append(f"{path.name}: {kind}")
    table("300 random files of Debian's openclipart-svg (seed 2014)", ["outcome", "files"], sorted(counts.items(), key=lambda c: -c[1]))
    print(f"\nCPU s a file: median {percent(cpus, .5):.2f}, p95 {percent(cpus, .95):.2f}, largest {max(cpus):.2f}; over 5 s: {', '.join(slow) or 'none'}; crashes, hangs: {', '.join(odd) or 'none'}; files by broken law: {laws or 'none'}")


# ---- svg: what is read, beside librsvg -------------------------------------------------------------------------

def svg_corpus(tool, title, files):
    """every file in a process of fifty; one that dies or takes too long is found by itself"""
    rows, odd = [], []
    def look(batch):
        code, out, _, _, _ = run([tool, *batch], timeout=60 + 10 * len(batch))
        lines = [l.split("\t") for l in out.split("\n") if l.count("\t") >= 5]
        if code == 0: return rows.extend(lines)
        if len(batch) == 1: return odd.append(f"{batch[0].name}: {'hang' if code is None else f'crash ({code})'}")
        for path in batch: look([path])
    for i in range(0, len(files), 50): look(files[i:i + 50])
    read = [r for r in rows if r[1] == "read"]
    agree = [r for r in read if float(r[2]) >= 0.95]
    # of the warnings only those that name paint which is drawn otherwise, or not at all
    known = ("gradient", "pattern", "text", "image", "mask", "filter", "clip", "font", "foreignObject")
    named = lambda r: any(word in r[5] for word in known)
    listed = [r for r in read if float(r[2]) < 0.95 and named(r)]
    silent = [r for r in read if float(r[2]) < 0.95 and not named(r)]
    count = lambda kind: sum(r[1] == kind for r in rows)
    reading, drawing = [float(r[3]) for r in rows], [float(r[4]) for r in rows if r[4]]
    table(f"SVG: {title}", ["figure", "value"], [
        ["files; crashes and hangs", f"{len(files)}; {', '.join(odd) or 'none'}"],
        ["refused with a reason; without shapes; refused by librsvg", f"{count('refused')}; {count('no shapes')}; {count('librsvg refuses')}"],
        ["compared at 512 px", len(read)],
        ["agree to 0.95", f"{len(agree)} ({100 * len(agree) / max(1, len(read)):.1f} %)"],
        ["less, and the file's own warnings name something left out", len(listed)],
        ["agree, or are listed", f"{100 * (len(agree) + len(listed)) / max(1, len(read)):.2f} %"],
        ["less without a warning", f"{len(silent)}: " + ", ".join(f"{Path(r[0]).name} {r[2]}" for r in sorted(silent, key=lambda r: float(r[2]))[:12])],
        ["reading, s: all, slowest", f"{sum(reading):.1f}, {max(reading, default=0):.2f}"],
        ["drawing (occlusion, joining, enclosure), s: all, slowest", f"{sum(drawing):.1f}, {max(drawing, default=0):.2f}"]])


def svg(program, shared, folder):
    if not AGREEMENT or not Path(AGREEMENT).exists():
        return print("\nSVG: librsvg is not at hand; left out.")
    for title, source in (("Debian's openclipart-svg", "/usr/share/openclipart/svg"), ("librsvg2-tests", "/usr/libexec/installed-tests/RSVG")):
        files = sorted(Path(source).rglob("*.svg")) if Path(source).is_dir() else []
        if files: svg_corpus(AGREEMENT, title, [f for f in files if f.is_file()])


# ---- tour ----------------------------------------------------------------------------------------------------

OPTIMA = {"asset_lion_example": 1104.838, "asset_shark_test": 636.189, "asset_asl_logo": 858.085, "asset_asl_font": 352.550,
          "asset_flower_example": 60.701, "asset_maleficient": 558.238}
TIMED = [("asset_floral_patterns", 2942.2, 1), ("seg_100", 5720.5, 1), ("mix_200", 10_530, 1), ("seg_1k", 52_015, 1), ("hershey_scripts_1k", 8457, 1),
         ("hershey_futural_400", 6122, 1), ("mix_2k", 97_050, 1), ("seg_10k", 502_000, 1), ("mix_2k", 96_950, 10), ("seg_10k", 499_300, 10)]
BEST_KNOWN = {"asset_floral_patterns": 2942.128, "seg_100": 5720.5, "mix_200": 10524, "seg_1k": 51963, "hershey_scripts_1k": 8448.6,
              "hershey_futural_400": 6115.8, "mix_2k": 96855, "seg_10k": 498353}


def tour_length(instance, solution):
    here, total = instance["start"], 0.0
    assert sorted(s["element"] for s in solution) == list(range(len(instance["elements"])))
    for step in solution:
        element = instance["elements"][step["element"]]
        points, entry = element["points"], step["entry_index"]
        if not element["closed"]:
            assert entry == (len(points) - 1 if step["reversed"] else 0)
        if here is not None: total += math.dist(here, points[entry])
        here = points[entry] if element["closed"] else points[0 if step["reversed"] else -1]
    return total


def tour_row(program, path, folder, best, seeds=(1, 2, 3)):
    instance = json.loads(path.read_text())
    lengths, cpu = [], []
    for seed in seeds:
        code, _, err, seconds, _ = run([program, "tour", path, "-o", folder / "tour.json", "--seed", seed, "-q"])
        assert code == 0, err
        lengths.append(tour_length(instance, json.loads((folder / "tour.json").read_text())))
        cpu.append(seconds)
    gap = f"{100 * (max(lengths) / best - 1):+.3f} %" if best else ""
    return [path.stem, len(instance["elements"]), f"{min(lengths):.3f}", f"{max(lengths):.3f}", best or "", gap, f"{statistics.median(cpu):.2f}"]


def timed_tour_row(program, path, folder, goal, limit, seeds=(1, 2, 3, 4, 5)):
    instance = json.loads(path.read_text())
    lengths = []
    for seed in seeds:
        code, _, err, _, _ = run([program, "tour", path, "-o", folder / "tour.json", "--seed", seed, "--time-limit", f"{limit}s", "-q"])
        assert code == 0, err
        lengths.append(tour_length(instance, json.loads((folder / "tour.json").read_text())))
    mean = statistics.mean(lengths)
    return [path.stem, limit, f"{min(lengths):.2f}", f"{mean:.2f}", f"{max(lengths):.2f}", goal, sum(l <= goal for l in lengths)]


def large_tour_rows(program, shared, folder):
    for kind, n, goals in (("seg", 100_000, ((5_000_000, 10), (4_970_000, 60))), ("mix", 20_000, ((972_000, 15), (965_500, 60)))):
        for seed in (101, 102):
            path = folder / f"{kind}_{n}_{seed}.json"
            path.write_text(subprocess.run([sys.executable, shared / "judge/tour/make_random.py", kind, str(n), str(seed)], capture_output=True, text=True, check=True).stdout)
            memory = f"{peak_mb([program, 'tour', path, '-o', folder / 'tour.json', '--time-limit', '10s', '-q']):.0f}"
            for goal, limit in goals[:2 if EVERYTHING else 1]:
                yield timed_tour_row(program, path, folder, goal, limit, seeds=(1,)) + [memory]


def beside_lkh(program, solver, path, folder, limit):
    """one row: the same closed tour of lines by both; LKH's limit begins after its candidates are made"""
    instance = dict(json.loads(path.read_text()), start=None, end="start")
    ring, problem, tour, call = (folder / f"ring.{end}" for end in ("json", "tsp", "tour", "par"))
    ring.write_text(json.dumps(instance))
    assert run([program, "tour", ring, "--write-tsplib", problem, "-q"])[0] == 0
    call.write_text(f"PROBLEM_FILE = {problem}\nOUTPUT_TOUR_FILE = {tour}\nRUNS = 1\nSEED = 1\nTIME_LIMIT = {limit}\n")
    theirs, taken = None, run([solver, call])[3]
    if tour.exists():
        out = run([program, "tour", ring, "--read-tour", tour, "-o", folder / "tour.json", "--json"])[1]
        theirs = json.loads(out)["length"]
    def ours(seconds):
        out = run([program, "tour", ring, "--time-limit", f"{seconds:.2f}s", "-o", folder / "tour.json", "--json", "-q"])[1]
        return json.loads(out)["length"]
    lengths = [ours(taken), ours(taken / 5)]
    return [path.stem, limit, f"{taken:.1f}", f"{theirs:.0f}" if theirs else "no tour"] + [f"{l:.0f}" + (f" ({l / theirs:.4f})" if theirs else "") for l in lengths]


def random_instance(kind, n, seed):
    r, side, elements = random.Random(seed), 100 * math.sqrt(n), []
    for _ in range(n):
        x, y = r.random() * side, r.random() * side
        if kind == "lines":
            a, l = r.random() * 2 * math.pi, r.uniform(10, 150)
            elements.append({"closed": False, "points": [[x, y], [x + l * math.cos(a), y + l * math.sin(a)]]})
        else:
            k, radius = r.randint(3, 30), r.uniform(8, 70)
            elements.append({"closed": r.random() < .5, "points": [[x + radius * math.cos(2 * math.pi * j / k), y + radius * math.sin(2 * math.pi * j / k)] for j in range(k)]})
    return {"start": [0, 0], "elements": elements}


def tour(program, shared, folder):
    head = ["instance", "elements", "best of seeds 1-3", "worst", "optimum or best known", "worst over it", "CPU s"]
    instances = shared / "judge/tour/instances"
    if instances.is_dir():
        small = [tour_row(program, instances / f"{name}.json", folder, best) for name, best in OPTIMA.items()]
        table("Tour: proven optima", head, small)
        print(f"\nthe six together: {sum(float(r[-1]) for r in small):.2f} CPU s")
        table("Tour: best known", head, [tour_row(program, instances / f"{name}.json", folder, best) for name, best in BEST_KNOWN.items()])
        head_timed = ["instance", "CPU s", "best of seeds", "mean", "worst", "goal", "seeds that meet it"]
        table("Tour: within a time", head_timed, [timed_tour_row(program, instances / f"{name}.json", folder, goal, limit) for name, goal, limit in TIMED])
        table("Tour: large fresh ones within a time", head_timed + ["peak MB"], large_tour_rows(program, shared, folder))
    rows = []
    for kind, n in (("lines", 30), ("mixed", 12), ("lines", 100), ("mixed", 200), ("lines", 1000)):
        for seed in (101, 102):
            path = folder / f"fresh_{kind}_{n}_{seed}.json"
            path.write_text(json.dumps(random_instance(kind, n, seed)))
            rows.append(tour_row(program, path, folder, None))
    table("Tour: fresh cases", head, rows)
    if LKH:
        cases = [(instances / f"{name}.json", limit) for name, limit in (("seg_100", 1), ("seg_1k", 1))] if instances.is_dir() else []
        cases += [(folder / f"fresh_lines_1000_{seed}.json", 1) for seed in (101, 102)]
        table("Tour: closed tours of lines beside LKH, one run each", ["instance", "LKH's TIME_LIMIT s", "its CPU s", "LKH", "ours in as many s (ratio)", "ours in a fifth of them"],
              [beside_lkh(program, LKH, path, folder, limit) for path, limit in cases])


# ---- connect: bench/connect.py -------------------------------------------------------------------------------------------------

def connect(program, shared, folder):
    connections.report(program, shared, folder, 100_000 if EVERYTHING else 10_000, ROOT)


# ---- fill: bench/fill.py, bench/vehicles.py ------------------------------------------------------------------

def fill(program, shared, folder):
    fill_table.report(program, shared, folder, EVERYTHING)


def fill_vehicles(program, shared, folder):
    vehicles.report(program, shared, EVERYTHING)


def fill_styles(program, shared, folder):
    vehicles.styles(program, shared)


def simulate(program, shared, folder):
    simulation.report(program, shared, folder, ROOT)


def backing(program, shared, folder):
    backing_up.report(program, shared, folder, ROOT)


def fill_pictures(program, shared, folder):
    import pictures  # Pillow is needed for these alone
    pictures.draw(program, folder, ROOT / "docs")


# ---- convert -------------------------------------------------------------------------------------------------

def convert(program, shared, folder):
    rows = []
    for radius in (0.25, 0.3, 0.5, 1.0, 3.0):
        step, sweep = 0.05, 1.5 * math.pi
        n = max(4, int(radius * sweep / step))
        truth = lambda s: (radius * math.cos(s / radius), radius * math.sin(s / radius))
        source = folder / "rake.csv"
        source.write_text("x,y,pins\n" + "".join("%.9f,%.9f,127\n" % truth(i * step) for i in range(n)))
        code, out, err, _, _ = run([program, "convert", source, "--robot", "beachbot", "-o", "-", "-q"])
        lines = [list(map(float, l.split(","))) for l in out.split()[1:]]
        worst = 0.0
        for a, b in zip(lines, lines[1:]):
            for k in range(11):
                t = k / 10
                x, y = a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])
                # the robot drives an arc from pose to pose: bulge of the chord by its turning
                turn = math.remainder(b[2] - a[2], 2 * math.pi)
                chord = math.hypot(b[0] - a[0], b[1] - a[1])
                bulge = chord * turn / 2 * t * (1 - t)
                ux, uy = ((b[0] - a[0]) / chord, (b[1] - a[1]) / chord) if chord else (0, 0)
                x, y = x + bulge * uy, y - bulge * ux
                theta = a[2] + t * turn
                worst = max(worst, abs(math.hypot(x - 0.2 * math.cos(theta), y - 0.2 * math.sin(theta)) - radius))
        rows.append([radius, code, f"{100 * worst:.4f}"])
    table("Convert: arcs sampled every 5 cm, poses interpolated", ["radius m", "exit", "largest rake error cm"], rows)
    rows, cpu = converter.rows(program, folder)
    table("Convert: 5 random paths of 8 m, curvature linear between random values every 0.5 m", ["bends", "largest rake error, arcs from row to row, every 1 cm, cm", "every 5 cm", "steered by the rows' curvatures, every 1 cm, cm", "every 5 cm"], rows)
    print(f"\n100,000 points: {cpu:.2f} s of processor time with reading and writing.")


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("--shared", default=ROOT.parent / "shared", type=Path)
    parser.add_argument("--only", default="drawings,clipart,svg,tour,connect,fill,fill-vehicles,convert,simulate,backing")
    parser.add_argument("--all", action="store_true", help="connect: 100,000 pairs by the judge's rule; fill: more fresh shapes, every shape turned and scaled, 1,000 random regions")
    parser.add_argument("--lkh", help="tour: the program of LKH, to run beside ours")
    parser.add_argument("--agreement", help="the program that draws beside librsvg")
    arguments = parser.parse_args()
    global AGREEMENT, EVERYTHING, LKH
    AGREEMENT, EVERYTHING, LKH = arguments.agreement, arguments.all, arguments.lkh
    program = Path(arguments.program).resolve()
    version = run([program, "--version"])[1].strip()
    print(f"# Bench\n\n{version}, measured {time.strftime('%Y-%m-%d')} by `scripts/bench`. Times are of a shared two-core machine: compare ratios.")
    with tempfile.TemporaryDirectory() as folder:
        for name in arguments.only.split(","):
            globals()[name.replace("-", "_")](program, arguments.shared, Path(folder))


if __name__ == "__main__":
    main()
