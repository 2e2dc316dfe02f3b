"""The connect section: pairs by the judge's rule and fresh ones, styles, corner loops. See quality.py."""
import json, math, random, statistics, subprocess

from harness import percent, run, table

BATCH = 10000  # pairs a file: a curve's samples take some 10 kB


def pairs(n, seed, sigma, curved):
    r = random.Random(seed)
    for i in range(n):
        d, a = 0.1 * 200 ** r.random(), r.random() * 2 * math.pi
        pair = {"start": [0, 0, r.random() * 2 * math.pi], "end": [d * math.cos(a), d * math.sin(a), r.random() * 2 * math.pi], "R": 1, "sigma": sigma, "id": i}
        if curved: pair["kappa0"], pair["kappa1"] = r.uniform(-1, 1), r.uniform(-1, 1)
        yield pair


def curves(program, folder, cases, extra=()):
    """-> (file of curves, CPU seconds)"""
    source, out = folder / "pairs.jsonl", folder / "curves.jsonl"
    source.write_text("".join(json.dumps(p) + "\n" for p in cases))
    code, _, err, cpu, _ = run([program, "connect", source, "-o", out, "-q", *extra])
    assert code == 0, err
    return out, cpu


def judged(binary, out):
    text = subprocess.run([str(binary), str(out)], capture_output=True, text=True).stdout
    return [json.loads(l) for l in text.splitlines()]


def bending(samples):
    """integral of curvature squared, by circles through three samples"""
    total = 0
    for (ax, ay), (bx, by), (cx, cy) in zip(samples, samples[1:], samples[2:]):
        ab, bc, ca = math.hypot(bx - ax, by - ay), math.hypot(cx - bx, cy - by), math.hypot(cx - ax, cy - ay)
        if ab * bc * ca > 0: total += (2 * ((bx - ax) * (cy - by) - (by - ay) * (cx - bx)) / (ab * bc * ca)) ** 2 * (ab + bc) / 2
    return total


def lengths(program, binary, folder, n):
    rows = []
    for seed, name, count in ((20140704, "rule of the judge", n), (7, "fresh", min(n, BATCH))):
        for sigma in (2.5, 10):
            for curved in (False, True):
                cases, ratios, violations, cpu = list(pairs(count, seed, sigma, curved)), [], 0, 0
                for i in range(0, count, BATCH):
                    out, seconds = curves(program, folder, cases[i:i + BATCH])
                    lines = judged(binary, out)
                    assert len(lines) == len(cases[i:i + BATCH])
                    cpu += seconds
                    violations += sum(bool(l.get("violations")) for l in lines)
                    ratios += [l["ratio"] for l in lines if "ratio" in l]
                rows.append([f"{name}, {count}", sigma, "random" if curved else "0", violations, count - len(ratios), f"{statistics.mean(ratios):.4f}",
                             f"{percent(ratios, .5):.4f}", f"{percent(ratios, .95):.4f}", f"{percent(ratios, .99):.3f}", f"{cpu / count * 1e6:.0f}"])
    table("Connect: bounded, R = 1 (time holds reading and writing the samples)",
          ["pairs", "sigma R^2", "end curvatures", "violations", "failures", "length / Dubins mean", "p50", "p95", "p99", "CPU us a pair"], rows)


