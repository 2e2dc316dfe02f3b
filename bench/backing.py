"""Backing up: the same drawings by a robot that drives forward only and by one that may back up (robot.can_back_up)."""
import json

from harness import run, table
from simulate_drawings import fresh


def driven(program, path, folder, backs):
    out = folder / "backing.json"
    code, _, err, cpu, _ = run([program, "plan", path, "-o", out, "-q", "--set", f"robot.can_back_up={'on' if backs else 'off'}"])
    if code != 0: raise RuntimeError(f"{path.stem}: {err}")
    _, text, _, _, _ = run([program, "check", out, "--json"])
    plan, report = json.loads(out.read_text()), json.loads(text)
    speeds = plan["samples"]["speed"]
    begins = sum(1 for a, b in zip(speeds, speeds[1:]) if b < 0 <= a)
    return plan["figures"] | {"time": plan["samples"]["t"][-1], "cpu": cpu, "begins": begins, "faults": len(report["faults"])}


def report(program, shared, folder, root):
    rows, shares = [], []
    paths = sorted((shared / "drawings").glob("*.svg")) + sorted((root / "drawings").glob("*.svg")) + list(fresh(folder))
    for path in paths:
        on, back = driven(program, path, folder, False), driven(program, path, folder, True)
        shares.append(back["time"] / on["time"])
        rows.append([path.stem, f"{on['up_driven']:.1f}", f"{back['up_driven']:.1f}", f"{on['time']:.0f}", f"{back['time']:.0f}", f"{shares[-1]:.3f}", back["begins"],
                     f"{on['faults']}, {back['faults']}", f"{on['cpu']:.2f}, {back['cpu']:.2f}"])
    table("Backing up: beachbot, 14 x 14 m, forward only and with can_back_up",
          ["drawing", "rake up m, forward", "backing", "drive s, forward", "backing", "ratio", "times it backs", "faults of check, both", "planning CPU s, both"], rows)
    print(f"\nRatio of the times, mean of {len(shares)} drawings: {sum(shares) / len(shares):.3f}; worst {max(shares):.3f}.")
