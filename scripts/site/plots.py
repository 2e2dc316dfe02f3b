"""What the program's numbers look like: plots as SVG texts. Metres in, y up; each function makes one picture."""
import json, math, random

INK, UP, SOFT, ROBOT = "#1c1b19", "#d0281c", "#9b9484", "#2f6db3"
FACE = 'font-family="DejaVu Sans" font-size="13" fill="#333"'


def sheet(width, height, body):
    return f'<svg xmlns="http://www.w3.org/2000/svg" width="{width:.0f}" height="{height:.0f}"><rect width="100%" height="100%" fill="#fdfcf9"/>{"".join(body)}</svg>'


def line(points, colour=INK, width=1.6, extra=""):
    return f'<polyline points="{" ".join(f"{x:.2f},{y:.2f}" for x, y in points)}" fill="none" stroke="{colour}" stroke-width="{width}" {extra}/>'


def text(x, y, words, anchor="start"): return f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" {FACE}>{words}</text>'


class Frame:
    """metres -> pixels of one panel"""

    def __init__(self, points, left, top, width, height, margin=12):
        xs, ys = [p[0] for p in points], [p[1] for p in points]
        self.scale = min((width - 2 * margin) / max(max(xs) - min(xs), 1e-9), (height - 2 * margin) / max(max(ys) - min(ys), 1e-9))
        self.x0, self.y0 = (min(xs) + max(xs)) / 2, (min(ys) + max(ys)) / 2
        self.cx, self.cy = left + width / 2, top + height / 2

    def __call__(self, point): return self.cx + self.scale * (point[0] - self.x0), self.cy - self.scale * (point[1] - self.y0)
    def all(self, points): return [self(p) for p in points]


def pose(frame, at, heading, colour, length=14):
    x, y = frame(at)
    tip = (x + length * math.cos(heading), y - length * math.sin(heading))
    wing = lambda turn: (tip[0] - 6 * math.cos(heading + turn), tip[1] + 6 * math.sin(heading + turn))
    return line([(x, y), tip], colour, 2) + line([wing(.5), tip, wing(-.5)], colour, 2)


# ---- connect, curve, route -------------------------------------------------------------------------------------

ANGLES = [k * math.pi / 4 for k in range(8)]


def angle_pairs():
    """from one pose to 2 m ahead: the start angle varies by row, the end angle by column"""
    return [{"start": [0, 0, a], "end": [2, 0, b]} for a in ANGLES for b in ANGLES]


def angle_grid(curves):
    side, body = 104, []
    for k, curve in enumerate(curves):
        row, column = divmod(k, len(ANGLES))
        left, top = 64 + column * side, 40 + row * side
        frame = Frame([(-1.1, -1.5), (3.1, 1.5)], left, top, side, side, 3)
        body.append(f'<rect x="{left}" y="{top}" width="{side - 4}" height="{side - 4}" fill="#f5f0e4"/>')
        body.append(line(frame.all(curve["samples"]), UP, 1.5))
        body += [pose(frame, curve["start"][:2], curve["start"][2], "#128c3c", 11), pose(frame, curve["end"][:2], curve["end"][2], "#1f4fa8", 11)]
    for k, angle in enumerate(ANGLES):
        body += [text(64 + k * side + side / 2, 28, f"{math.degrees(angle):.0f}°", "middle"), text(54, 40 + k * side + side / 2, f"{math.degrees(angle):.0f}°", "end")]
    body.append(text(8, 28, "start \\ end"))
    return sheet(64 + 8 * side + 4, 44 + 8 * side, body)


def bends(points):
    """-> (arc length, curvature) of equally spaced samples"""
    out, s = [], 0.0
    for a, b, c in zip(points, points[1:], points[2:]):
        s += math.dist(a, b)
        turn = math.remainder(math.atan2(c[1] - b[1], c[0] - b[0]) - math.atan2(b[1] - a[1], b[0] - a[0]), 2 * math.pi)
        out.append((s, 2 * turn / (math.dist(a, b) + math.dist(b, c))))
    return out


def chart(left, top, width, height, series, low, high, title, marks=()):
    """series: (colour, [(x, y)]); marks: (y, words), dashed"""
    end = max(x for _, points in series for x, _ in points)
    at = lambda x, y: (left + width * x / end, top + height * (high - min(max(y, low), high)) / (high - low))
    body = [f'<rect x="{left}" y="{top}" width="{width}" height="{height}" fill="#f5f0e4"/>', text(left, top - 6, title), line([at(0, 0), at(end, 0)], SOFT, 1)]
    for y, words in marks: body += [line([at(0, y), at(end, y)], SOFT, 1, 'stroke-dasharray="4 3"'), text(left + width + 4, at(0, y)[1] + 4, words)]
    return body + [line([at(*p) for p in points], colour) for colour, points in series]