def styles(program, binary, folder, n=2000):
    rows = []
    for seed, name in ((20140704, "rule of the judge"), (8, "fresh")):
        for sigma in (2.5, 10):
            cases = list(pairs(n, seed, sigma, False))
            plain = [json.loads(l) for l in curves(program, folder, cases)[0].read_text().splitlines()]
            before = [(bending(c["samples"]), j["sharpness_R2"], j["length"]) for c, j in zip(plain, judged(binary, folder / "curves.jsonl"))]
            for style, extra in (("fair", "0"), ("fair", "0.1"), ("fair", "0.25"), ("spiro", None), ("bezier", None)):
                out, cpu = curves(program, folder, cases, ["--style", style] + (["--extra-length", extra] if extra else []))
                made, lines = [json.loads(l) for l in out.read_text().splitlines()], judged(binary, out)
                ratio = lambda values: f"{statistics.median(values):.3f}"
                rows.append([f"{name}, {n}", sigma, style + (f" +{100 * float(extra):.0f} %" if extra else ""), sum(bool(l.get("violations")) for l in lines),
                             sum("fallback" in c for c in made), ratio([l["length"] / b[2] for l, b in zip(lines, before)]),
                             ratio([bending(c["samples"]) / b[0] for c, b in zip(made, before) if b[0] > 0]),
                             ratio([l["sharpness_R2"] / b[1] for l, b in zip(lines, before) if b[1] > 0]), f"{cpu / n * 1e6:.0f}"])
    table("Connect: styles against the bounded curve, end curvatures 0 (medians of the pairs' ratios)",
          ["pairs", "sigma R^2", "style", "violations", "bounded instead", "length", "bending energy", "sharpness", "CPU us a pair"], rows)


def corners(program, binary, folder):
    rows = []
    for sigma in (2.5, 10):
        cases = [{"start": [0, 0, 0], "end": [0, 0, side * math.radians(turn)], "R": 1, "sigma": sigma} for turn in range(5, 176) for side in (1, -1)]
        lines = judged(binary, curves(program, folder, cases)[0])
        longest = max(lines, key=lambda l: l["length"])
        rows.append([sigma, len(cases), sum(bool(l.get("violations")) for l in lines), f"{statistics.median(l['length'] for l in lines):.3f}", f"{longest['length']:.3f}"])
    table("Connect: from a corner's pose to its other pose, direction changes of 5 to 175 degrees, both ways",
          ["sigma R^2", "cases", "violations", "length R, median", "longest"], rows)


def blobs(r, largest):
    """20 to 60 areas on 17 m"""
    for _ in range(r.randint(20, 60)):
        x, y, size, n = r.uniform(0, 17), r.uniform(0, 17), r.uniform(.3, largest), r.randint(4, 14)
        yield [[x + d * math.cos(2 * math.pi * k / n), y + d * math.sin(2 * math.pi * k / n)] for k in range(n) for d in [size * r.uniform(.45, 1)]]


def keeps(ring, p, clearance):
    """whether the point lies outside the ring and that far from it"""
    inside, near = False, math.inf
    for (ax, ay), (bx, by) in zip(ring, ring[1:] + ring[:1]):
        if (ay > p[1]) != (by > p[1]) and p[0] < ax + (p[1] - ay) / (by - ay) * (bx - ax): inside = not inside
        dx, dy = bx - ax, by - ay
        t = max(0, min(1, ((p[0] - ax) * dx + (p[1] - ay) * dy) / (dx * dx + dy * dy)))
        near = min(near, math.hypot(p[0] - ax - t * dx, p[1] - ay - t * dy))
    return not inside and near > clearance


def obstacles(program, binary, folder, worlds=40, a_world=10):
    rows = []
    for seed, largest in ((31, .6), (32, 1.2)):
        for sigma in (2.5, 10):
            r, cases = random.Random(seed), []
            for _ in range(worlds):
                rings = list(blobs(r, largest))
                def pose():
                    while True:
                        p = [r.uniform(0, 17), r.uniform(0, 17)]
                        if all(keeps(ring, p, .26) for ring in rings): return p + [r.random() * 2 * math.pi]
                cases += [{"start": pose(), "end": pose(), "R": .5, "sigma": sigma * 4, "obstacles": rings, "clearance": .25} for _ in range(a_world)]
            source, out = folder / "pairs.jsonl", folder / "curves.jsonl"
            source.write_text("".join(json.dumps(p) + "\n" for p in cases))
            code, _, err, cpu, _ = run([program, "connect", "--quick", source, "-o", out, "-q"])
            assert code in (0, 3), err
            said = [json.loads(l).get("ok", True) for l in out.read_text().splitlines()]
            lines = judged(binary, out)
            ratios = [l["ratio"] for l, ok in zip(lines, said) if ok]
            rows.append([f"{len(cases)}, areas up to {largest} m in radius", sigma, sum(said), sum(bool(l.get("violations")) for l, ok in zip(lines, said) if ok),
                         f"{percent(ratios, .5):.3f}", f"{percent(ratios, .95):.3f}", f"{cpu / len(cases) * 1e3:.1f}"])
    table("Connect: round obstacles, 20 to 60 random areas on 17 m, clearance R/2 (time holds reading and building the ground for every pair)",
          ["pairs", "sigma R^2", "clear ways", "of them with a violation", "length / Dubins p50", "p95", "CPU ms a pair"], rows)


