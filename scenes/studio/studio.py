#!/usr/bin/env python3
"""Makes the scene STUDIO: studio.obj, studio.mtl and the textures beside this script. Needs nothing but Python 3.

usage: studio.py [FOLDER]       writes FOLDER/studio.obj, FOLDER/studio.mtl and FOLDER/studio/*.png; FOLDER is by
                                default the one above the script

An attic room, 4.8 m wide (x), 5.2 m deep (z) and 3 m high (y). Its right side is below a sloping ceiling with a roof
window; the gable wall at z = 0 is of brick and has a large window. Metres, y up. Every solid is closed and stands on
what carries it. Coordinates are whole multiples of 10 micrometres, added as integers, so that the faces of boxes are exact
parallelograms however they are turned, and the scene is the same on every machine.
"""

import math
import os
import struct
import sys
import zlib

UNIT = 100000  # steps in a metre

WIDTH, DEPTH, HEIGHT = 4.8, 5.2, 3.0
KNEE = 1.0  # height of the wall below the slope
RIDGE = 2.4  # x where the slope meets the flat ceiling
SLOPE = (WIDTH - RIDGE, KNEE - HEIGHT, 0.0)  # down along the sloping ceiling


class Random:
    """Linear congruential generator of 64 bits (Knuth, MMIX), so that the scene does not depend on Python's own."""

    def __init__(self, seed):
        self.state = seed

    def number(self, low=0.0, high=1.0):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        return low + (high - low) * (self.state >> 33) / 2**31

    def index(self, count):
        return min(int(self.number() * count), count - 1)


# ---- textures ------------------------------------------------------------------------------------------------------


def png(pixels):
    """The bytes of a PNG file of rows of (r, g, b), 0 to 255: with a palette if 256 colours suffice."""
    height, width = len(pixels), len(pixels[0])
    colours = sorted({colour for row in pixels for colour in row})
    number = {colour: k for k, colour in enumerate(colours)}
    indexed = len(colours) <= 256
    line = (lambda row: bytes(number[c] for c in row)) if indexed else (lambda row: bytes(v for c in row for v in c))
    rows = b"".join(b"\0" + line(row) for row in pixels)

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    header = struct.pack(">IIBBBBB", width, height, 8, 3 if indexed else 2, 0, 0, 0)
    palette = chunk(b"PLTE", bytes(v for c in colours for v in c)) if indexed else b""
    data = chunk(b"IDAT", zlib.compress(rows, 9))
    return b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + palette + data + chunk(b"IEND", b"")


class Noise:
    """Value noise on a torus: smooth random numbers, 0 to 1, that repeat after `cells` in each direction."""

    def __init__(self, seed, cells_x, cells_y):
        random = Random(seed)
        self.values = [[random.number() for _ in range(cells_x)] for _ in range(cells_y)]

    def at(self, s, t):
        """At fractions of the width and height."""
        rows, columns = len(self.values), len(self.values[0])
        x, y = s % 1.0 * columns, t % 1.0 * rows
        i, j = int(x), int(y)
        fx, fy = x - i, y - j
        fx, fy = fx * fx * (3 - 2 * fx), fy * fy * (3 - 2 * fy)
        low, high = self.values[j % rows], self.values[(j + 1) % rows]
        i, right = i % columns, (i + 1) % columns
        return (low[i] * (1 - fx) + low[right] * fx) * (1 - fy) + (high[i] * (1 - fx) + high[right] * fx) * fy


def mixed(a, b, share):
    return tuple(x + (y - x) * share for x, y in zip(a, b))


def scaled(colour, factor):
    return tuple(x * factor for x in colour)


def snapped(colour, step=6):
    """Multiples of `step`: few colours make small files."""
    return tuple(max(0, min(255, int(x / step + 0.5) * step)) for x in colour)


def image(width, height, colour_at, step=6):
    """Rows from above; colour_at(x, y) in pixels, y from above."""
    return [[snapped(colour_at(x, y), step) for x in range(width)] for y in range(height)]


def grain(seed, cells_along, cells_across):
    """Fibres of wood along s: 0 to 1."""
    coarse, fine = Noise(seed, cells_along, cells_across), Noise(seed + 1, 2 * cells_along, 4 * cells_across)
    return lambda s, t: 0.62 * coarse.at(s, t) + 0.38 * fine.at(s, t)


