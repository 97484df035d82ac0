"""Errors of pictures, a denoiser, and the tables and drawings of renderers.py.

Arrays are [row, column, colour], top row first, in W/m^2. docs/comparison.md explains measures, filters and truths.
"""

import json
import math
import os
import struct
import zlib

import numpy as np

FINE = 4  # pixels of a truth for each pixel of a picture, in each direction
GREY = np.array([0.2126, 0.7152, 0.0722])  # luminance of linear sRGB
COLOURS = {"multipath": "#0072b2", "multipath, gather": "#56b4e9", "Cycles": "#d55e00", "Cycles, denoised": "#e69f00"}


def read_pfm(path):
    kind, size, _, pixels = open(path, "rb").read().split(b"\n", 3)
    width, height = map(int, size.split())
    return np.frombuffer(pixels, "<f4").reshape(height, width, 3)[::-1].astype(float)


def write_png(path, pixels):
    """`pixels`: 0 ... 1, encoded for the screen."""
    rows = np.rint(255 * np.clip(pixels, 0, 1)).astype("u1")
    chunk = lambda kind, data: struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))
    header = struct.pack(">IIBBBBB", rows.shape[1], rows.shape[0], 8, 2, 0, 0, 0)
    data = zlib.compress(b"".join(b"\0" + row.tobytes() for row in rows), 9)
    with open(path, "wb") as file:
        file.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", header) + chunk(b"IDAT", data) + chunk(b"IEND", b""))


# ---- pixel filters -------------------------------------------------------------------------------------------------


def filtered(fine, weights):
    """A picture from one with FINE x FINE times the pixels. `weights`: of the fine pixels around that of the picture."""
    reach = (len(weights) - FINE) // 2
    for axis in (0, 1):
        padded = np.pad(fine, [(reach, reach) if k == axis else (0, 0) for k in range(3)], "edge")
        count = fine.shape[axis] // FINE
        take = lambda k: padded[k : k + FINE * count : FINE] if axis == 0 else padded[:, k : k + FINE * count : FINE]
        fine = sum(weight * take(k) for k, weight in enumerate(weights))
    return fine


BOX = np.full(FINE, 1 / FINE)  # that of the pictures of Cycles
TENT = (FINE - np.abs(np.arange(2 * FINE) + 0.5 - FINE)) / FINE**2  # that of multipath, two pixels wide


# ---- measures ------------------------------------------------------------------------------------------------------


def blurred(picture, weights):
    reach = len(weights) // 2
    for axis in (0, 1):
        padded = np.pad(picture, [(reach, reach) if k == axis else (0, 0) for k in range(picture.ndim)], "edge")
        picture = sum(w * np.take(padded, range(k, k + picture.shape[axis]), axis) for k, w in enumerate(weights))
    return picture


def for_screen(picture, scale):
    """Reinhard's tone curve of each colour, and sRGB's transfer function."""
    linear = np.clip(scale * picture / (1 + scale * picture), 0, 1)
    return np.where(linear <= 0.0031308, 12.92 * linear, 1.055 * linear ** (1 / 2.4) - 0.055)


def lab(screen):
    """CIE L*a*b* of sRGB values, white point D65 (IEC 61966-2-1, CIE 15)."""
    linear = np.where(screen <= 0.04045, screen / 12.92, ((screen + 0.055) / 1.055) ** 2.4)
    matrix = np.array([[0.4124, 0.3576, 0.1805], [0.2126, 0.7152, 0.0722], [0.0193, 0.1192, 0.9505]])
    share = linear @ matrix.T / matrix.sum(1)
    f = np.where(share > (6 / 29) ** 3, np.cbrt(share), share / (3 * (6 / 29) ** 2) + 4 / 29)
    return np.stack([116 * f[..., 1] - 16, 500 * (f[..., 0] - f[..., 1]), 200 * (f[..., 1] - f[..., 2])], -1)


