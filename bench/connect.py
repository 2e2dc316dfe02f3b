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


def report(program, shared, folder, n):
    judge = shared / "judge/curves/checkcurves.cpp"
    if not judge.is_file():
        return print("\nConnect: the judge is not at hand; left out (tests/connect holds the laws).")
    binary = folder / "checkcurves"
    subprocess.run(["g++", "-O2", "-std=c++17", str(judge), "-o", str(binary)], check=True)
    lengths(program, binary, folder, n)
    styles(program, binary, folder)
    corners(program, binary, folder)
