"""What ends up in the sand: plans simulated, driven by a controller, read back from the robot text, cut and lifted late."""
import csv, json, math, statistics

from harness import peak_mb, run, table


def simulated(program, *arguments):
    code, out, err, cpu, _ = run([program, "simulate", "-q", "--json", *arguments])
    if code != 0: raise RuntimeError(f"simulate {arguments}: {err}")
    return json.loads(out), cpu


def shortest_hold(path, pins=7):
    """metres of rake path between two switches of one pin within a stroke: the smallest"""
    rows, least = list(csv.DictReader(open(path))), math.inf
    for pin in range(pins):
        held, state, switched, stroke = 0.0, None, False, None
        for a, b in zip(rows, rows[1:]):
            if a["motion"] != "draw" or a["stroke"] != stroke:
                held, state, switched, stroke = 0.0, None, False, a["stroke"] if a["motion"] == "draw" else None
                if stroke is None: continue
            down = int(a["pins"]) >> pin & 1
            if state is not None and down != state:
                if switched: least = min(least, held)
                held, switched = 0.0, True
            state = down
            held += math.hypot(float(b["rake_x"]) - float(a["rake_x"]), float(b["rake_y"]) - float(a["rake_y"]))
    return least


def plan_of(program, path, folder, *extra):
    out = folder / f"{path.stem}{len(extra)}.json"
    code, _, err, _, _ = run([program, "plan", path, "-o", out, "-q", *extra])
    if code != 0: raise RuntimeError(f"{path.stem}: {err}")
    return out


def bound(r, centimetres):
    """1 - c x perimeter / area"""
    return 1 - centimetres / 100 * r["fill_perimeter"] / r["fill_area"]


def goal(value, least): return f"{value:.4f} ({'≥' if value >= least else '<'} {least:.4f})"


SEEDS = range(1, 6)


def rows_of(program, path, folder):
    plan = plan_of(program, path, folder)
    ideal, cpu = simulated(program, plan)
    late, _ = simulated(program, plan, "--noise", "0", "--wander", "0", "--delay", "0.12s")
    noisy = [simulated(program, plan, "--noise", "--seed", seed)[0] for seed in SEEDS]
    run([program, "export", plan, "--format", "beachbot", "-o", folder / "pair.txt"])
    run([program, "export", plan, "--format", "csv", "-o", folder / "plan.csv"])
    text, _ = simulated(program, folder / "pair_robot.txt", folder / "pair_rake.txt", "--against", plan)
    hold = shortest_hold(folder / "plan.csv")
    areas, lines = ideal["fill_area"] > 0, ideal["line_length"] > 0
    mean = lambda key: statistics.mean(r[key] for r in noisy)
    sand = [path.stem, f"{ideal['intersection_over_union']:.4f}",
            goal(ideal["fill_union"], bound(ideal, 1.5)) if areas else "",
            goal(min(r["fill_union"] for r in noisy), bound(ideal, 3)) if areas else "",
            f"{ideal['border_over_cm']:.2f} + {ideal['border_missing_cm']:.2f}" if areas else "",
            f"{100 * ideal['lateral_mean']:.2f} / {100 * mean('lateral_mean'):.2f}" if lines else "",
            f"{100 * ideal['width_error']:.2f}" if lines else "",
            f"{ideal['track_on_fill']:.2f} / {ideal['track_on_line']:.2f} / {ideal['track']:.1f}", f"{text['same_sand']:.4f}", f"{cpu:.2f}"]
    loop = [path.stem, f"{100 * late['tracking_max']:.2f}", f"{100 * max(r['tracking_rms'] for r in noisy):.2f}",
            f"{100 * max(r['tracking_max'] for r in noisy):.2f}", f"{ideal['planned_time']:.0f}",
            f"{100 * (late['time'] / ideal['planned_time'] - 1):+.2f} / {100 * (max(r['time'] for r in noisy) / ideal['planned_time'] - 1):+.2f}",
            f"{100 * hold:.1f}" if hold < math.inf else ""]
    return sand, loop


def pins_row(program, path, folder):
    """a lift delay of 0.15 s, told early and not: border errors in the closed loop with exact places"""
    plan = plan_of(program, path, folder, "--set", "robot.lift_delay=0.15")
    exact = ["--noise", "0", "--wander", "0", "--delay", "0"]
    led, late = simulated(program, plan, *exact)[0], simulated(program, plan, *exact, "--late-pins")[0]
    pair = lambda r: f"{r['border_over_cm']:.2f} + {r['border_missing_cm']:.2f}"
    still, _ = simulated(program, plan)
    return [path.stem, pair(still), pair(led), pair(late)]


def large_row(program, folder):
    """100 x 100 m wholly raked"""
    rows = int(100 / 0.36)
    with open(folder / "large.csv", "w") as out:
        out.write("x,y,heading,pins\n")
        for k in range(rows):
            y, ahead = 0.2 + 0.36 * k, k % 2 == 0
            for i in range(201):
                out.write(f"{i * 0.5 if ahead else 100 - i * 0.5},{y},{0 if ahead else math.pi},{127 if i < 200 else 0}\n")
    call = [program, "simulate", folder / "large.csv", "--canvas", "100x100", "-q", "--json"]
    _, _, _, cpu, _ = run(call)
    return f"{cpu:.1f} s, {peak_mb(call):.0f} MB"


def report(program, shared, folder, root):
    head = ["drawing", "IoU all", "IoU areas, ideal (goal)", "IoU areas, noise, worst of 5 (goal)", "border over + missing, cm per m",
            "lines aside, mean, ideal / noise, cm", "line width off, cm", "tracks on areas / lines / clean, m²", "text pair: IoU with the plan's sand", "CPU s"]
    drive = ["drawing", "delay 0.12 s alone: max, cm", "noise and drift: rms, worst of 5", "max, worst of 5", "planned s", "driven: exact / noise, %", "shortest hold of a pin, cm"]
    for title, paths in (("drawings of 2014", sorted((shared / "drawings").glob("*.svg"))), ("our own drawings", sorted((root / "drawings").glob("*.svg")))):
        if not paths: continue
        both = [rows_of(program, p, folder) for p in paths]
        table(f"Simulated: {title} (beachbot, 14 x 14 m, cells of 1 cm)", head, [b[0] for b in both])
        table(f"Closed loop: {title}", drive, [b[1] for b in both])
        filled = [p for p, b in zip(paths, both) if b[0][2]]
        if filled: table(f"Pins that take 0.15 s: {title}; border over + missing, cm per m", ["drawing", "as planned", "driven, told early", "driven, told when due"], [pins_row(program, p, folder) for p in filled])
    print(f"\n100 x 100 m wholly raked, cells of 1 cm: {large_row(program, folder)}")