def ssim(a, b):
    """Mean structural similarity of two grey pictures, 0 ... 1 (Wang, Bovik, Sheikh, Simoncelli 2004)."""
    window = np.exp(-0.5 * (np.arange(-5, 6) / 1.5) ** 2)
    mean = lambda x: blurred(x, window / window.sum())
    ma, mb = mean(a), mean(b)
    va, vb, vab = mean(a * a) - ma * ma, mean(b * b) - mb * mb, mean(a * b) - ma * mb
    c1, c2 = 0.01**2, 0.03**2
    return np.mean((2 * ma * mb + c1) * (2 * vab + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2)))


def inside(picture):
    """Without the outermost pixels, whose filter reaches out of the truth."""
    return picture[1:-1, 1:-1]


def standard_error(values):
    return values.std() / math.sqrt(values.size)


class Truth:
    """Two independent pictures of Cycles, and one of multipath, on the fine pixels."""

    def __init__(self, folder):
        read = lambda name: read_pfm(os.path.join(folder, name + ".pfm"))
        halves = [read("cycles-truth-1"), read("cycles-truth-2")]
        gathered = read("multipath-truth")
        self.halves, self.gathered, self.squares = {}, {}, {}
        for kind, weights in (("box", BOX), ("tent", TENT)):
            self.halves[kind] = [inside(filtered(half, weights)) for half in halves]
            truth = self.gathered[kind] = inside(filtered(gathered, weights))
            self.squares[kind] = blurred(truth, np.full(5, 0.2)) ** 2 + (0.1 * truth.mean()) ** 2
        self.scale = 1 / np.median(self.gathered["box"] @ GREY)
        self.edges = inside(edges(*(read("cycles-truth-1-" + name) for name in ("material", "normal", "position"))))

    def square_errors(self, picture, kind, other=None):
        """Square error of each pixel over the square of the truth's mean around it, plus a hundredth of the square of
        the picture's mean. The noises of Cycles' two pictures, or of their mean and the `other` truth, are independent,
        so that the product of the two differences has the square of the picture's own error as its mean."""
        first, second = self.halves[kind] if other is None else (sum(self.halves[kind]) / 2, other)
        return ((picture - first) * (picture - second) / self.squares[kind]).mean(-1)

    def errors(self, picture, kind):
        """Those against Cycles, or where these are too noisy, against Cycles and multipath's truth."""
        errors = self.square_errors(picture, kind)
        if standard_error(errors) < 0.1 * errors.mean():
            return errors
        return self.square_errors(picture, kind, self.gathered[kind])

    def measure(self, picture, kind):
        errors = self.errors(picture, kind)
        a, b = (for_screen(p, self.scale) for p in (picture, self.gathered[kind]))
        return {
            "relative MSE": errors.mean(),
            "standard error": standard_error(errors),
            "SSIM": ssim(a @ GREY, b @ GREY),
            "colour difference": np.sqrt(((lab(a) - lab(b)) ** 2).sum(-1)).mean(),
        }


def edges(material, normal, position):
    """The pixels with an edge of an object or a crease within one pixel, from fine pixels."""
    found = np.zeros(material.shape[:2], bool)
    for axis in (0, 1):
        before = tuple(slice(None, -1) if k == axis else slice(None) for k in (0, 1))
        after = tuple(slice(1, None) if k == axis else slice(None) for k in (0, 1))
        step = position[after] - position[before]
        off_plane = np.abs((step * normal[before]).sum(-1)) > 0.1 * np.sqrt((step**2).sum(-1)) + 1e-9
        turned = np.abs(normal[after] - normal[before]).max(-1) > 0.1
        other = np.abs(material[after] - material[before])[..., 0] > 0.01
        found[before] |= off_plane | turned | other
        found[after] |= off_plane | turned | other
    near = filtered(found[..., None].astype(float), np.ones(3 * FINE))
    return near[..., 0] > 0


# ---- denoiser ------------------------------------------------------------------------------------------------------


