#!/usr/bin/python3
"""schemas.py PROGRAM: what the program writes agrees with docs/schemas, and every schema refuses broken twins of it.

The twins are made from the real outputs: a key left out, a key too many, a value of another kind; and, by hand, what each schema is
for. Editor's projects are checked with one that `strandline serve` keeps, and with the steps of every kind of change.
"""
import copy, json, re, signal, subprocess, sys, tempfile, urllib.request
from pathlib import Path

import jsonschema

ROOT = Path(__file__).resolve().parents[2]
SCHEMAS = {path.name.removesuffix(".schema.json"): json.loads(path.read_text()) for path in sorted((ROOT / "docs/schemas").glob("*.json"))}
SQUARE = {"polygon": {"outer": [[0, 0], [4, 0], [4, 3], [0, 3]], "holes": [[[1, 1], [1, 2], [2, 2], [2, 1]]]}, "width": 0.5}
EDITS = [{"edit": "link", "a": ["a", 0], "b": ["b", -1]}, {"edit": "entry", "at": ["a", 1]}, {"edit": "direction", "element": "a", "direction": "ccw"},
         {"edit": "hint", "element": "a", "name": "ink", "value": "off"}, {"edit": "order", "elements": ["a", "b"]},
         {"edit": "draw", "element": "d", "paths": [["M", 0, 0, "L", 1, 1, "C", 1, 2, 2, 2, 2, 1, "Z"]], "pins": 1, "smooth": 0.02},
         {"edit": "through", "from": "a", "to": "b", "poses": [[1, 2, 0.5]]}, {"edit": "through", "from": "a", "to": "a", "poses": [[1, 2, 0.5]], "hop": [0, 0, 1, 1]}]
# A change that no schema may let pass: what stands at the path becomes this.
BY_HAND = {"plan": [(["version"], 2), (["robot", "pins"], 0), (["samples", "motion", 0], "swim"), (["drawing", "elements", 0, "draw"], {"dot": []}), (["edits", 0, "edit"], "wish")],
           "project": [(["steps", 0, "changes", 0], {"set": "", "value": "1"}), (["sources", 0], {"title": "a.svg"}), (["version"], 2)],
           "fidelity": [(["intersection_over_union"], 1.5), (["places", 0, "area"], -1)], "check": [(["sound"], "yes"), (["faults", 0, "law"], 7)],
           "summary": [(["lines"], 1.5), (["time"], -1)], "tour-instance": [(["elements", 0, "points"], [[0, 0]]), (["start"], [1]), (["elements", 1, "sense"], "left")],
           "tour-solution": [([0, "entry_index"], -1)], "fill-polygon": [(["polygon", "outer"], [[0, 0], [1, 0]]), (["width"], 0)],
           "fill-strokes": [(["strokes", 0, "mask"], "0120"), (["strokes", 0, "pts"], [])], "fill-account": [(["cell"], 0), (["hops"], 0.5)],
           "connect-pair": [(["start"], [0, 0]), (["R"], -1)], "connect-curve": [(["samples"], [[0, 0]])], "trace": [(["moves", 0, "kind"], "fly")],
           "locate": [(["markers", 0, "off"], -1), (["site", "latitude"], "47")]}


class Program:
    def __init__(self, program, folder): self.program, self.folder = program, folder

    def __call__(self, *arguments, text=None, codes=(0,)):
        done = subprocess.run([self.program, "-q", *map(str, arguments)], cwd=self.folder, input=text, capture_output=True, text=True)
        if done.returncode not in codes: sys.exit(f"strandline {' '.join(map(str, arguments))}: exit {done.returncode}\n{done.stderr}")
        return done.stdout

    def read(self, name): return json.loads((self.folder / name).read_text())


def plans(run):
    """plan files that use what a plan may hold: areas, faults, edits, stops, fences, a parked robot, another machine"""
    run("plan", ROOT / "drawings/lighthouse.svg", "-o", "light.json", "--rule", "id=moon: tool=2", "--keep-out", "1,12 2,12 2,13", "--park", "0,0,1rad", "--set", "trajectory.step=5cm")
    run("plan", ROOT / "drawings/hello.svg", "-o", "hello.json", "--link", "ello:-1=o:0", "--entry", "mark:0", "--direction", "o=ccw", "--border", "-2,-2 16,-2 16,16 -2,16", "--set", "trajectory.step=5cm")
    run("plan", ROOT / "drawings/labyrinth.svg", "-o", "table.json", "--robot", "sandtable", "--canvas", "50x50cm", "--margin", "2cm")
    return [run.read(name) for name in ("light.json", "hello.json", "table.json")]


def project(run):
    """as the server keeps it, and the same with a step of every kind"""
    (run.folder / "kept").mkdir()
    server = subprocess.Popen([run.program, "serve", ROOT / "drawings/hello.svg", "--folder", run.folder / "kept", "--port", "0", "--web", ROOT / "tests/docs/web"], stdout=subprocess.PIPE, text=True)
    try:
        address = re.search(r"http://\S+", server.stdout.readline())[0]
        urllib.request.urlopen(address.replace("localhost", "127.0.0.1"), timeout=20).read()
    finally:
        server.send_signal(signal.SIGINT)
        server.wait(20)
    kept = json.loads(next((run.folder / "kept").glob("*.strandline")).read_text())
    changed = kept | {"done": 2, "steps": [{"what": "all", "changes": [{"set": "fill.style", "value": "zigzag"}, {"source": 0}, *({"edit": edit} for edit in EDITS)]},
                                           {"what": "less", "changes": [{"drop": EDITS[0]}]}]}
    return [kept, changed]


