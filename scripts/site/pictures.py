"""pictures.py PROGRAM FOLDER [NAME ...]: makes the pictures of docs/pictures into FOLDER, all or those named, and says which are not as in docs/pictures.
Plans, sand and films are the program's own pictures; plots are drawn from the numbers that its stages and exports write. Not made here: editor-*.png
(web/tests, with STRANDLINE_PICTURES), docs/fill (scripts/bench --only fill-pictures).
"""
import io, json, subprocess, sys, tempfile
from pathlib import Path

from PIL import Image

import plots

ROOT = Path(__file__).resolve().parents[2]
PICTURES = ROOT / "docs/pictures"
REMADE = ROOT / "drawings/remade"
FLAGS = "name,x,y,latitude,longitude,radius\nsouth-west,0,0,47.3769000,8.5417000,\nsouth-east,14,0,47.3769309,8.5418799,\nnorth-east,14,14,47.3770534,8.5418342,\npole,,,47.3770155,8.5416705,30cm\n"


class Studio:
    """the program, a folder to work in, and what is put together there"""

    def __init__(self, program, folder):
        self.program, self.folder = program, folder

    def run(self, *arguments, text=None, code=0):
        done = subprocess.run([self.program, "-q", *map(str, arguments)], cwd=self.folder, input=text, capture_output=True, text=True)
        if done.returncode not in (0, code): sys.exit(f"strandline {' '.join(map(str, arguments))}: exit {done.returncode}\n{done.stderr}")
        return done.stdout

    def plan(self, drawing, *options):
        self.run("plan", drawing if Path(drawing).is_absolute() else ROOT / "drawings" / drawing, "-o", "plan.json", *options)

    def rendered(self, drawing, *options, pixels=560):
        self.plan(drawing, *options)
        self.run("render", "plan.json", "-o", "plan.png", "--pixels", pixels)
        return self.read("plan.png")

    def sand(self, *options, pixels=700):
        self.run("simulate", "plan.json", "-o", "sand.png", "--pixels", pixels, *options)
        return self.read("sand.png")

    def drive(self):
        """-> the samples as dictionaries of numbers"""
        head, *rows = self.run("export", "plan.json", "--format", "csv").splitlines()
        names = head.split(",")
        return [{name: value if name == "motion" else float(value) for name, value in zip(names, row.split(","))} for row in rows]

    def read(self, name):
        with Image.open(self.folder / name) as picture: return picture.convert("RGB")


def from_svg(svg, paper="white"):
    png = subprocess.run(["rsvg-convert", "-b", paper], input=svg.encode(), capture_output=True, check=True).stdout
    return Image.open(io.BytesIO(png)).convert("RGB")


def beside(*pictures, gap=8, columns=None):
    """pictures in rows"""
    columns = columns or len(pictures)
    rows = [pictures[k:k + columns] for k in range(0, len(pictures), columns)]
    heights = [max(p.height for p in row) for row in rows]
    sheet = Image.new("RGB", (max(sum(p.width + gap for p in row) for row in rows) - gap, sum(heights) + gap * (len(rows) - 1)), "white")
    y = 0
    for row, height in zip(rows, heights):
        x = 0
        for picture in row:
            sheet.paste(picture, (x, y))
            x += picture.width + gap
        y += height + gap
    return sheet


def few(picture):
    """64 colours keep a page under a megabyte: 44 for what there is most of, 20 so that a mark of a few pixels keeps its own"""
    colours = []
    for number, method in ((44, Image.Quantize.MEDIANCUT), (20, Image.Quantize.MAXCOVERAGE)):
        colours += picture.quantize(number, method).getpalette()[:3 * number]
    palette = Image.new("P", (1, 1))
    palette.putpalette(colours)
    return picture.quantize(palette=palette, dither=Image.Dither.NONE)


def cropped(picture, left, top, right, bottom):
    w, h = picture.size
    return picture.crop((int(left * w), int(top * h), int(right * w), int(bottom * h)))