def denoised(picture, albedo, normal, position, material, emission):
    """Non-local means guided by features (Rousselle, Manzi and Zwicker 2013), on the light without albedo and emission.

    In place of Intel's Open Image Denoise, which Debian's Blender lacks.
    """
    reach, patch = 8, np.full(7, 1 / 7)
    known = albedo.min(-1, keepdims=True) > 0.01  # surfaces that are not black
    light = np.where(known, (picture - emission) / np.maximum(albedo, 0.01), 0)
    scale = np.abs(position - np.median(position, (0, 1))).max() / 20
    features = np.concatenate([normal / 0.3, position / scale, material[..., :1] / 0.5], -1)
    # Variance of a pixel: a quarter of the mean square of the difference to the neighbours, over a small window.
    padded = np.pad(light, [(1, 1), (1, 1), (0, 0)], "edge")
    around = (padded[:-2, 1:-1] + padded[2:, 1:-1] + padded[1:-1, :-2] + padded[1:-1, 2:]) / 4
    variance = blurred(0.8 * (light - around) ** 2, patch) + 1e-6 * light.mean() ** 2
    size = light.shape[:2]
    pad = lambda x: np.pad(x, [(reach, reach), (reach, reach), (0, 0)], "edge")
    light_pad, variance_pad, features_pad = pad(light), pad(variance), pad(features)
    known_pad = pad(known.astype(float))
    total, weights = np.zeros_like(light), np.zeros(size + (1,))
    for dy in range(2 * reach + 1):
        for dx in range(2 * reach + 1):
            at = (slice(dy, dy + size[0]), slice(dx, dx + size[1]))
            other, other_variance = light_pad[at], variance_pad[at]
            square = (light - other) ** 2 - (variance + np.minimum(variance, other_variance))
            square = (square / (0.2 * (variance + other_variance))).mean(-1, keepdims=True)
            distance = np.maximum(blurred(square, patch), 0)
            guide = ((features - features_pad[at]) ** 2).sum(-1, keepdims=True)
            weight = np.exp(-np.maximum(distance, guide)) * known_pad[at]
            total += weight * other
            weights += weight
    return np.where(known, albedo * total / np.maximum(weights, 1e-9) + emission, picture)


# ---- report --------------------------------------------------------------------------------------------------------


def multipath_file(kind):
    return "multipath-" + kind.replace(",", "").replace(" ", "-")


def rows_of(folder, scene, kinds, samples):
    """One row for each picture: dictionaries with series, name, seconds and measures; and the truth."""
    own = os.path.join(folder, scene)
    truth = Truth(own)
    rows, pictures = [], {}

    def add(series, name, picture, filter_kind, seconds):
        pictures[name] = picture
        rows.append({"scene": scene, "series": series, "name": name, **seconds, **truth.measure(picture, filter_kind)})

    for kind in kinds:
        path = os.path.join(own, multipath_file(kind) + ".pfm")
        series = "multipath, gather" if kind.startswith("gather") else "multipath"
        if os.path.exists(path):
            add(series, "multipath, " + kind, inside(read_pfm(path)), "tent", json.load(open(path + ".seconds")))
    for count in samples:
        path = os.path.join(own, "cycles-%d" % count)
        if not os.path.exists(path + ".seconds"):
            continue
        passes = ("", "-albedo", "-normal", "-position", "-material", "-emission")
        layers = [read_pfm(path + name + ".pfm") for name in passes]
        seconds = json.load(open(path + ".seconds"))
        add("Cycles", "Cycles, %d samples" % count, inside(layers[0]), "box", seconds)
        if not os.path.exists(path + "-denoised.npy"):
            np.save(path + "-denoised.npy", denoised(*layers).astype(np.float32))
        smooth = inside(np.load(path + "-denoised.npy").astype(float))
        add("Cycles, denoised", "Cycles, %d samples, denoised" % count, smooth, "box", seconds)
    return rows, pictures, truth