def outputs(run):
    """-> schema's name: texts that it has to accept"""
    lines = lambda text: [json.loads(line) for line in text.splitlines()]
    made = {"plan": plans(run), "project": project(run)}
    made["plan"].append(made["plan"][1] | {"edits": EDITS})
    made["summary"] = [json.loads(run("plan", ROOT / "drawings/hello.svg", "-o", "x.json", "--json"))]
    made["check"] = [json.loads(run("check", name, "--json", codes=(0, 3))) for name in ("light.json", "hello.json")]
    made["fidelity"] = [json.loads(run("simulate", "light.json", "--json", "--cell", "4cm")),
                        json.loads(run("simulate", "hello.json", "--json", "--cell", "4cm", "--noise", "--against", "hello.json"))]
    made["trace"] = [json.loads(run("export", "light.json", "--format", "trace"))]
    made["tour-instance"] = [{"start": None, "elements": [{"closed": False, "points": [[0, 0], [1, 0]]}, {"closed": True, "points": [[3, 0], [4, 0], [4, 1]], "sense": "ccw"}, {"closed": False, "points": [[5, 5], [6, 6]]}],
                              "links": [[[0, 1], [1, 0]]], "before": [[0, 2]]},
                             {"start": [0, 0], "end": "start", "elements": [{"closed": False, "points": [[1, 1], [2, 2]], "direction": "backward"}]}]
    made["tour-solution"] = [json.loads(run("tour", "-", text=json.dumps(instance))) for instance in made["tour-instance"]]
    made["tour-solution"].append(json.loads(run("tour", "-", "--entries", "edges", text=json.dumps(made["tour-instance"][0]))))
    made["fill-polygon"] = [SQUARE]
    made["fill-strokes"] = [json.loads(run("fill", "-", *more, text=json.dumps(SQUARE))) for more in ((), ("--pins", 7), ("--style", "zigzag"))]
    run("fill", "-", "-o", "strokes.json", text=json.dumps(SQUARE))
    made["fill-account"] = [json.loads(run("fill", "-", "--json", "-o", "strokes.json", text=json.dumps(SQUARE)))]
    made["connect-pair"] = [{"start": [0, 0, 0], "end": [2, 1, 1]}, {"start": [0, 0, 0], "end": [4, 0, 0], "R": 0.5, "sigma": 10, "obstacles": [[[1, -1], [2, -1], [2, 1]]], "clearance": 0.2, "id": "a"}]
    made["connect-curve"] = lines(run("connect", "-", text="\n".join(map(json.dumps, made["connect-pair"])), codes=(0, 3)))
    flags = "name,x,y,latitude,longitude,radius\na,0,0,47.3769,8.5417,\nb,14,0,47.3769309,8.5418799,\npole,,,47.37699,8.54177,30cm\n"
    made["locate"] = [json.loads(run("locate", "-", "--json", "-o", "site.toml", text=flags))]
    return made


def twins(value, schema):
    """-> (what is wrong, the broken text)"""
    optional = {key for key in schema["properties"] if key not in schema["required"]}
    for key in value:
        if key not in optional: yield f"without {key}", {k: v for k, v in value.items() if k != key}
        if schema["properties"][key]: yield f"with {key} of another kind", value | {key: 7 if isinstance(value[key], dict) else {"neither": True}}
    if schema.get("additionalProperties") is False: yield "with a key too many", value | {"one_too_many": 1}


def at(value, path, replacement):
    broken = copy.deepcopy(value)
    inner = broken
    for step in path[:-1]: inner = inner[step]
    inner[path[-1]] = replacement
    return broken


def main(program):
    faults, accepted, refused = [], 0, 0
    with tempfile.TemporaryDirectory() as folder: made = outputs(Program(program, Path(folder)))
    for name in SCHEMAS.keys() ^ made.keys(): faults.append(f"{name}: no schema, or nothing that it is tried on")
    for name, schema in SCHEMAS.items():
        jsonschema.Draft202012Validator.check_schema(schema)
        judge = jsonschema.Draft202012Validator(schema)
        for value in made.get(name, []):
            accepted += 1
            for error in judge.iter_errors(value): faults.append(f"{name}: refuses what the program writes at /{'/'.join(map(str, error.absolute_path))}: {error.message[:200]}")
        good = made[name][1 if name == "project" else -1 if name == "plan" else 0]
        if isinstance(good, dict):
            for what, broken in twins(good, schema):
                refused += 1
                if judge.is_valid(broken): faults.append(f"{name}: takes a twin {what}")
        for path, replacement in BY_HAND[name]:
            refused += 1
            tried = [value for value in made[name] if has(value, path)]
            if not tried or judge.is_valid(at(tried[0], path, replacement)): faults.append(f"{name}: takes {replacement!r} at {path}, or has nothing there")
    for fault in faults: print(fault, file=sys.stderr)
    print(f"{len(SCHEMAS)} schemas, {accepted} texts taken, {refused} twins refused but for {len(faults)} faults")
    return 1 if faults else 0


def has(value, path):
    for step in path:
        if isinstance(value, list) and len(value) <= step or isinstance(value, dict) and step not in value: return False
        value = value[step]
    return True


sys.exit(main(sys.argv[1]))