def floor_texture():
    """Sixteen oak planks, 2 m by 2 m."""
    width = height = 512
    planks = 16
    random = Random(11)
    fibres = grain(12, 10, 96)
    tones = [[random.number() for _ in range(2)] for _ in range(planks)]
    joints = [random.number(0.05, 0.45) for _ in range(planks)]

    def colour(x, y):
        plank, across = divmod(y, height // planks)
        along = (x / width - joints[plank]) % 1.0
        second = along >= 0.55
        edge = across == 0 or min(along, abs(along - 0.55)) < 1 / width
        tone = 0.35 + 0.4 * tones[plank][second] + 0.5 * (fibres(x / width + 0.37 * plank, y / height) - 0.5)
        wood = mixed((136, 100, 66), (218, 182, 138), tone)
        return scaled(wood, 0.5) if edge else wood

    return image(width, height, colour)


def wood_texture(seed, dark, light):
    """Boards of furniture, grain along the width."""
    fibres, rings = grain(seed, 5, 44), Noise(seed + 7, 2, 5)

    def colour(x, y):
        s, t = x / 256, y / 256
        wave = abs((8 * rings.at(s, t)) % 1.0 - 0.5)
        return mixed(dark, light, 0.2 + 0.6 * fibres(s, t) + 0.4 * wave)

    return image(256, 256, colour)


def plaster_texture():
    coarse, fine = Noise(31, 6, 6), Noise(32, 50, 50)

    def colour(x, y):
        s, t = x / 128, y / 128
        return scaled((238, 233, 223), 0.955 + 0.03 * coarse.at(s, t) + 0.03 * fine.at(s, t))

    return image(128, 128, colour, 3)


def brick_texture():
    """Four bricks and twelve courses in running bond, 0.96 m by 0.96 m."""
    width, course = 256, 21
    random = Random(41)
    tones = [[(random.number(), random.number()) for _ in range(4)] for _ in range(12)]
    grit, stains = Noise(42, 96, 96), Noise(43, 12, 12)

    def colour(x, y):
        row, down = divmod(y, course)
        brick, along = divmod((x + (row % 2) * 32) % width, 64)
        g, stain = grit.at(x / width, y / (12 * course)), stains.at(x / width, y / (12 * course))
        ragged = 1 if g > 0.72 else 0
        if down < 3 + ragged or along < 3 + ragged:
            return scaled((196, 184, 166), 0.86 + 0.14 * g)
        tone, hue = tones[row][brick]
        base = mixed(mixed((146, 84, 64), (190, 124, 96), tone), (196, 160, 136), 0.6 * hue)
        return scaled(mixed(base, (196, 184, 166), 0.28 * max(0.0, stain - 0.45)), 0.84 + 0.26 * g)

    return image(width, 12 * course, colour, 8)


def rug_texture():
    """A border, and rows of stepped diamonds, as on a kilim."""
    width, height = 320, 224
    wear = Noise(51, 30, 22)
    cream, red, navy, ochre = (224, 212, 188), (158, 74, 58), (58, 72, 98), (206, 164, 102)

    def colour(x, y):
        edge = min(x, y, width - 1 - x, height - 1 - y)
        knot = 0.9 + 0.06 * ((x + y) % 2) + 0.1 * wear.at(x / width, y / height)
        if edge < 6:
            base = navy
        elif edge < 10:
            base = cream
        elif edge < 24:
            base = ochre if (x // 7 + y // 7) % 2 else red
        elif edge < 28:
            base = cream
        else:
            dx, dy = abs((x - 160) % 66 - 33), abs((y - 112 + 28) % 56 - 28)
            ring = (dx // 4 * 4) / 33 + (dy // 4 * 4) / 28
            rings = ((0.2, ochre), (0.42, navy), (0.56, cream), (1.0, red), (9.0, (176, 98, 76)))
            base = next(tone for end, tone in rings if ring < end)
        return scaled(base, knot)

    return image(width, height, colour, 8)


def fabric_texture():
    """A coarse weave, near white: the material gives the colour."""
    loose = Noise(61, 16, 16)

    def colour(x, y):
        over = (x // 4 + y // 4) % 2
        thread = (x % 4 if over else y % 4) in (0, 3)
        return scaled((250, 250, 250), (0.84 if thread else 0.97) - 0.1 * loose.at(x / 64, y / 64))

    return image(64, 64, colour, 5)


def basket_texture():
    """Wickerwork."""
    tone = Noise(71, 16, 16)

    def colour(x, y):
        over = (x // 8 + y // 4) % 2
        round_light = (1.0, 0.94, 0.8, 0.6)[min(y % 4, 3)]
        return scaled((206, 162, 104) if over else (164, 118, 68), round_light * (0.85 + 0.25 * tone.at(x / 64, y / 64)))

    return image(64, 64, colour, 8)


COVERS = [(150, 44, 38), (38, 70, 106), (206, 158, 74), (58, 92, 66),
          (226, 214, 188), (96, 62, 48), (196, 104, 58), (70, 76, 88)]
SPINES = 16


def spine_texture():
    """Spines of sixteen books side by side; the k-th has the cover k modulo 8."""
    random = Random(81)
    tile, height = 32, 192
    designs = []
    for k in range(SPINES):
        base = COVERS[k % len(COVERS)]
        light = (232, 214, 170) if sum(base) < 480 else (92, 56, 44)
        bands = [random.number(0.04, 0.14), random.number(0.8, 0.95)]
        designs.append((base, light, bands, random.number(0.2, 0.3), random.number(0.5, 0.72), random.index(3)))
    worn = Noise(82, 64, 24)
    letters = [[random.number() for _ in range(64)] for _ in range(SPINES)]

    def colour(x, y):
        k, across = divmod(x, tile)
        base, light, bands, begin, end, style = designs[k]
        s, t = across / tile, y / height
        shade = (1.0 - 0.3 * (2 * s - 1) ** 4) * (0.92 + 0.12 * worn.at(x / 512, t))
        if style != 1 and any(abs(t - band) < 0.012 for band in bands):
            return scaled(light, shade)
        if style == 2 and begin - 0.04 < t < end + 0.04 and 0.12 < s < 0.88:
            base = mixed(base, (30, 26, 26), 0.6)
        if begin < t < end and 0.36 < s < 0.66 and letters[k][int(t * 63)] < 0.72:
            return scaled(light, shade)
        return scaled(base, shade)

    return image(SPINES * tile, height, colour, 8)


def print_texture():
    """Three prints side by side: hills below a sun, a leaf, and shapes."""
    width, height = 120, 160
    ridge = [Noise(90 + k, 5, 1) for k in range(3)]
    paper = (238, 230, 214)

    def hills(s, t):
        if (s - 0.62) ** 2 + ((t - 0.3) * 1.33) ** 2 < 0.025:
            return (214, 92, 52)
        for k, tone in ((2, (44, 72, 84)), (1, (106, 134, 126)), (0, (196, 176, 132))):
            if t > 0.42 + 0.15 * k + 0.2 * (ridge[k].at(s * 0.8, 0.0) - 0.5):
                return tone
        return (232, 206, 170)

    def leaf(s, t):
        x, y = s - 0.5, (t - 0.12) / 0.76
        if not 0.0 < y < 1.0:
            return paper
        half = 0.36 * 4 * y * (1 - y) * (0.55 + 0.45 * y)
        if abs(x) < 0.008 or (abs(x) < half and (y * 9 + abs(x) * 7) % 1.0 < 0.1):
            return (206, 214, 180)
        return (54, 98, 70) if abs(x) < half else paper

    def shapes(s, t):
        if (s - 0.4) ** 2 + ((t - 0.36) * 1.33) ** 2 < 0.06:
            return (42, 66, 108)
        if 0.5 < s < 0.84 and 0.3 < t < 0.78:
            return (218, 164, 60)
        return (184, 62, 46) if t > 0.62 and s < 0.62 and t - 0.62 > 0.5 * abs(s - 0.36) else paper

    def colour(x, y):
        which, inside = divmod(x, width)
        s, t = (inside + 0.5) / width, (y + 0.5) / height
        if not (0.12 < s < 0.88 and 0.1 < t < 0.9):
            return (242, 238, 228)
        return (hills, leaf, shapes)[which]((s - 0.12) / 0.76, (t - 0.1) / 0.8)

    return image(3 * width, height, colour, 4)


# Material: reflectance, emittance [W/m^2], texture, size of its tile in metres (None: the texture coordinates are given).
OAK, WALNUT = "wood.png", "beam.png"
MATERIALS = {
    "plaster": ((1, 1, 1), None, "plaster.png", (1.2, 1.2)),
    "brick": ((1, 1, 1), None, "brick.png", (0.96, 0.96)),
    "floor": ((1, 1, 1), None, "floor.png", (2.0, 2.0)),
    "oak": ((1, 1, 1), None, OAK, (1.1, 0.5)),
    "beam": ((1, 1, 1), None, WALNUT, (1.6, 0.7)),
    "paint": ((0.82, 0.81, 0.77), None, None, None),
    "rug": ((1, 1, 1), None, "rug.png", None),
    "linen": ((0.78, 0.73, 0.64), None, "fabric.png", (0.12, 0.12)),
    "mustard": ((0.74, 0.44, 0.09), None, "fabric.png", (0.1, 0.1)),
    "teal": ((0.07, 0.27, 0.3), None, "fabric.png", (0.1, 0.1)),
    "rust": ((0.55, 0.16, 0.08), None, "fabric.png", (0.1, 0.1)),
    "wicker": ((1, 1, 1), None, "basket.png", (0.16, 0.16)),
    "spine": ((1, 1, 1), None, "spines.png", None),
    "print": ((1, 1, 1), None, "prints.png", None),
    "page": ((0.8, 0.76, 0.66), None, None, None),
    "paper": ((0.86, 0.86, 0.84), None, None, None),
    "clay": ((0.56, 0.25, 0.15), None, None, None),
    "stoneware": ((0.72, 0.7, 0.66), None, None, None),
    "glaze": ((0.1, 0.24, 0.34), None, None, None),
    "soil": ((0.06, 0.04, 0.03), None, None, None),
    "leaf": ((0.09, 0.26, 0.07), None, None, None),
    "young_leaf": ((0.2, 0.4, 0.1), None, None, None),
    "stem": ((0.22, 0.2, 0.09), None, None, None),
    "metal": ((0.05, 0.05, 0.055), None, None, None),
    "mustard_paint": ((0.72, 0.42, 0.08), None, None, None),
    "brass": ((0.62, 0.42, 0.16), None, None, None),
    "aluminium": ((0.52, 0.53, 0.55), None, None, None),
    "screen": ((0.03, 0.035, 0.045), None, None, None),
    "shade": ((0.75, 0.66, 0.5), (7, 5.2, 3.4), None, None),
    "lantern": ((0.8, 0.76, 0.68), (17, 13.4, 9.3), None, None),
    "bulb": ((0, 0, 0), (300, 225, 145), None, None),
}


def linear(value):
    """From sRGB, 0 to 255, to reflectance."""
    value /= 255
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


for number, cover in enumerate(COVERS):
    MATERIALS["cover_%d" % number] = (tuple(round(linear(v), 3) for v in cover), None, None, None)

# ---- geometry ------------------------------------------------------------------------------------------------------


def steps(vector):
    return tuple(int(math.floor(x * UNIT + 0.5)) for x in vector)


def plus(a, b):
    return tuple(x + y for x, y in zip(a, b))


def minus(a, b):
    return tuple(x - y for x, y in zip(a, b))


def times(vector, factor):
    return tuple(x * factor for x in vector)


def norm(vector):
    return math.sqrt(sum(x * x for x in vector))


class Frame:
    """A place for an object: its origin and its axes, right-handed, y up before it is tilted."""

    def __init__(self, origin=(0, 0, 0), yaw=0.0, tilt=0.0):
        """Degrees: tilted about its own x axis (the top towards +z), then turned counter-clockwise seen from above."""
        c, s = math.cos(math.radians(yaw)), math.sin(math.radians(yaw))
        ct, st = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))
        self.origin = origin
        self.axes = [(c, 0.0, -s), (st * s, ct, st * c), (ct * s, -st, ct * c)]

    def vector(self, v):
        return tuple(sum(v[k] * self.axes[k][i] for k in range(3)) for i in range(3))

    def point(self, p):
        return plus(self.origin, self.vector(p))


HERE = Frame()


class Model:
    def __init__(self):
        self.objects = {}  # name: list of (material, corners, texture coordinates or None)
        self.random = Random(7)

    def face(self, name, material, corners, uvs=None):
        """Corners in steps, counter-clockwise from the front. Quads that are no parallelograms become two triangles."""
        faces = self.objects.setdefault(name, [])
        if len(corners) == 4 and plus(corners[0], corners[2]) != plus(corners[1], corners[3]):
            for part in ((0, 1, 2), (0, 2, 3)):
                self.face(name, material, [corners[k] for k in part], uvs and [uvs[k] for k in part])
        elif len(set(corners)) == len(corners):
            faces.append((material, tuple(corners), uvs and tuple(uvs)))

    def along_edges(self, material, corners, offset):
        """Texture coordinates in metres, u along the longer edge."""
        size = MATERIALS[material][3]
        if not size:
            return None
        a, b = norm(minus(corners[1], corners[0])) / UNIT, norm(minus(corners[3], corners[0])) / UNIT
        flat = [(0, 0), (a, 0), (a, b), (0, b)] if a >= b else [(0, 0), (0, a), (b, a), (b, 0)]
        return [(offset[0] + u / size[0], offset[1] + v / size[1]) for u, v in flat]

    def solid(self, name, material, low, high, frame=HERE, sides=None, skew=None):
        """A box; `sides`: other materials for "-x" ... "+z", or (material, corners of the texture) counter-clockwise
        from the front. `skew`: three edges instead of the axes of the frame, right-handed."""
        edges = skew or [frame.vector(tuple(high[k] - low[k] if k == i else 0.0 for k in range(3))) for i in range(3)]
        u, v, w = (steps(edge) for edge in edges)
        o = steps(frame.point(low))
        offset = (self.random.number(), self.random.number())
        faces = {
            "-x": (o, w, v), "+x": (plus(o, u), v, w),
            "-y": (o, u, w), "+y": (plus(o, v), w, u),
            "-z": (o, v, u), "+z": (plus(o, w), u, v),
        }
        for side, (corner, a, b) in faces.items():
            corners = [corner, plus(corner, a), plus(plus(corner, a), b), plus(corner, b)]
            own = (sides or {}).get(side, material)
            if isinstance(own, tuple):
                self.face(name, own[0], corners, own[1])
            else:
                self.face(name, own, corners, self.along_edges(own, corners, offset))

    def lathe(self, name, material, profile, segments, frame=HERE, materials=None):
        """A solid of revolution about the y axis of the frame. `profile`: (radius, height), upwards on the outside,
        and closed: from the axis to the axis. `materials`: others for parts of the profile, by number."""
        rings = []
        for radius, height in profile:
            centre = steps(frame.point((0, height, 0)))
            rings.append([plus(centre, steps(frame.vector((radius * math.cos(a), 0.0, -radius * math.sin(a)))))
                          for a in (2 * math.pi * k / segments for k in range(segments))])
        girth = 2 * math.pi * max(radius for radius, _ in profile)
        way = 0.0
        for j in range(len(profile) - 1):
            own = (materials or {}).get(j, material)
            size = MATERIALS[own][3]
            further = way + math.hypot(profile[j + 1][0] - profile[j][0], profile[j + 1][1] - profile[j][1])
            for k in range(segments):
                n = (k + 1) % segments
                uvs = None
                if size:
                    repeats = max(1, round(girth / size[0]))
                    s = [repeats * (k + e) / segments for e in (0, 1)]
                    t = [way / size[1], further / size[1]]
                    uvs = [(s[0], t[0]), (s[1], t[0]), (s[1], t[1]), (s[0], t[1])]
                self.face(name, own, *self.without_repeats(
                    [rings[j][k], rings[j][n], rings[j + 1][n], rings[j + 1][k]], uvs))
            way = further

    @staticmethod
    def without_repeats(corners, uvs):
        kept = [k for k in range(len(corners)) if corners[k] not in corners[:k]]
        return [corners[k] for k in kept], uvs and [uvs[k] for k in kept]

    def rod(self, name, material, start, end, radius, segments=16, frame=HERE):
        """A round rod between two points of the frame."""
        start, end = frame.point(start), frame.point(end)
        axis = minus(end, start)
        length = norm(axis)
        yaw = math.degrees(math.atan2(axis[0], axis[2]))
        tilt = math.degrees(math.acos(max(-1.0, min(1.0, axis[1] / length))))
        upright = abs(axis[0]) + abs(axis[2]) < 1e-9
        own = Frame(start, 0.0 if upright else yaw, tilt if not upright else 0.0)
        self.lathe(name, material, [(0, 0), (radius, 0), (radius, length), (0, length)], segments, own)

    def cushion(self, name, material, size, frame, cells=6):
        """A pillow of size x, y (thickness) and z; its middle lies at half of its thickness above the origin."""
        half = times(size, 0.5)

        def at(i, j, side):
            u, v = 2 * i / cells - 1, 2 * j / cells - 1
            u, v = u * (1.5 - 0.5 * u * u), v * (1.5 - 0.5 * v * v)  # narrow cells at the seam
            bulge = math.sqrt(max(0.0, (1 - u * u) * (1 - v * v)))
            return frame.point((half[0] * u * (0.93 + 0.07 * v * v), half[1] + side * half[1] * bulge,
                                half[2] * v * (0.93 + 0.07 * u * u)))

        tile = MATERIALS[material][3]
        for i in range(cells):
            for j in range(cells):
                for side in (1, -1):
                    cell = [(i, j), (i, j + 1), (i + 1, j + 1), (i + 1, j)][::side]
                    uvs = [(size[0] * a / cells / tile[0], size[2] * b / cells / tile[1]) for a, b in cell]
                    self.face(name, material, [steps(at(a, b, side)) for a, b in cell], uvs)

    def leaf(self, name, material, base, direction, length, width, droop):
        """A leaf of two sides without thickness, bent downwards and folded along its rib."""
        level = math.hypot(direction[0], direction[2])
        side = (-direction[2] / level, 0.0, direction[0] / level)

        def at(t, across):
            bent = (0.0, -droop * length * t * t, 0.0)
            fold = (0.0, 0.22 * width * abs(across), 0.0)
            straight = plus(times(direction, length * t), times(side, width * across))
            return steps(plus(plus(base, straight), plus(bent, fold)))

        across = lambda t, half: [at(t, -half), at(t, 0), at(t, half)]
        rows = [[at(0, 0)], across(0.3, 0.42), across(0.68, 0.36), [at(1, 0)]]
        triangles = [(rows[0][0], rows[1][0], rows[1][1]), (rows[0][0], rows[1][1], rows[1][2])]
        for k in range(2):
            a, b, c, d = rows[1][k], rows[2][k], rows[2][k + 1], rows[1][k + 1]
            triangles += [(a, b, c), (a, c, d)]
        triangles += [(rows[2][0], rows[3][0], rows[2][1]), (rows[2][1], rows[3][0], rows[2][2])]
        for a, b, c in triangles:
            self.face(name, material, [a, b, c])
            self.face(name, material, [a, c, b])

    def wall(self, name, material, origin, u, v, cuts_u, cuts_v, holes, uv_axes):
        """A wall in fields between cuts, fractions of its edges u and v, without the fields (i, j) of `holes`. The front
        is the side from which the turn from u to v is counter-clockwise. `uv_axes`: the coordinates of the texture."""
        size = MATERIALS[material][3]
        for i in range(len(cuts_u) - 1):
            for j in range(len(cuts_v) - 1):
                if (i, j) not in holes:
                    corners = [steps(plus(origin, plus(times(u, cuts_u[i + a]), times(v, cuts_v[j + b]))))
                               for a, b in ((0, 0), (1, 0), (1, 1), (0, 1))]
                    uvs = [tuple(c[axis] / UNIT / size[k] for k, axis in enumerate(uv_axes)) for c in corners]
                    self.face(name, material, corners, uvs)


# ---- the room ------------------------------------------------------------------------------------------------------

WINDOW = (1.2, 2.9, 0.62, 2.3)  # x and y of the window in the gable wall
ROOF_WINDOW = (1.45, 2.75, 0.2, 0.64)  # z, and fractions of the slope
REVEAL = 0.24


def reveal(model, name, corners, outward):
    """The four sides of a hole in a wall; corners counter-clockwise seen from the room."""
    for k in range(4):
        a, b = steps(corners[k]), steps(corners[(k + 1) % 4])
        out = steps(outward)
        quad = [a, b, plus(b, out), plus(a, out)]
        model.face(name, "plaster", quad, model.along_edges("plaster", quad, (0.0, 0.0)))


def room(model):
    x0, x1, y0, y1 = WINDOW
    z0, z1, s0, s1 = ROOF_WINDOW
    knee, ridge = KNEE / HEIGHT, RIDGE
    whole = [0, 1]
    model.wall("floor", "floor", (0, 0, 0), (0, 0, DEPTH), (WIDTH, 0, 0), whole, whole, (), (2, 0))
    model.wall("ceiling", "plaster", (0, HEIGHT, 0), (ridge, 0, 0), (0, 0, DEPTH), whole, whole, (), (0, 2))
    model.wall("left_wall", "plaster", (0, 0, DEPTH), (0, 0, -DEPTH), (0, HEIGHT, 0), whole, whole, (), (2, 1))
    model.wall("right_wall", "plaster", (WIDTH, 0, 0), (0, 0, DEPTH), (0, KNEE, 0), whole, whole, (), (2, 1))
    model.wall("slope", "plaster", (ridge, HEIGHT, 0), SLOPE, (0, 0, DEPTH), [0, s0, s1, 1],
               [0, z0 / DEPTH, z1 / DEPTH, 1], {(1, 1)}, (2, 0))
    model.wall("back_wall", "brick", (0, 0, 0), (WIDTH, 0, 0), (0, HEIGHT, 0),
               [0, x0 / WIDTH, ridge / WIDTH, x1 / WIDTH, 1], [0, y0 / HEIGHT, knee, y1 / HEIGHT, 1],
               {(1, 1), (1, 2), (2, 1), (2, 2), (2, 3), (3, 1), (3, 2), (3, 3)}, (0, 1))
    # Right of the ridge the gable ends at the slope: what the fields above leave there.
    def top(x):
        return HEIGHT + SLOPE[1] * (x - ridge) / SLOPE[0]

    gable = [[(x1, y0), (WIDTH, y0), (WIDTH, KNEE), (x1, KNEE)], [(x1, KNEE), (WIDTH, KNEE), (x1, top(x1))],
             [(ridge, y1), (x1, y1), (x1, top(x1)), (ridge, HEIGHT)]]
    size = MATERIALS["brick"][3]
    for field in gable:
        uvs = [(x / size[0], y / size[1]) for x, y in field]
        model.face("back_wall", "brick", [steps((x, y, 0)) for x, y in field], uvs)
    front = [[(0, 0), (0, HEIGHT), (ridge, HEIGHT), (ridge, 0)], [(ridge, 0), (ridge, KNEE), (WIDTH, KNEE), (WIDTH, 0)],
             [(ridge, KNEE), (ridge, HEIGHT), (WIDTH, KNEE)]]
    for field in front:
        uvs = [(x / 1.2, y / 1.2) for x, y in field]
        model.face("front_wall", "plaster", [steps((x, y, DEPTH)) for x, y in field], uvs)

    reveal(model, "window_reveal", [(x0, y0, 0), (x0, y1, 0), (x1, y1, 0), (x1, y0, 0)][::-1], (0, 0, -REVEAL))
    at = lambda s, z: plus((ridge, HEIGHT, z), times(SLOPE, s))
    length = norm(SLOPE)
    outward = times((-SLOPE[1], SLOPE[0], 0.0), REVEAL / length)
    reveal(model, "roof_reveal", [at(s0, z0), at(s1, z0), at(s1, z1), at(s0, z1)], outward)
    windows(model)
    beams(model)


def windows(model):
    x0, x1, y0, y1 = WINDOW
    back, front, bar = -0.17, -0.11, 0.06
    middle, cross_bar = (x0 + x1) / 2, y0 + 1.15
    frame = lambda low, high: model.solid("window_frame", "paint", low + (back,), high + (front,))
    frame((x0, y0), (x0 + bar, y1))
    frame((x1 - bar, y0), (x1, y1))
    frame((x0 + bar, y0), (x1 - bar, y0 + 0.09))
    frame((x0 + bar, y1 - bar), (x1 - bar, y1))
    frame((middle - 0.035, y0 + 0.09), (middle + 0.035, y1 - bar))
    for a, b in ((x0 + bar, middle - 0.035), (middle + 0.035, x1 - bar)):
        frame((a, cross_bar), (b, cross_bar + 0.035))
    model.solid("sill", "oak", (x0, y0, front), (x1, y0 + 0.03, 0.03))

    z0, z1, s0, s1 = ROOF_WINDOW
    length = norm(SLOPE)
    along, out = times(SLOPE, 1 / length), times((-SLOPE[1], SLOPE[0], 0.0), 1 / length)
    begin, end = plus((RIDGE, HEIGHT, 0.0), times(SLOPE, s0)), (s1 - s0) * length

    def sash(from_s, to_s, from_z, to_z):
        corner = plus(plus(begin, times(along, from_s)), plus(times(out, 0.13), (0, 0, from_z)))
        edges = [times(along, to_s - from_s), times(out, 0.05), (0, 0, to_z - from_z)]
        model.solid("roof_frame", "paint", corner, None, skew=edges)

    sash(0, end, z0, z0 + bar)
    sash(0, end, z1 - bar, z1)
    sash(0, bar, z0 + bar, z1 - bar)
    sash(end - bar, end, z0 + bar, z1 - bar)
    sash(bar, end - bar, (z0 + z1) / 2 - 0.02, (z0 + z1) / 2 + 0.02)


def beams(model):
    """Rafters below the slope and beams below the flat ceiling; their ends meet in the same rectangle."""
    for z in (0.5, 1.2, 2.9, 3.75, 4.6):
        deep, wide = 0.13, 0.1
        model.solid("beam", "beam", (0, HEIGHT - deep, z), (RIDGE, HEIGHT, z + wide))
        model.solid("beam", "beam", (RIDGE, HEIGHT - deep, z), None, skew=[SLOPE, (0, deep, 0), (0, 0, wide)])


# ---- books and shelves ---------------------------------------------------------------------------------------------

SHELF_DEPTH = 0.3
BOARD = 0.025


def spine_sides(tile, upright):
    s0, s1 = tile / SPINES + 0.002, (tile + 1) / SPINES - 0.002
    # On the side +x seen from the room, z runs to the left.
    corners = [(s1, 0.0), (s1, 1.0), (s0, 1.0), (s0, 0.0)] if upright else [(s0, 0.0), (s1, 0.0), (s1, 1.0), (s0, 1.0)]
    return ("spine", corners)


def book(model, low, high, frame=HERE, upright=True):
    """A book in a shelf, its spine towards +x."""
    tile = model.random.index(SPINES)
    cover = "cover_%d" % (tile % len(COVERS))
    sides = {"+x": spine_sides(tile, upright)}
    for side in ("-y", "+y") if upright else ("-z", "+z"):
        sides[side] = "page"
    sides["-x"] = "page"
    model.solid("books", cover, low, high, frame, sides)


def standing_books(model, z0, z1, y, room_height):
    """A run of books from z0, sometimes with a leaning one at its end. Returns where it ends."""
    random = model.random
    z = z0
    height = thick = 0.0
    series = 0
    while True:
        if series == 0:
            series = 1 + (random.index(4) if random.number() < 0.3 else 0)
            height, thick = random.number(0.18, min(0.28, room_height - 0.02)), random.number(0.016, 0.05)
            deep = random.number(0.13, 0.2)
            front = SHELF_DEPTH - random.number(0.012, 0.04)
        series -= 1
        if z + thick > z1:
            break
        book(model, (front - deep, y, z), (front, y + height, z + thick))
        z += thick + random.number(0.0005, 0.002)
        last = height
    if z1 - z > 0.11 and random.number() < 0.75:
        angle = random.number(10, 19)
        lean, thick = last * random.number(0.88, 0.98), random.number(0.018, 0.032)
        foot = z + lean * math.sin(math.radians(angle)) + 0.001
        if foot + thick < z1:
            book(model, (SHELF_DEPTH - 0.2, 0, 0), (SHELF_DEPTH - 0.03, lean, thick), Frame((0, y, foot), 0.0, -angle))
            z = foot + thick + 0.01
    return z


def stack(model, z, y, count):
    random = model.random
    for _ in range(count):
        thick, wide, deep = random.number(0.018, 0.04), random.number(0.2, 0.25), random.number(0.14, 0.18)
        shift = random.number(0, 0.02)
        front = SHELF_DEPTH - random.number(0.015, 0.04)
        book(model, (front - deep, y, z + shift), (front, y + thick, z + shift + wide), upright=False)
        y += thick
    return y


def vase(model, name, material, centre, size, segments=20):
    profile = [(0, 0), (0.34, 0), (0.5, 0.28), (0.47, 0.55), (0.24, 0.82), (0.27, 1.0),
               (0.22, 1.0), (0.19, 0.82), (0, 0.8)]
    model.lathe(name, material, [(r * size * 0.75, y * size) for r, y in profile], segments, Frame(centre))


def shelves(model):
    ends = [0.75, 1.45, 2.15, 2.85, 3.55]
    levels = [0.07, 0.44, 0.79, 1.12, 1.45, 1.78, 2.11, 2.42]
    for z in ends:
        model.solid("shelf", "oak", (0, 0, z - BOARD / 2), (SHELF_DEPTH, levels[-1] + BOARD, z + BOARD / 2))
    for left, right in zip(ends, ends[1:]):
        z0, z1 = left + BOARD / 2, right - BOARD / 2
        for y in levels:
            model.solid("shelf", "oak", (0, y, z0), (SHELF_DEPTH - 0.005, y + BOARD, z1))
        for low, high in zip(levels, levels[1:]):
            model.solid("shelf_back", "paint", (0, low + BOARD, z0), (0.006, high, z1))
    kinds = [  # for each bay, from the back: what stands on each level from below
        "WWsbbob", "WWbbvsb", "bBbsbbo", "BbobbbS",
    ]
    for bay, row in enumerate(kinds):
        z0, z1 = ends[bay] + BOARD / 2 + 0.004, ends[bay + 1] - BOARD / 2 - 0.004
        for level, kind in enumerate(row):
            y, above = levels[level] + BOARD, levels[level + 1]
            free = above - y
            if kind == "W":
                for k in range(2):
                    middle = z0 + (z1 - z0) * (0.27 + 0.46 * k)
                    model.solid("boxes", "wicker", (0.03, y, middle - 0.14), (0.285, y + 0.22, middle + 0.14))
            elif kind in "bB":
                standing_books(model, z0, z1 - (0.0 if kind == "B" else model.random.number(0.02, 0.2)), y, free)
            elif kind == "s":
                end = standing_books(model, z0, z0 + 0.3, y, free)
                top = stack(model, end + 0.03, y, 3)
                vase(model, "vases", "glaze", (0.17, top, end + 0.15), 0.13)
            elif kind == "S":
                stack(model, z0 + 0.04, y, 4)
                vase(model, "vases", "stoneware", (0.16, y, z1 - 0.16), 0.26)
            elif kind == "o":
                vase(model, "vases", "stoneware", (0.16, y, z0 + 0.14), 0.24)
                standing_books(model, z0 + 0.3, z1, y, free)
            elif kind == "v":
                vase(model, "vases", "clay", (0.15, y, z0 + 0.16), 0.22)
                vase(model, "vases", "glaze", (0.17, y, z0 + 0.36), 0.14)
                picture(model, Frame((0.13, y, z1 - 0.14), 90, -10), 0.17, 0.22, 0)


# ---- furniture -----------------------------------------------------------------------------------------------------


def picture(model, frame, width, height, print_number):
    """A framed print whose back lies in the plane z = 0 of its frame, seen from +z; its origin is the middle below."""
    bar, deep, half = 0.018, 0.018, width / 2
    model.solid("picture", "beam", (-half, 0, 0), (half, height, deep), frame)
    s0, s1 = print_number / 3 + 0.002, (print_number + 1) / 3 - 0.002
    model.solid("picture", "paper", (-half + bar, bar, deep), (half - bar, height - bar, deep + 0.002), frame,
                {"+z": ("print", [(s0, 0.0), (s1, 0.0), (s1, 1.0), (s0, 1.0)])})


def desk(model):
    """A desk along the right wall, below the roof window, and what lies on it."""
    top, low, high = 0.74, (4.06, 1.3), (4.76, 2.9)
    model.solid("desk", "oak", (low[0], top - 0.035, low[1]), (high[0], top, high[1]))
    for z in (low[1] + 0.06, high[1] - 0.11):
        for x in (low[0] + 0.06, high[0] - 0.11):
            model.solid("desk", "oak", (x, 0, z), (x + 0.05, top - 0.035, z + 0.05))
    apron = (low[0] + 0.11, high[0] - 0.11)
    for z in (low[1] + 0.06, high[1] - 0.11):
        model.solid("desk", "oak", (apron[0], top - 0.115, z + 0.015), (apron[1], top - 0.035, z + 0.04))
    laptop = Frame((4.36, top, 2.2), -90)
    model.solid("laptop", "aluminium", (-0.16, 0, -0.11), (0.16, 0.014, 0.11), laptop)
    model.solid("laptop", "screen", (-0.145, 0.014, -0.07), (0.145, 0.016, 0.03), laptop)
    lid = Frame(laptop.point((0, 0.016, -0.1)), -90, -18)
    model.solid("laptop", "aluminium", (-0.16, 0, -0.006), (0.16, 0.21, 0), lid, {"+z": "screen"})
    desk_lamp(model, (4.56, top, 1.62))
    mug(model, (4.26, top, 1.86), "clay", 200)
    for k, (x, z, yaw) in enumerate(((4.3, 2.62, 78), (4.33, 2.6, 96), (4.28, 2.64, 88))):
        low, high = (-0.105, 0.0008 * k, -0.1485), (0.105, 0.0008 * (k + 1), 0.1485)
        model.solid("sheets", "paper", low, high, Frame((x, top, z), yaw))
    y = top
    for k, (wide, thick) in enumerate(((0.24, 0.035), (0.22, 0.025), (0.2, 0.03))):
        tile = (1, 6, 3)[k]
        s0, s1 = tile / SPINES + 0.002, (tile + 1) / SPINES - 0.002
        sides = {"-z": ("spine", [(s1, 0.0), (s0, 0.0), (s0, 1.0), (s1, 1.0)]), "+z": "page", "+x": "page", "-x": "page"}
        model.solid("desk_books", "cover_%d" % tile, (-wide / 2, 0, -0.085), (wide / 2, thick, 0.085),
                    Frame((4.6, y, 2.68), 95 + 9 * k), sides)
        y += thick


def mug(model, place, material, yaw):
    frame = Frame(place, yaw)
    profile = [(0, 0), (0.036, 0), (0.04, 0.01), (0.04, 0.09), (0.036, 0.09), (0.036, 0.012), (0, 0.012)]
    model.lathe("mug", material, profile, 20, frame, {5: "soil"})
    # The handle: a bent bar of five pieces that ends in the side of the mug.
    middle, radius, thick = (0.0385, 0.047), 0.026, 0.005
    ring, across = [], steps(frame.vector((0, 0, -2 * thick)))
    for k in range(7):
        a = math.radians(-90 + 30 * k)
        x, y = middle[0] + radius * math.cos(a), middle[1] + radius * math.sin(a)
        dx, dy = thick * math.cos(a), thick * math.sin(a)
        inner, outer = (x - dx, y - dy), (x + dx, y + dy)
        near = [steps(frame.point(corner + (thick,))) for corner in (inner, outer)]
        ring.append(near + [plus(corner, across) for corner in near[::-1]])
    for a, b in zip(ring, ring[1:]):
        for k in range(4):
            n = (k + 1) % 4
            model.face("mug", material, [a[k], a[n], b[n], b[k]])
    model.face("mug", material, ring[0][::-1])
    model.face("mug", material, ring[-1])


def desk_lamp(model, place):
    frame = Frame(place, 0)
    model.lathe("desk_lamp", "metal", [(0, 0), (0.085, 0), (0.085, 0.018), (0, 0.018)], 24, frame)
    model.rod("desk_lamp", "metal", (0.0, 0.018, 0.0), (0.0, 0.4, 0.0), 0.007, 12, frame)
    elbow, head = (0.0, 0.4, 0.0), (-0.2, 0.455, 0.1)
    model.lathe("desk_lamp", "brass", ball(0.016, 8), 16, Frame(frame.point((0, 0.413, 0))))
    model.rod("desk_lamp", "metal", (-0.014, 0.417, 0.007), head, 0.006, 12, frame)
    shade = Frame(frame.point((-0.2, 0.355, 0.1)))
    # The profile begins inside, on the axis, and comes back to it outside: the opening looks down.
    profile = [(0, 0.092), (0.026, 0.092), (0.09, 0.0), (0.095, 0.0), (0.034, 0.1), (0, 0.1)]
    model.lathe("desk_lamp", "mustard_paint", profile, 24, shade)
    model.lathe("desk_bulb", "bulb", ball(0.024, 8, 0.062), 16, shade)


def ball(radius, parts, middle=None):
    """The profile of a sphere, from below."""
    middle = radius if middle is None else middle
    points = [(0, middle - radius)]
    for k in range(1, parts):
        a = math.pi * k / parts
        points.append((radius * math.sin(a), middle - radius * math.cos(a)))
    return points + [(0, middle + radius)]


def chair(model, place, yaw):
    frame = Frame(place, yaw)  # the sitter looks towards -z
    seat = 0.45
    for x in (-0.18, 0.18):
        model.rod("chair", "oak", (x, 0, -0.17), (x, seat - 0.03, -0.17), 0.017, 16, frame)
        model.rod("chair", "oak", (x, 0, 0.18), (x, seat - 0.03, 0.18), 0.017, 16, frame)
        model.rod("chair", "oak", (x, seat, 0.18), (x, 0.82, 0.18), 0.015, 16, frame)
    model.solid("chair", "oak", (-0.21, seat - 0.03, -0.21), (0.21, seat, 0.21), frame)
    model.solid("chair", "oak", (-0.21, 0.82, 0.165), (0.21, 0.9, 0.19), frame)
    model.solid("chair", "oak", (-0.165, 0.64, 0.172), (0.165, 0.7, 0.188), frame)


def armchair(model, place, yaw):
    frame = Frame(place, yaw)  # the sitter looks towards +z
    for x in (-0.3, 0.3):
        for z in (-0.28, 0.3):
            foot = Frame(frame.point((x, 0, z)), yaw)
            model.lathe("armchair", "oak", [(0, 0), (0.014, 0), (0.022, 0.16), (0, 0.16)], 16, foot)
    model.solid("armchair", "teal", (-0.38, 0.16, -0.36), (0.38, 0.27, 0.38), frame)
    for x in (-0.38, 0.27):
        model.solid("armchair", "teal", (x, 0.27, -0.36), (x + 0.11, 0.58, 0.38), frame)
    back = Frame(frame.point((0, 0.2886, -0.2)), yaw, -9)
    model.solid("armchair", "teal", (-0.268, 0.0, -0.12), (0.268, 0.56, 0.0), back)
    model.cushion("seat_cushion", "teal", (0.53, 0.15, 0.54), Frame(frame.point((0, 0.27, 0.1)), yaw), 6)
    model.cushion("pillow", "mustard", (0.4, 0.13, 0.4), Frame(frame.point((0.03, 0.545, -0.005)), yaw, 68), 6)


def coffee_table(model, place):
    frame = Frame(place)
    model.lathe("coffee_table", "oak", [(0, 0.4), (0.4, 0.4), (0.42, 0.412), (0.42, 0.43), (0, 0.43)], 32, frame)
    for k in range(3):
        a = math.radians(120 * k + 40)
        x, z = 0.3 * math.cos(a), 0.3 * math.sin(a)
        model.rod("coffee_table", "oak", (x, 0, z), (x, 0.4, z), 0.02, 16, frame)
    mug(model, frame.point((0.18, 0.43, 0.13)), "stoneware", 20)
    # An open book, a sheet, and a closed one.
    spread = Frame(frame.point((-0.1, 0.43, 0.1)), 24)
    model.solid("open_book", "cover_0", (-0.16, 0, -0.11), (0.16, 0.004, 0.11), spread)
    for side in (-1, 1):
        low, high = sorted((0.0, 0.152 * side))
        model.solid("open_book", "page", (low, 0.004, -0.105), (high, 0.015, 0.105), spread)
    closed = Frame(frame.point((0.05, 0.43, -0.2)), -70)
    model.solid("closed_book", "cover_2", (-0.08, 0, -0.12), (0.08, 0.03, 0.12), closed,
                {"+x": "page", "-z": "page", "+z": "page"})
    vase(model, "bowl_vase", "glaze", frame.point((0.25, 0.43, -0.06)), 0.15)


def bench(model):
    """The seat below the window."""
    x0, x1 = WINDOW[0], WINDOW[1]
    model.solid("bench", "oak", (x0, 0.385, 0), (x1, 0.42, 0.44))
    for x in (x0, (x0 + x1) / 2 - 0.0125, x1 - 0.025):
        model.solid("bench", "oak", (x, 0, 0), (x + 0.025, 0.385, 0.42))
    model.solid("bench_pad", "linen", (x0 + 0.02, 0.42, 0.04), (x1 - 0.02, 0.475, 0.43))
    model.cushion("pillow", "rust", (0.42, 0.14, 0.42), Frame((x0 + 0.3, 0.665, 0.07), 8, 70), 6)
    model.cushion("pillow", "linen", (0.4, 0.13, 0.4), Frame((x0 + 0.64, 0.655, 0.12), -10, 66), 6)
    model.cushion("pillow", "mustard", (0.42, 0.14, 0.42), Frame((x1 - 0.3, 0.665, 0.07), -6, 70), 6)
    for k, x in enumerate((x0 + 0.08, (x0 + x1) / 2 + 0.1)):
        for n in range(2):
            wide = 0.33
            model.solid("baskets", "wicker", (x + n * 0.37, 0, 0.06), (x + n * 0.37 + wide, 0.26, 0.4))


def floor_lamp(model, place):
    frame = Frame(place)
    model.lathe("floor_lamp", "metal", [(0, 0), (0.14, 0), (0.14, 0.02), (0, 0.02)], 24, frame)
    model.rod("floor_lamp", "brass", (0, 0.02, 0), (0, 1.4, 0), 0.011, 16, frame)
    model.lathe("floor_bulb", "bulb", ball(0.035, 8, 1.435), 16, frame)
    model.lathe("floor_lamp", "shade", [(0.2, 1.34), (0.15, 1.62), (0.147, 1.62), (0.197, 1.34), (0.2, 1.34)], 24, frame)
    for k in range(3):
        a = math.radians(120 * k)
        c, s = math.cos(a), math.sin(a)
        model.rod("floor_lamp", "metal", (0.011 * c, 1.38, 0.011 * s), (0.187 * c, 1.38, 0.187 * s), 0.002, 6, frame)


def pendant(model, place):
    """A flat lantern of paper that hangs from the ceiling."""
    radius = 0.15
    frame = Frame(place)
    model.lathe("lantern", "lantern", [(1.6 * r, y) for r, y in ball(radius, 12)], 24, frame)
    top = HEIGHT - place[1]
    model.rod("cord", "metal", (0, 2 * radius, 0), (0, top - 0.02, 0), 0.004, 8, frame)
    model.lathe("cord", "metal", [(0, top - 0.02), (0.05, top - 0.02), (0.05, top), (0, top)], 16, frame)


def plant(model, name, place, height, leaves, pot, material, size=1.0):
    """A pot with five stems; `pot`: its radius and height, `size`: of the leaves."""
    random = model.random
    frame = Frame(place)
    r, h = pot
    soil = 0.86 * h
    profile = [(0, 0), (0.72 * r, 0), (r, h), (0.9 * r, h), (0.87 * r, soil), (0, soil)]
    model.lathe(name + "_pot", material, profile, 24, frame, {4: "soil"})
    stems = 5
    for k in range(stems):
        a = 2 * math.pi * (k + 0.3 * random.number()) / stems
        lean = random.number(0.1, 0.2) * height
        foot = (0.3 * r * math.cos(a), soil, 0.3 * r * math.sin(a))
        top = (lean * math.cos(a), soil + height * random.number(0.7, 1.0), lean * math.sin(a))
        model.rod(name, "stem", foot, top, 0.006 * math.sqrt(size), 8, frame)
        for n in range(leaves):
            t = 0.3 + 0.7 * (n + 0.5 * random.number()) / leaves
            turn = a + 2.4 * n + random.number(-0.4, 0.4)
            rise = random.number(0.15, 0.7)
            base = frame.point(plus(foot, times(minus(top, foot), t)))
            length, level = size * random.number(0.2, 0.34), math.sqrt(1 - 0.6 * rise * rise)
            if base[0] + length * level * math.cos(turn) < 0.02:  # in the wall
                continue
            model.leaf(name, "leaf" if random.number() < 0.7 else "young_leaf", base,
                       (level * math.cos(turn), rise, level * math.sin(turn)), length, size * random.number(0.13, 0.2),
                       random.number(0.3, 0.75))


def pouf(model, place):
    profile = [(0, 0), (0.2, 0), (0.255, 0.05), (0.275, 0.13), (0.275, 0.23), (0.255, 0.31), (0.2, 0.355),
               (0.1, 0.37), (0, 0.372)]
    model.lathe("pouf", "rust", profile, 24, Frame(place))
    model.solid("pouf_book", "cover_1", (-0.11, 0.372, -0.08), (0.11, 0.4, 0.08), Frame(place, 35),
                {"-x": "page", "+x": "page", "-z": "page"})


def basket(model, place):
    frame = Frame(place)
    model.lathe("basket", "wicker", [(0, 0), (0.17, 0), (0.21, 0.3), (0.195, 0.3), (0.158, 0.02), (0, 0.02)], 24, frame)
    model.cushion("blanket", "linen", (0.3, 0.2, 0.26), Frame(plus(place, (0, 0.17, 0)), 30, 12), 6)


def furnish(model):
    model.solid("rug", "linen", (0.62, 0, 1.2), (3.05, 0.008, 2.9), HERE,
                {"+y": ("rug", [(0.0, 0.0), (0.0, 1.0), (1.0, 1.0), (1.0, 0.0)])})
    shelves(model)
    bench(model)
    desk(model)
    chair(model, (3.72, 0, 2.18), -78)
    armchair(model, (1.12, 0.008, 1.9), 62)
    coffee_table(model, (2.38, 0.008, 1.92))
    floor_lamp(model, (0.62, 0, 0.42))
    pendant(model, (2.05, 2.1, 2.1))
    plant(model, "plant", (3.35, 0, 0.55), 0.95, 8, (0.17, 0.32), "clay")
    plant(model, "shelf_plant", (0.16, 2.445, 1.8), 0.2, 4, (0.07, 0.12), "stoneware")
    for x, pot in ((2.2, "stoneware"), (2.38, "clay")):
        plant(model, "herbs", (x, WINDOW[2] + 0.03, -0.04), 0.12, 4, (0.055, 0.1), pot, 0.35)
    pouf(model, (2.95, 0, 3.3))
    basket(model, (0.7, 0, 3.95))
    picture(model, Frame((0.86, 1.46, 0)), 0.42, 0.56, 0)
    picture(model, Frame((3.26, 1.5, 0)), 0.33, 0.44, 2)
    picture(model, Frame((4.66, 0, 0.9), -90, -12), 0.5, 0.66, 1)
    model.solid("door", "paint", (0.5, 0, DEPTH - 0.04), (1.4, 2.05, DEPTH))


# ---- files ---------------------------------------------------------------------------------------------------------

TEXTURES = {
    "floor.png": floor_texture,
    OAK: lambda: wood_texture(21, (140, 98, 60), (212, 168, 118)),
    WALNUT: lambda: wood_texture(25, (62, 40, 26), (122, 84, 54)),
    "plaster.png": plaster_texture,
    "brick.png": brick_texture,
    "rug.png": rug_texture,
    "fabric.png": fabric_texture,
    "basket.png": basket_texture,
    "spines.png": spine_texture,
    "prints.png": print_texture,
}

OBJ_COMMENT = """\
# STUDIO: an attic room with a roof window, a gable window, books, a desk and three lamps, in the evening. Metres, y up.
# By day: --sky 60,75,95 --sun 83,46,130,114,92. Made by studio/studio.py, which tells more; change that, not this file.
"""

MTL_COMMENT = """\
# Made by studio/studio.py. Kd: diffuse reflectance, times the texture; Ke: emittance in W/m^2; red, green, blue
"""


def decimal(number, digits):
    """Without zeros at the end."""
    text = ("%.*f" % (digits, number)).rstrip("0").rstrip(".")
    return "0" if text == "-0" else text


def obj_text(model):
    lines = [OBJ_COMMENT, "mtllib studio.mtl\n"]
    places, textures = {}, {}

    def number(known, key, keyword, digits, scale):
        if key not in known:
            known[key] = len(known) + 1
            lines.append(keyword + " " + " ".join(decimal(x / scale, digits) for x in key) + "\n")
        return known[key]

    for name, faces in model.objects.items():
        lines.append("o %s\n" % name)
        material = None
        for own, corners, uvs in sorted(faces, key=lambda face: face[0]):
            if own != material:
                material = own
            words = []
            for k, corner in enumerate(corners):
                word = str(number(places, corner, "v", 5, UNIT))
                if uvs:
                    key = tuple(int(math.floor(x * 1000 + 0.5)) for x in uvs[k])
                    word += "/%d" % number(textures, key, "vt", 3, 1000)
                words.append(word)
            lines.append((material, "f " + " ".join(words) + "\n"))
    text, material = [], None
    for line in lines:
        if isinstance(line, tuple):
            if line[0] != material:
                material = line[0]
                text.append("usemtl %s\n" % material)
            line = line[1]
        text.append(line)
    return "".join(text)


def mtl_text():
    text = [MTL_COMMENT]
    for name, (reflectance, emittance, texture, _) in MATERIALS.items():
        text.append("\nnewmtl %s\nKd %s\n" % (name, " ".join(decimal(x, 3) for x in reflectance)))
        if emittance:
            text.append("Ke %s\n" % " ".join(decimal(x, 3) for x in emittance))
        if texture:
            text.append("map_Kd studio/%s\n" % texture)
    return "".join(text)


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    folder = sys.argv[1] if len(sys.argv) > 1 else os.path.dirname(here)
    os.makedirs(os.path.join(folder, "studio"), exist_ok=True)
    model = Model()
    room(model)
    furnish(model)

    def write(name, data):
        with open(os.path.join(folder, name), "wb") as file:
            file.write(data)

    write("studio.obj", obj_text(model).encode())
    write("studio.mtl", mtl_text().encode())
    for name, make in TEXTURES.items():
        write(os.path.join("studio", name), png(make()))


main()