def at_time(rows, series, seconds):
    """Relative MSE of a series after some processor seconds: straight between its points on logarithmic scales, and on to
    three times less or more seconds."""
    own = [row for row in rows if row["series"] == series]
    points = sorted((math.log(row["processor"]), math.log(row["relative MSE"])) for row in own)
    x = math.log(seconds)
    if len(points) < 2 or not points[0][0] - math.log(3) < x < points[-1][0] + math.log(3):
        return math.nan
    k = max(1, min(len(points) - 1, sum(point[0] < x for point in points)))
    (x0, y0), (x1, y1) = points[k - 1], points[k]
    return math.exp(y0 + (y1 - y0) * (x - x0) / (x1 - x0))


def is_known(row):
    """False where the noise of the truths hides the error."""
    return row["standard error"] < 0.3 * row["relative MSE"]


def rounded(ratio):
    return "" if math.isnan(ratio) else "%.1f" % ratio if ratio < 10 else "%.0f" % float("%.2g" % ratio)


def table(rows):
    columns = ("processor", "relative MSE", "standard error", "SSIM", "colour difference")
    lines = ["| scene | picture | seconds | relative MSE | SSIM | colour difference | Cycles / this | denoised / this |"]
    lines.append("|" + " --- |" * 8)
    for row in rows:
        own = [other for other in rows if other["scene"] == row["scene"]]
        ratios = ["", ""]
        if row["series"].startswith("multipath") and is_known(row):
            others = [at_time(own, series, row["processor"]) for series in ("Cycles", "Cycles, denoised")]
            ratios = [rounded(other / row["relative MSE"]) for other in others]
        numbers = "%.1f | %.1e ± %.0e | %.4f | %.2f" % tuple(row[key] for key in columns)
        lines.append("| %s | %s | %s | %s |" % (row["scene"], row["name"], numbers, " | ".join(ratios)))
    return "\n".join(lines) + "\n"


def split_table(splits):
    lines = ["| scene | share of pixels at edges | error at edges | elsewhere | with 256 samples: at edges | elsewhere |"]
    lines.append("| --- | --- | --- | --- | --- | --- |")
    for scene, share, values in splits:
        lines.append("| %s | %.0f %% | %s |" % (scene, 100 * share, " | ".join("%.1e" % value for value in values)))
    return "\n".join(lines) + "\n"