def curvature_of(curve):
    frame = Frame(curve["samples"], 0, 0, 360, 300, 34)
    body = [line(frame.all(curve["samples"]), UP, 2), pose(frame, curve["start"][:2], curve["start"][2], "#128c3c"), pose(frame, curve["end"][:2], curve["end"][2], "#1f4fa8")]
    body += chart(390, 40, 350, 220, [(UP, bends(curve["samples"]))], -2.3, 2.3, "curvature along it, 1/m", [(2, "1/R"), (-2, "-1/R")])
    return sheet(790, 300, body)


def connection_styles(curves):
    body = []
    for k, (style, curve) in enumerate(curves):
        left = k * 230
        frame = Frame([p for _, c in curves for p in c["samples"]], left, 20, 226, 200, 16)
        named = style + (f': breaks {curve["fallback"]}, bounded taken' if curve.get("fallback") else "")
        body += [text(left + 10, 18, named), line(frame.all(curve["samples"]), UP, 2), pose(frame, curve["start"][:2], curve["start"][2], "#128c3c"),
                 pose(frame, curve["end"][:2], curve["end"][2], "#1f4fa8")]
        body += chart(left + 14, 250, 190, 110, [(UP, bends(curve["samples"]))], -2.3, 2.3, "curvature, ±1/R dashed", [(2, ""), (-2, "")])
    return sheet(920, 372, body)


def routed(straight, way, rings):
    frame = Frame([*straight["samples"], *way["samples"], *(p for ring in rings for p in ring)], 0, 0, 800, 420, 24)
    body = [f'<polygon points="{" ".join("%.1f,%.1f" % q for q in frame.all(ring))}" fill="{SOFT}" stroke="{SOFT}" stroke-width="{2 * .25 * frame.scale:.1f}" stroke-opacity=".35" stroke-linejoin="round"/>' for ring in rings]
    body += [line(frame.all(straight["samples"]), SOFT, 1.5, 'stroke-dasharray="5 4"'), line(frame.all(way["samples"]), UP, 2.4),
             pose(frame, way["start"][:2], way["start"][2], "#128c3c"), pose(frame, way["end"][:2], way["end"][2], "#1f4fa8")]
    return sheet(800, 420, body)


# ---- tour ------------------------------------------------------------------------------------------------------

def strokes_of(path, studio):
    """elements of a tour instance from a drawing, by the plan that draws it"""
    studio.plan(path, "--robot", "plotter", "--canvas", "A4")
    moves = json.loads(studio.run("export", "plan.json", "--format", "trace"))["moves"]
    rounded = [[[round(x, 4), round(y, 4)] for x, y in move["pts"][::6] + move["pts"][-1:]] for move in moves if move["kind"] == "draw"]
    return [{"closed": points[0] == points[-1], "points": points[:-1] if points[0] == points[-1] else points} for points in rounded]


def tours(panels):
    body, side = [], 330
    for k, (method, elements, found) in enumerate(panels):
        frame = Frame([p for e in elements for p in e["points"]], k * side, 24, side, 270)
        at, total = None, 0.0
        for step in found:
            element = elements[step["element"]]
            points = element["points"]
            if element["closed"]:
                enter = leave = points[step["entry_index"]]
                points = points + points[:1]
            else:
                enter, leave = (points[-1], points[0]) if step["reversed"] or step["entry_index"] else (points[0], points[-1])
            body.append(line(frame.all(points)))
            if at:
                total += math.dist(at, enter)
                body.append(line(frame.all([at, enter]), UP, 1.2))
            at = leave
        body.append(text(k * side + 12, 18, f"{method}: {1000 * total:.0f} mm pen up"))
    return sheet(3 * side, 300, body)


# ---- rake and robot ----------------------------------------------------------------------------------------------

def two_paths(panels, width=300):
    """the rake's path, thick where it is down, and the robot's turning point's"""
    body = []
    for k, (title, samples) in enumerate(panels):
        frame = Frame([(s["x"], s["y"]) for s in samples] + [(s["rake_x"], s["rake_y"]) for s in samples], k * width, 22, width, width, 16)
        for a, b in zip(samples, samples[1:]):
            if a["pins"]: body.append(line(frame.all([(a["rake_x"], a["rake_y"]), (b["rake_x"], b["rake_y"])]), INK, 3.5, 'stroke-linecap="round"'))
        body.append(line(frame.all([(s["x"], s["y"]) for s in samples]), ROBOT, 1.6))
        body.append(text(k * width + 12, 18, title))
    body.append(text(12, width + 40, "black: the rake, pins down; blue: the robot's turning point"))
    return sheet(width * len(panels), width + 52, body)