# ---- a function a picture --------------------------------------------------------------------------------------

def starfish(s): return s.rendered("starfish.svg", pixels=900)
def starfish_sand(s): s.plan("starfish.svg"); return s.sand(pixels=800)


def starfish_flaws(s):
    s.plan("starfish.svg")
    s.run("simulate", "plan.json", "--flaws", "flaws.png", "--pixels", 800)
    return s.read("flaws.png")


def occlusion(s): return beside(s.rendered("sailboat.svg"), s.rendered("sailboat.svg", "--occlusion", "off"))
def beach(s):
    return s.rendered("starfish.svg", "--park", "0,0,45deg", "--exit", "outside", "--keep-out", "11.5,11.5 13,11.5 13,13 11.5,13", pixels=700)


def plotter(s): return s.rendered("sailboat.svg", "--robot", "plotter", "--canvas", "A5-landscape", "--margin", "10mm", pixels=700)
def turf(s): return s.rendered("waves.svg", "--robot", "turf", "--canvas", "40x30", pixels=800)
def sand_table(s):
    s.plan("labyrinth.svg", "--robot", "sandtable", "--canvas", "50x50cm", "--margin", "2cm")
    return s.sand(pixels=600)


def diff_drive(s): return s.rendered("hello.svg", "--robot", "diffdrive", "--canvas", "2x1", "--margin", "10cm", pixels=800)
def rover(s):
    (s.folder / "rover.toml").write_text('base = "beachbot"\nname = "rover"\npins = 1\npin_pitch = "15cm"\nrake_offset = "35cm"\nmin_radius = "80cm"\n')
    (s.folder / "site.toml").write_text(s.run("locate", "-", text=FLAGS))
    return s.rendered("waves.svg", "--robot", "rover.toml", "--config", "site.toml", pixels=700)


def tutorial_drawing(s): return from_svg((ROOT / "drawings/lighthouse.svg").read_text().replace('width="200mm" height="240mm"', 'width="380" height="456"'))
def tutorial_plan(s): return s.rendered("lighthouse.svg", pixels=700)
def tutorial_sand(s): s.plan("lighthouse.svg", "--canvas", "20x20"); return s.sand("--noise", "--seed", 7, "--cell", "2cm", pixels=600)


def tutorial_flaws(s):
    s.plan("lighthouse.svg", "--canvas", "20x20")
    s.run("simulate", "plan.json", "--flaws", "flaws.png", "--pixels", 600, "--noise", "--seed", 7, "--cell", "2cm")
    return s.read("flaws.png")


def film(s):
    s.plan("hello.svg", "--canvas", "14x8")
    s.run("simulate", "plan.json", "-o", "f-%03d.png", "--seconds", 1, "--pixels", 360)
    frames = sorted(s.folder.glob("f-*.png"))
    return beside(*(s.read(frames[k].name) for k in (2, 5, 8, len(frames) - 1)), columns=2)


def tracking(s):
    s.plan("hello.svg")
    s.run("simulate", "plan.json", "--noise", "--seed", 7, "--log", "log.csv")
    head, *rows = (s.folder / "log.csv").read_text().splitlines()
    return from_svg(plots.wander(head.split(","), [row.split(",") for row in rows]))


def avoid(s):
    return beside(s.rendered("crab.svg", "--avoid", "off"), s.rendered("crab.svg"))


def tour(s):
    elements = plots.strokes_of(REMADE / "fish.svg", s)
    panels = []
    for method in ("file", "nearest", "best"):
        found = json.loads(s.run("tour", "-", "--method", method, text=json.dumps({"start": None, "elements": elements})))
        panels.append((method, elements, found))
    return from_svg(plots.tours(panels))


def angles(s):
    pairs = plots.angle_pairs()
    curves = s.run("connect", "-", "--radius", "0.5m", "--sharpness", "10", text="\n".join(map(json.dumps, pairs)))
    return from_svg(plots.angle_grid([json.loads(line) for line in curves.splitlines()]))