def curves(rows):
    """SVG: for each scene the relative MSE against processor seconds."""
    scenes = list(dict.fromkeys(row["scene"] for row in rows))
    width, height, columns = 250, 210, 3
    first, last = -0.5, 2  # powers of ten
    powers = [math.log10(row["relative MSE"]) for row in rows if is_known(row)]
    low, high = math.floor(min(powers)), math.ceil(max(powers))
    total = (columns * width + 20, (len(scenes) + columns) // columns * height + 10)
    head = '<svg xmlns="http://www.w3.org/2000/svg" width="%d" height="%d" font-family="sans-serif" font-size="11">'
    out = [head % total]
    out.append('<rect width="%d" height="%d" fill="#fff"/>' % total)
    for number, scene in enumerate(scenes):
        left, top = 55 + number % columns * width, 30 + number // columns * height
        across = lambda seconds: left + 180 * (math.log10(seconds) - first) / (last - first)
        down = lambda error: top + 140 * (high - math.log10(error)) / (high - low)
        out.append('<text x="%d" y="%d" text-anchor="middle" font-size="13">%s</text>' % (left + 90, top - 10, scene))
        for power in range(low, high + 1):
            out.append('<path d="M%d %.1fh180" stroke="#ddd"/>' % (left, down(10.0**power)))
            out.append('<text x="%d" y="%.1f" text-anchor="end">1e%d</text>' % (left - 5, down(10.0**power) + 4, power))
        for seconds in (1, 10, 100):
            out.append('<path d="M%.1f %dv140" stroke="#eee"/>' % (across(seconds), top))
            out.append('<text x="%.1f" y="%d" text-anchor="middle">%d s</text>' % (across(seconds), top + 155, seconds))
        for series, colour in COLOURS.items():
            own = [row for row in rows if (row["scene"], row["series"]) == (scene, series)]
            own = [row for row in own if is_known(row) and "256 samples" not in row["name"]]
            own.sort(key=lambda row: row["processor"])
            points = [(across(row["processor"]), down(row["relative MSE"])) for row in own]
            path = "L".join("%.1f %.1f" % point for point in points)
            out.append('<path d="M%s" fill="none" stroke="%s" stroke-width="1.5"/>' % (path, colour))
            out += ['<circle cx="%.1f" cy="%.1f" r="3" fill="%s"/>' % (*p, colour) for p in points]
    left, top = 55 + len(scenes) % columns * width, 40 + len(scenes) // columns * height
    for k, (series, colour) in enumerate(COLOURS.items()):
        out.append('<circle cx="%d" cy="%d" r="3" fill="%s"/>' % (left, top + 20 * k, colour))
        out.append('<text x="%d" y="%d">%s</text>' % (left + 10, top + 20 * k + 4, series))
    caption = '<text x="%d" y="%d">relative MSE against processor seconds</text>'
    out.append(caption % (left - 5, top + 20 * len(COLOURS) + 4))
    return "\n".join(out + ["</svg>"]) + "\n"


def crop(pictures, truth):
    """Part of four pictures of about the same seconds, side by side: multipath, Cycles, the same denoised, the truth.

    It is the part, in the lower half, where the denoised picture of Cycles and that of multipath differ most.
    """
    names = ("multipath, 40,000 patches", "Cycles, 20 samples", "Cycles, 20 samples, denoised")
    shown = [pictures[name] for name in names] + [truth.gathered["tent"]]
    screens = [for_screen(picture, truth.scale) for picture in shown]
    change = blurred(np.abs(screens[0] - screens[2]).mean(-1), np.ones(61))
    rows, columns = change.shape
    change[: rows // 2] = change[-30:] = change[:, :45] = change[:, -45:] = -1
    y, x = np.unravel_index(change.argmax(), change.shape)
    parts = [screen[y - 30 : y + 30, x - 40 : x + 40] for screen in screens]
    return np.concatenate(parts, 1).repeat(2, 0).repeat(2, 1)


def report(folder, scenes, kinds, samples):
    rows, splits, agreement, strips = [], [], [], []
    for scene in scenes:
        own, pictures, truth = rows_of(folder, scene, kinds, samples)
        rows += own
        gathered, cycles = truth.gathered["tent"], sum(truth.halves["tent"]) / 2
        excess = gathered[~truth.edges].mean() / cycles[~truth.edges].mean() - 1
        agreement.append("| %s | %+.3f %% | %.1e |" % (scene, 100 * excess, truth.square_errors(gathered, "tent").mean()))
        names = ("multipath, default", "multipath, default, 256 samples")
        errors = [truth.errors(pictures[name], "tent") for name in names]
        near = truth.edges
        splits.append((scene, near.mean(), [(error * part).mean() for error in errors for part in (near, ~near)]))
        strips.append(crop(pictures, truth))
    with open(os.path.join(folder, "errors.csv"), "w") as file:
        keys = list(rows[0])
        file.write(",".join(keys) + "\n")
        for row in rows:
            values = ('"%s"' % row[key] if isinstance(row[key], str) else "%.6g" % row[key] for key in keys)
            file.write(",".join(values) + "\n")
    with open(os.path.join(folder, "tables.md"), "w") as file:
        file.write(table(rows) + "\n" + split_table(splits) + "\n")
        file.write("| scene | mean of the second truth over that of Cycles | its relative MSE |\n| --- | --- | --- |\n")
        file.write("\n".join(agreement) + "\n")
    write_png(os.path.join(folder, "crops.png"), np.concatenate(strips))
    with open(os.path.join(folder, "errors.svg"), "w") as file:
        file.write(curves(rows))
