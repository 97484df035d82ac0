#!/usr/bin/env python3
"""Equal time: pictures of multipath and of Cycles (Blender) of the same scenes, with errors against a common truth.

usage: renderers.py FOLDER [SCENE.obj [OPTIONS OF MULTIPATH]]

Renders the scenes of the table below, or the given one, into FOLDER, and writes errors.csv, tables.md, the curves
errors.svg and the details crops.png there. A picture that is already in FOLDER is not made again, so the script can be
stopped and run once more. Run it from the folder of the sources. It needs Blender ('apt-get install
blender', 3.4 or newer, with its NumPy) and takes five to ten minutes of one processor for each scene; all pictures are
made with one thread. What is measured, and how, is told in docs/comparison.md.
"""

import json
import os
import re
import resource
import subprocess
import sys
import time

sys.dont_write_bytecode = True
import analysis
from analysis import FINE, multipath_file

HERE = os.path.dirname(os.path.abspath(__file__))
MULTIPATH = os.environ.get("MULTIPATH", "./multipath")
WIDTH, HEIGHT = 400, 300

DAY = "--sky 60,75,95 --sun 83,46,130,114,92 --eye 1.6,1.45,5 --target 2.25,1.05,0.6 --fov 58".split()
SCENES = {
    "5cubes": ("scenes/5cubes.obj", []),
    "4chairs": ("scenes/4chairs.obj", []),
    "4chairs-up": ("scenes/4chairs-up.obj", []),
    "cornell": ("scenes/cornell.obj", []),
    "studio": ("scenes/studio.obj", []),
    "studio-day": ("scenes/studio.obj", DAY),
    "courtyard": ("courtyard.obj", "--sky 30,38,48 --sun 150,40,130,114,92".split()),
}
COURTYARD = "-v family=courtyard -v size=12 -v out=courtyard.obj -f".split()

RUNS = {  # of multipath
    "default": "",
    "default, 256 samples": "--samples 256",  # not for comparison at equal time
    "gather": "--shading gather",
    "40,000 patches": "--adaptive 40000 --lines 2^24 --samples 16",
    "gather, 256 rays": "--shading gather --adaptive 20000 --lines 2^22 --gather-rays 256 --samples 16",
    "160,000 patches": "--adaptive 160000 --lines 2^26 --samples 25",
    "gather, 1,024 rays": "--shading gather --adaptive 40000 --lines 2^24 --gather-rays 1024 --samples 25",
}
TRUTH = "--shading gather --adaptive 40000 --lines 2^24 --samples 1"  # one sample at the middle of every fine pixel
CYCLES = [4, 20, 120]  # samples per pixel
TRUTH_SAMPLES = 128  # of each of two pictures, for every pixel of WIDTH x HEIGHT


def run(command, seconds):
    """Runs a command and writes its processor and wall seconds as JSON, unless that file is there."""
    if os.path.exists(seconds):
        return
    before, start = resource.getrusage(resource.RUSAGE_CHILDREN), time.time()
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    processor = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    json.dump({"processor": processor, "wall": time.time() - start}, open(seconds, "w"))


def multipath(scene, options, output, scale=1):
    size = ["--size", "%dx%d" % (scale * WIDTH, scale * HEIGHT)]
    run([MULTIPATH, "solve", scene, "-q", "--threads", "1"] + size + options + ["-o", output], output + ".seconds")


def camera(folder, scene, options):
    """The camera that multipath chooses, or that the options set."""
    page = os.path.join(folder, "camera.html")
    multipath(scene, options, page)
    return json.loads(re.search(r'"camera": ({[^}]*})', open(page).read()).group(1))


def camera_options(view):
    point = lambda name: ",".join(map(repr, view[name]))
    return ["--eye", point("eye"), "--target", point("target"), "--up", point("up"), "--fov", repr(view["field_of_view"])]


def cycles(folder, scene, options):
    numbers = lambda text: [float(number) for number in text.split(",")]
    colour = lambda text: (numbers(text) * 3)[:3]
    value = dict(zip(options[::2], options[1::2]))
    unknown = set(value) - set("--lamp --sky --sun --eye --target --up --fov".split())
    if unknown:
        sys.exit("renderers.py: Cycles gets no other scene by %s" % ", ".join(unknown))
    job = {"obj": scene, "threads": 1, "camera": camera(folder, scene, options), "lamps": {}, "pictures": []}
    for option, text in zip(options[::2], options[1::2]):
        if option == "--lamp":
            name, emittance = text.rsplit("=", 1)
            job["lamps"][name] = colour(emittance)
    job["sky"] = colour(value.get("--sky", "0"))
    sun = numbers(value["--sun"]) if "--sun" in value else None
    job["sun"] = sun and sun[:2] + (sun[2:] * 3)[:3]

    def picture(name, scale, samples, seed):
        name = os.path.join(folder, name)
        if not os.path.exists(name + ".seconds"):
            size = {"width": scale * WIDTH, "height": scale * HEIGHT}
            job["pictures"].append({"name": name, "samples": samples, "seed": seed, **size})

    for samples in CYCLES:
        picture("cycles-%d" % samples, 1, samples, 1)
    for half in (1, 2):
        picture("cycles-truth-%d" % half, FINE, TRUTH_SAMPLES // FINE**2, 10 + half)
    if job["pictures"]:
        path = os.path.join(folder, "cycles.jobs")
        json.dump(job, open(path, "w"))
        log = open(os.path.join(folder, "cycles.log"), "w")
        command = ["blender", "-b", "--factory-startup", "--python-exit-code", "1"]
        subprocess.run(command + ["-P", os.path.join(HERE, "cycles.py"), "--", path], check=True, stdout=log)


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    folder = sys.argv[1]
    scenes = SCENES
    if len(sys.argv) > 2:
        scenes = {os.path.splitext(os.path.basename(sys.argv[2]))[0]: (sys.argv[2], sys.argv[3:])}
    for name, (scene, options) in scenes.items():
        own = os.path.join(folder, name)
        os.makedirs(own, exist_ok=True)
        if scene == "courtyard.obj":
            scene = os.path.join(own, scene)
            rule = [word.replace("out=", "out=" + own + "/") for word in COURTYARD]
            subprocess.run(["awk"] + rule + ["tests/families/room.awk"], check=True)
        for kind, more in RUNS.items():
            multipath(scene, options + more.split(), os.path.join(own, multipath_file(kind) + ".pfm"))
        view = camera_options(camera(own, scene, options))
        lit = [word for pair in zip(options[::2], options[1::2]) if pair[0] not in view for word in pair]
        multipath(scene, lit + view + TRUTH.split(), os.path.join(own, "multipath-truth.pfm"), FINE)
        cycles(own, scene, options)
    analysis.report(folder, list(scenes), list(RUNS), CYCLES)


if __name__ == "__main__":
    main()