def backing(s):
    return beside(s.rendered("starfish.svg"), s.rendered("starfish.svg", "--set", "robot.can_back_up=on"))


def styles(s):
    pair = {"start": [0, 0, 0.6], "end": [3.2, 0.6, -1.9], "R": 0.5, "sigma": 10}
    curves = [(style, json.loads(s.run("connect", "-", "--style", style, text=json.dumps(pair), code=3))) for style in ("bounded", "fair", "spiro", "bezier")]
    return from_svg(plots.connection_styles(curves))


def route(s):
    rings = [[[2, -1], [3, -1], [3, 1.2], [2, 1.2]], [[4.2, 0], [5.6, 0.2], [5.2, 2.6], [4.4, 2.2]], [[0.6, 1.6], [1.8, 2.2], [1, 3]]]
    pair = {"start": [0, 0, 0], "end": [7, 1.5, 0.8], "R": 0.5, "sigma": 10}
    straight = json.loads(s.run("connect", "-", text=json.dumps(pair)))
    round_ = json.loads(s.run("connect", "-", text=json.dumps(pair | {"obstacles": rings, "clearance": 0.25}), code=3))
    return from_svg(plots.routed(straight, round_, rings))


def follow(s):
    s.plan(corner_drawing(s), "--canvas", "3x3", "--margin", "30cm")
    return from_svg(plots.two_paths([("", s.drive())], width=700))


def corner_drawing(s):
    path = s.folder / "corner.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="100mm" height="100mm" viewBox="0 0 100 100"><path fill="none" stroke="#000" stroke-width="1" d="M 0,60 L 60,60 L 100,0"/></svg>')
    return path


def corners(s):
    panels = []
    for title, settings in (("exact", ()), ("loop", ("corner.threshold=20deg",)), ("round", ("corner.threshold=20deg", "corner.above=round")),
                            ("pivot", ("corner.threshold=20deg", "corner.above=pivot", "robot.can_pivot=true"))):
        s.plan(corner_drawing(s), "--canvas", "4x4", "--margin", "30cm", *(word for setting in settings for word in ("--set", setting)))
        panels.append((title, s.drive()))
    return from_svg(plots.two_paths(panels))


def speeds(s):
    s.plan(corner_drawing(s), "--canvas", "4x4", "--margin", "30cm", "--set", "corner.threshold=20deg")
    return from_svg(plots.in_time(s.drive()))


def masks(s):
    return cropped(s.rendered(REMADE / "logo.svg", pixels=2600), .6, .42, .98, .68)


def legibility(s):
    s.plan("mandala.svg")
    s.run("simulate", "plan.json", "--flaws", "flaws.png", "--pixels", 1400)
    return cropped(s.read("flaws.png"), .3, .3, .7, .7)


def parts(s):
    s.plan("crab.svg")
    s.run("split", "plan.json", "--every", "16min", "-o", "part.json")
    pictures = []
    for part in sorted(s.folder.glob("part-*.json")):
        s.run("render", part, "-o", "part.png", "--pixels", 560)
        pictures.append(s.read("part.png"))
    return beside(*pictures)


def trace(s):
    photo = from_svg((ROOT / "drawings/crab.svg").read_text().replace('width="240mm" height="200mm"', 'width="480" height="400"').replace("#000", "#5d4a32"), "#cdbb95")
    noisy = plots.photographed(photo)
    noisy.save(s.folder / "photo.png")
    s.run("trace", "photo.png", "-o", "traced.svg", "--set", "trace.despeckle=50")
    traced = from_svg((s.folder / "traced.svg").read_text()).resize((480, 400))
    return beside(noisy, traced, s.rendered(s.folder / "photo.png", "--set", "trace.despeckle=50", pixels=460))


