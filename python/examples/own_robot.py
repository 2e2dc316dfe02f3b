#!/usr/bin/env python3
"""A robot of your own: described, planned for, driven by a noisy controller, shown.

    python3 own_robot.py [DRAWING.svg] [--out FOLDER]

Writes mine.toml (the profile), plan.json, sand.png and flaws.png.
"""

import argparse
import pathlib

import strandline

HERE = pathlib.Path(__file__).resolve().parent

#: A broad machine with nine pins on three wheels. What is not said is as on the BeachBot.
MINE = {
    "base": "beachbot",
    "name": "broad",
    "rake_offset": 0.35,
    "pins": 9,
    "pin_pitch": 0.08,
    "min_radius": 0.8,
    "sharpness": 4,
    "speed": 0.4,
    "travel_speed": 0.6,
    "front": 0.6,
    "back": 0.6,
    "half_width": 0.5,
    "wheels": [(0, 0.4, 0.12), (0, -0.4, 0.12), (0.45, 0, 0.12)],  # x ahead, y left, width
    "rake_rules": [(0, 0), (2, 1), (5, 3), (9, 9)],  # strokes up to that width: so many pins
}


def main():
    parser = argparse.ArgumentParser(description="a robot of your own")
    parser.add_argument("drawing", nargs="?", default=HERE.parents[1] / "drawings" / "sailboat.svg")
    parser.add_argument("--out", type=pathlib.Path, default=pathlib.Path("."))
    arguments = parser.parse_args()
    arguments.out.mkdir(parents=True, exist_ok=True)

    try:
        strandline.robot({**MINE, "min_radius": -1})
    except strandline.InputError as error:
        print(f"a wrong profile is refused: {error}")

    (arguments.out / "mine.toml").write_text(strandline.robot_toml(MINE))
    for name, robot in (("beachbot", "beachbot"), ("broad", MINE)):
        plan = strandline.plan(arguments.drawing, robot=robot, canvas=(20, 20))
        report = plan.check()
        print(f"{name}: {plan.figures['drawn']:.1f} m drawn, {plan.figures['up_driven']:.1f} m rake up, "
              f"{plan.figures['time'] / 60:.1f} min; {'sound' if report['sound'] else 'not sound'}, "
              f"areas {100 * report['coverage']:.1f} % raked")
    plan.save(arguments.out / "plan.json")

    exact = plan.simulate()
    driven = plan.simulate(noise=0.02, delay=0.2, seed=7)
    for name, sim in (("exactly", exact), ("with noise and delay", driven)):
        report = sim.report
        print(f"driven {name}: intersection over union {report['intersection_over_union']:.3f}, "
              f"lines off by {1000 * report['lateral_rms']:.0f} mm (rms)")
    (arguments.out / "sand.png").write_bytes(driven.png(480))
    (arguments.out / "flaws.png").write_bytes(driven.png(480, flaws=True))
    print(f"mine.toml, plan.json, sand.png and flaws.png are in {arguments.out}")


if __name__ == "__main__":
    main()
