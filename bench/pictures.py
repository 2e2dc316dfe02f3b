"""docs/fill/*.png and docs/fill-pictures.md: the fill of every fresh shape and of our own drawings, three styles side by side.

Drawn from the strokes alone. A swath is translucent, and a stroke is drawn in pieces of less than half a revolution, so that what is raked twice is
darker and what is bare stays light; rake-up ways are dashed; green where the fill begins, red where it ends. Needs rsvg-convert and Pillow.
"""
import io, json, math, subprocess

from PIL import Image

from fill_shapes import fresh, own
from harness import run

STYLES = ("rings", "spiral", "zigzag")
SIDE, FRAME, COLOURS = 240, 6, 20  # pixels of a panel, its margin; colours keep a file under 25 kB
HALF = math.radians(150)  # of turning in a piece


def pieces(points):
    """split in the middle of segments, where no corner's wedge is lost"""
    piece, turned = [points[0]], 0.0
    for before, at, after in zip(points, points[1:], points[2:]):
        piece.append(at)
        a, b = (at[0] - before[0], at[1] - before[1]), (after[0] - at[0], after[1] - at[1])
        turned += abs(math.atan2(a[0] * b[1] - a[1] * b[0], a[0] * b[0] + a[1] * b[1]))
        if turned > HALF:
            middle = [(at[0] + after[0]) / 2, (at[1] + after[1]) / 2]
            yield piece + [middle]
            piece, turned = [middle], 0.0
    yield piece + [points[-1]]


def panel(filled, left):
    """-> SVG of one fill in its place on the sheet"""
    outlines = [filled["polygon"]["outer"], *filled["polygon"]["holes"]]
    xs, ys = zip(*outlines[0])
    scale = (SIDE - 2 * FRAME) / max(max(xs) - min(xs), max(ys) - min(ys))
    x0, y0 = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
    at = lambda p: f"{left + SIDE / 2 + scale * (p[0] - x0):.2f} {SIDE / 2 - scale * (p[1] - y0):.2f}"
    path = lambda points, end="": "M" + "L".join(map(at, points)) + end
    out = [f'<path d="{"".join(path(o, "Z") for o in outlines)}" fill="#fff6e0" fill-rule="evenodd" stroke="none"/>']
    down = [s for s in filled["strokes"] if s["down"]]
    for stroke in down:
        for piece in pieces(stroke["pts"]):
            out.append(f'<path d="{path(piece)}" stroke="#2f6db3" stroke-opacity="0.45" stroke-width="{scale * filled["width"]:.2f}" stroke-linejoin="round"/>')
    for stroke in filled["strokes"]:
        dashes = '' if stroke["down"] else ' stroke-dasharray="3 2"'
        out.append(f'<path d="{path(stroke["pts"])}" stroke="{"#123" if stroke["down"] else "#d40"}" stroke-width="0.6"{dashes}/>')
    out.append(f'<path d="{"".join(path(o, "Z") for o in outlines)}" stroke="#000" stroke-width="0.8"/>')
    for point, colour in ((down[0]["pts"][0], "#0a0"), (down[-1]["pts"][-1], "#e00")):
        x, y = at(point).split()
        out.append(f'<circle cx="{x}" cy="{y}" r="2.5" fill="{colour}"/>')
    return "\n".join(out)


def sheet(program, polygon):
    panels = []
    for k, style in enumerate(STYLES):
        code, out, _, _, _ = run([program, "fill", "-", "-q", "--style", style], stdin=json.dumps({"polygon": polygon, "width": 1}))
        if code == 0: panels.append(panel(json.loads(out), k * SIDE))
    width = len(STYLES) * SIDE
    return (f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}" height="{SIDE}" fill="none"><rect width="{width}" height="{SIDE}" fill="#fff"/>'
            + "\n".join(panels) + "</svg>")


def draw(program, folder, docs):
    (docs / "fill").mkdir(exist_ok=True)
    lines = ["# Fills, drawn", "", "Made by `scripts/bench --only fill-pictures` from the strokes alone. Rings, spiral and zigzag of a solid rake, vehicle free. A pale strip is raked once, a darker one",
             "twice, cream not at all; thin lines are the rake's middle, dashed orange ways are driven rake up; green begins, red ends.", ""]
    for title, shapes in (("Our own drawings (bench/shapes)", own()), ("Fresh shapes by seed (bench/fill_shapes.py)", fresh())):
        lines += [f"## {title}", ""]
        for name, polygon in shapes:
            file = name.replace(" #", "-").replace(" ", "-") + ".png"
            png = subprocess.run(["rsvg-convert"], input=sheet(program, polygon).encode(), capture_output=True, check=True).stdout
            plain = Image.open(io.BytesIO(png)).convert("RGB").quantize(COLOURS, Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE)
            plain.save(docs / "fill" / file, optimize=True)
            lines += [f"{name}", "", f"![{name}](fill/{file})", ""]
    (docs / "fill-pictures.md").write_text("\n".join(lines))
    print(f"\nFill pictures: {len(list((docs / 'fill').glob('*.png')))} in docs/fill, shown by docs/fill-pictures.md.")