def typeset(s):
    path = s.folder / "words.svg"
    path.write_text('<svg xmlns="http://www.w3.org/2000/svg" width="200mm" height="100mm" viewBox="0 0 200 100"><text x="10" y="62" font-family="DejaVu Serif" '
                    'font-weight="bold" font-size="52">Tide</text><path fill="none" stroke="#000" stroke-width="3" d="M 10,84 C 60,74 120,94 190,80"/></svg>')
    return s.rendered(path, "--canvas", "14x8", pixels=700)


def located(s):
    (s.folder / "site.toml").write_text(s.run("locate", "-", text=FLAGS))
    s.plan("shells.svg", "--config", "site.toml")
    return from_svg(plots.on_the_map(json.loads(s.run("export", "plan.json", "--format", "geojson"))))


def curvature(s):
    pair = {"start": [0, 0, 0], "end": [2.4, 1.2, 2.2], "R": 0.5, "sigma": 10}
    return from_svg(plots.curvature_of(json.loads(s.run("connect", "-", text=json.dumps(pair)))))


def insets(s):
    outer = [[0, 0], [9, 0], [9, 3], [6, 3], [6, 7], [9, 9], [4, 10], [0, 8]]
    filled = json.loads(s.run("fill", "-", text=json.dumps({"polygon": {"outer": outer, "holes": [[[2, 2], [2, 5], [4, 5], [4, 2]]]}, "width": 0.5})))
    return from_svg(plots.rings(filled))


def broken(s):
    s.plan("hello.svg", "--keep-out", "3,5 5,5 5,8 3,8")
    s.run("render", "plan.json", "-o", "plan.png", "--pixels", 560)
    return s.read("plan.png")


def lion(s):
    links = ("--link", "mouth:0=cheek-left:-1", "--link", "brow:0=cheek-left:0")
    return beside(*(s.rendered(REMADE / "lion.svg", *links[:2 * k], pixels=480) for k in (0, 1, 2)))


def fish(s): return beside(*(s.rendered(REMADE / "fish.svg", "--rule", f"id=frame: order={order}", pixels=560) for order in (-1, 1)))
def logo(s): return beside(*(s.rendered(REMADE / "logo.svg", "--set", f"fill.style={style}", pixels=480) for style in ("rings", "spiral", "zigzag")))
def letters(s): return s.rendered(words(s), "--canvas", "14x8", pixels=700)


def words(s):
    path = s.folder / "letters.svg"
    path.write_text(s.run("text", "Strand", "--font", "scripts", "--height", "1m"))
    return path


NAMES = {"starfish": starfish, "starfish-sand": starfish_sand, "starfish-flaws": starfish_flaws, "occlusion": occlusion, "beach": beach, "plotter": plotter, "turf": turf,
         "sand-table": sand_table, "diff-drive": diff_drive, "rover": rover, "tutorial-drawing": tutorial_drawing, "tutorial-plan": tutorial_plan,
         "tutorial-sand": tutorial_sand, "tutorial-flaws": tutorial_flaws, "film": film, "tracking": tracking, "avoid": avoid, "tour": tour, "angles": angles,
         "styles": styles, "backing": backing, "route": route, "follow": follow, "corners": corners, "speeds": speeds, "masks": masks, "legibility": legibility, "parts": parts,
         "trace": trace, "typeset": typeset, "located": located, "curvature": curvature, "insets": insets, "broken": broken, "lion": lion, "fish": fish, "logo": logo,
         "letters": letters}


def main(program, into, names):
    into.mkdir(parents=True, exist_ok=True)
    for name in names or NAMES:
        with tempfile.TemporaryDirectory() as folder:
            picture = NAMES[name](Studio(program, Path(folder)))
        kept, made = PICTURES / f"{name}.png", into / f"{name}.png"
        before = kept.read_bytes() if kept.exists() else None
        few(picture).save(made, optimize=True)
        print(f"{name}.png {picture.width} x {picture.height}{'' if made.read_bytes() == before else ', not as in docs/pictures'}", file=sys.stderr)


main(str(Path(sys.argv[1]).resolve()), Path(sys.argv[2]), sys.argv[3:])