def in_time(samples):
    t = [s["t"] for s in samples]
    pick = lambda name: [(x, s[name]) for x, s in zip(t, samples)]
    return sheet(820, 420, chart(14, 28, 740, 100, [(INK, pick("v"))], 0, .25, "speed, m/s", [(.2, "0.2")])
                 + chart(14, 166, 740, 100, [(ROBOT, pick("omega"))], -.5, .5, "turn rate, rad/s", [(.4, "0.4"), (-.4, "-0.4")])
                 + chart(14, 304, 740, 100, [(UP, pick("curvature"))], -5, 5, "curvature of the robot's path, 1/m", [(2, "1/R"), (-2, "-1/R")]))


def wander(names, rows):
    column = lambda name: [float(row[names.index(name)]) for row in rows]
    true = list(zip(column(names[0]), column(names[-1])))
    end = max(abs(y) for _, y in true) * 100 * 1.15
    return sheet(820, 180, chart(14, 28, 740, 130, [(UP, [(t, 100 * y) for t, y in true])], 0, end, "how far the rake is off its planned path, cm, over the seconds of the drive", [(1, "1 cm"), (2, "2 cm")]))


# ---- the rest ----------------------------------------------------------------------------------------------------

def rings(filled):
    frame = Frame(filled["polygon"]["outer"], 0, 0, 520, 520)
    body = []
    for outline in [filled["polygon"]["outer"], *filled["polygon"]["holes"]]: body.append(line(frame.all(outline + outline[:1]), SOFT, 2))
    for stroke in filled["strokes"]: body.append(line(frame.all(stroke["pts"]), INK if stroke["down"] else UP, 1.3 if stroke["down"] else .9))
    return sheet(520, 520, body)


def on_the_map(features):
    """metres east and north of the canvas's corner, north up"""
    shapes = [(f["properties"], f["geometry"]) for f in features["features"]]
    flat = lambda g: [g["coordinates"]] if g["type"] == "LineString" else g["coordinates"] if g["type"] == "Polygon" else []
    lon0, lat0 = next(flat(g)[0][0] for p, g in shapes if p["what"] == "canvas")[:2]
    metres = lambda p: ((p[0] - lon0) * 111320 * math.cos(math.radians(lat0)), (p[1] - lat0) * 111200)
    canvas = next([metres(p) for p in flat(g)[0]] for p, g in shapes if p["what"] == "canvas")
    frame = Frame(canvas, 0, 0, 560, 520, 40)
    colours = {"canvas": ("#f5f0e4", SOFT, 1.5), "keep-out": ("#e3b6a6", UP, 1.2), "raked": ("none", INK, 1.4), "driven, rake up": ("none", UP, 1)}
    body = []
    for properties, geometry in shapes:
        if properties["what"] not in colours: continue
        fill, stroke, width = colours[properties["what"]]
        for points in flat(geometry):
            path = " ".join("%.2f,%.2f" % frame(metres(p)) for p in points)
            body.append(f'<{"polygon" if geometry["type"] == "Polygon" else "polyline"} points="{path}" fill="{fill}" stroke="{stroke}" stroke-width="{width}"/>')
    for name, corner in zip(("south-west", "south-east", "north-east"), canvas):
        x, y = frame(corner)
        body += [line([(x, y), (x, y - 16)], "#1f4fa8", 2), f'<polygon points="{x},{y - 16} {x + 11},{y - 12} {x},{y - 8}" fill="#1f4fa8"/>', text(x, y + 16, name, "middle")]
    body += [line([(530, 60), (530, 24)], INK, 2), line([(525, 32), (530, 24), (535, 32)], INK, 2), text(530, 76, "N", "middle")]
    return sheet(560, 520, body)


def photographed(picture):
    """noise and a shadow, as a phone would see it"""
    chance = random.Random(2014)
    grey = picture.convert("L")
    pixels = [min(255, max(0, int(value * (1 - .12 * (k % picture.width) / picture.width) + chance.gauss(0, 9)))) for k, value in enumerate(grey.getdata())]
    grey.putdata(pixels)
    return grey.convert("RGB")
