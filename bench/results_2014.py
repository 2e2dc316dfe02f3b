#!/usr/bin/python3
"""results_2014.py PROGRAM [FOLDER]: the table of docs/results-2014.md: what the thesis and the program of 2014 showed, planned now.

FOLDER holds the drawings of 2014 (lion_example.svg, shark_test.svg, asl_logo.svg, asl_font.svg, flower_example.svg, floral_patterns.svg, maleficient.svg), which are
not part of the project; without it only our own (drawings/remade) are planned. Metres; beachbot on 14 x 14 m. A case is a drawing and options.
"""
import json, sys, tempfile
from pathlib import Path

from harness import run, table

ROOT = Path(__file__).resolve().parent.parent
HEAD = ["case", "strokes", "drawn m", "rake up straight m", "Dubins m", "driven m", "corner loops m", "tightest rake up 1/m", "crossings", "rolled over m^2", "covered / twice / outside %", "check"]
OURS = [("lion", []), ("lion, 1 link", ["--link", "mouth:0=cheek-left:-1"]), ("lion, 2 links", ["--link", "mouth:0=cheek-left:-1", "--link", "brow:0=cheek-left:0"]),
        ("fish, frame first", ["--rule", "id=frame: order=-1"]), ("fish, frame last", ["--rule", "id=frame: order=1"]),
        *((f"logo, {style}", ["--set", f"fill.style={style}"]) for style in ("rings", "spiral", "zigzag"))]
THEIRS = ["lion_example", "shark_test", "asl_logo", "asl_font", "flower_example", "floral_patterns", "maleficient"]


def row(program, path, name, options, folder):
    plan = folder / "plan.json"
    code, text, err, _, _ = run([program, "plan", path, "-o", plan, "-q", "--json", *options])
    if code != 0: return [name, f"exit {code}: {err.strip()[:60]}"] + [""] * (len(HEAD) - 2)
    figures = json.loads(text)
    report = json.loads(run([program, "check", plan, "-q", "--json"])[1])
    areas = "" if not figures["regions"] else "%.1f / %.1f / %.1f" % tuple(100 * report[k] for k in ("coverage", "overdraw", "spill"))
    return [name, figures["strokes"], f"{figures['drawn']:.1f}", f"{figures['up_straight']:.1f}", f"{figures['up_dubins']:.1f}", f"{figures['up_driven']:.1f}", f"{figures['loops_driven']:.1f}",
            f"{figures['tightest_up']:.2f}", report["crossings"], f"{report['driven_over']:.2f}", areas, "sound" if report["sound"] else f"{len(report['faults'])} faults"]


def looked_at(program, path, folder):
    """-> ids of the elements in the order in which the plan draws them, and the one with the largest box"""
    run([program, "plan", path, "-o", folder / "plan.json", "-q"])
    plan = json.loads((folder / "plan.json").read_text())
    drawn = plan["drawing"]["elements"]

    def extent(element):
        numbers = [v for v in element["draw"].get("line", {"path": [0, 0]})["path"] if not isinstance(v, str)]
        return max(numbers) - min(numbers)

    return [drawn[plan["strokes"][entry["stroke"]]["element"]]["id"] for entry in plan["order"]], max(drawn, key=extent)["id"]


def theirs(program, folder, given):
    """The links of the lion join ends that its plan keeps far apart: half a row of strokes. The shark's frame is its largest line."""
    cases = []
    for stem in THEIRS:
        path = given / f"{stem}.svg"
        cases.append((path, stem, []))
        row, largest = looked_at(program, path, folder)
        if stem == "lion_example":
            one = ["--link", f"{row[0]}:-1={row[6]}:0"]
            cases += [(path, f"{stem}, 1 link", one), (path, f"{stem}, 2 links", [*one, "--link", f"{row[3]}:-1={row[9]}:0"])]
        if stem == "shark_test":
            cases += [(path, f"{stem}, frame {when}", ["--rule", f"id={largest}: order={order}"]) for when, order in (("first", -1), ("last", 1))]
        if stem in ("asl_logo", "asl_font"):
            cases += [(path, f"{stem}, {style}", ["--set", f"fill.style={style}"]) for style in ("spiral", "zigzag")]
    return cases


def main(program, given):
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        table("Our drawings", HEAD, [row(program, ROOT / f"drawings/remade/{case.split(',')[0]}.svg", case, options, folder) for case, options in OURS])
        if given: table("The drawings of 2014", HEAD, [row(program, path, case, options, folder) for path, case, options in theirs(program, folder, given)])


main(sys.argv[1], Path(sys.argv[2]) if len(sys.argv) > 2 else None)