def tours(program, shared, folder, seeds=20):
    rows = []
    for name in ("lion_example", "floral_patterns"):
        drawing = shared / "drawings" / f"{name}.svg"
        if not drawing.is_file(): continue
        figures = []
        for seed in range(1, seeds + 1):
            code, out, err, cpu, _ = run([program, "plan", drawing, "--avoid", "off", "--set", f"tour.seed={seed}", "-o", folder / "plan.json", "-q", "--json"])
            assert code == 0, err
            figures.append((json.loads(out), cpu))
        first, best = figures[0][0], min(f["up_dubins"] for f, _ in figures)
        rows.append([name, f"{first['up_driven']:.2f}", f"{first['up_dubins']:.2f}", f"{best:.2f}", f"{first['up_driven'] / best:.3f}",
                     f"{min(f['up_driven'] for f, _ in figures):.2f}", f"{statistics.mean(cpu for _, cpu in figures):.2f}"])
    table(f"Connect: rake up as driven (--avoid off, beachbot) beside the best Dubins tour of {seeds} seeds",
          ["drawing", "driven m, seed 1", "Dubins of its order", "best Dubins tour", "driven / best", "least driven", "CPU s a plan"], rows)


def judged_crossings(program, shared, folder):
    """of lines drawn before, by the trace judge on the robot's path; "" where it is not at hand"""
    judge = shared / "judge/trace/metrics.py"
    if not judge.is_file(): return ""
    run([program, "export", folder / "plan.json", "--format", "trace", "--path", "robot", "-o", folder / "trace.json"])
    text = subprocess.run(["/usr/bin/python3", str(judge), str(folder / "trace.json"), "--eps", "0.05"], capture_output=True, text=True).stdout
    return next((line.split("/")[-1].strip() for line in text.splitlines() if line.split()[:1] == ["trav_x_line_after"]), "?")


def avoidance(program, shared, folder, root):
    rows = []
    for drawing in sorted((shared / "drawings").glob("*.svg")) + sorted((root / "drawings").glob("*.svg")):
        both = []
        for avoid in ("off", "on"):
            code, out, err, cpu, _ = run([program, "plan", drawing, "--avoid", avoid, "-o", folder / "plan.json", "-q", "--json"])
            assert code == 0, err
            plan, found = json.loads(out), json.loads(run([program, "check", folder / "plan.json", "--json"])[1])
            both.append([f"{plan['up_driven'] + plan['loops_driven']:.1f}", str(found["crossings"]), judged_crossings(program, shared, folder),
                         f"{found['over_finished']:.2f}", f"{found['driven_over']:.2f}", f"{cpu:.2f}"])
        rows.append([drawing.stem] + [f"{off} / {on}" for off, on in zip(*both)])
    table("Connect: what is finished, not avoided / avoided (beachbot, 14 x 14 m)",
          ["drawing", "rake up and corner loops m", "crossings of drawn lines", "the same by the trace judge", "m over finished areas between strokes", "m^2 of areas rolled over in all", "CPU s"], rows)


def report(program, shared, folder, n, root):
    tours(program, shared, folder)
    avoidance(program, shared, folder, root)
    judge = shared / "judge/curves/checkcurves.cpp"
    if not judge.is_file():
        return print("\nConnect: the judge is not at hand; left out (tests/connect holds the laws).")
    binary = folder / "checkcurves"
    subprocess.run(["g++", "-O2", "-std=c++17", str(judge), "-o", str(binary)], check=True)
    lengths(program, binary, folder, n)
    styles(program, binary, folder)
    corners(program, binary, folder)
    obstacles(program, binary, folder)
