"""Renders a scene of multipath with Cycles, as exactly the same problem. Run by renderers.py inside Blender:

    blender -b --factory-startup -P cycles.py -- JOBS.json

JOBS.json has the OBJ file, what lights it, the camera and the pictures wanted. Each picture is written as PFM in W/m^2,
and its processor and wall seconds as JSON. The seconds are those of the rendering, without Blender's start and the
reading of the file.
"""

import json
import math
import os
import sys
import time

import bpy
import numpy
from mathutils import Matrix, Vector

LAMP_CUTS = 10  # parts along each edge of a face that emits,
MOST_CUT = 16  # in scenes with no more of these faces
PASSES = ["picture", "albedo", "normal", "position", "material", "emission"]


def read_materials(path):
    materials = {}
    for line in open(path):
        words = line.split()
        if words[:1] == ["newmtl"]:
            material = materials[words[1]] = {"Kd": [0.5] * 3, "Ke": [0.0] * 3, "map": None}
        elif words[:1] in (["Kd"], ["Ke"]):
            material[words[0]] = [float(word) for word in (words[1:4] if len(words) > 2 else words[1:2] * 3)]
        elif words[:1] in (["map_d"], ["map_Ke"]):
            raise ValueError(path + ": " + words[0] + " is not known here")
        elif words[:1] == ["map_Kd"]:
            material["map"] = os.path.join(os.path.dirname(path), words[-1])
    return materials


def read_obj(path):
    """Returns materials by name, and the faces as (material, points, texture coordinates or None)."""
    materials, faces, points, textures, name = {}, [], [], [], "default"
    for line in open(path):
        words = line.split("#")[0].split()
        if not words:
            continue
        if words[0] == "mtllib":
            materials.update(read_materials(os.path.join(os.path.dirname(path), words[1])))
        elif words[0] == "v":
            points.append(Vector([float(word) for word in words[1:4]]))
        elif words[0] == "vt":
            textures.append(Vector([float(word) for word in words[1:3]]))
        elif words[0] == "usemtl":
            name = words[1]
        elif words[0] == "f":
            corners = [[int(index) if index else 0 for index in word.split("/")] for word in words[1:]]
            at = lambda values, index: values[index - 1 if index > 0 else index]
            mapped = all(len(corner) > 1 and corner[1] for corner in corners)
            texture = [at(textures, c[1]) for c in corners] if mapped else None
            faces.append((name, [at(points, c[0]) for c in corners], texture))
    return materials, faces


def cut(points):
    """Cuts a lamp into small parts: Cycles 3.4 samples a large near quad too low (up to 17 % on the walls of 4CHAIRS).

    Only triangles and quads are cut.
    """
    n = LAMP_CUTS
    if len(points) == 4:
        a, b, c, d = points
        at = lambda s, t: (1 - s) * (1 - t) * a + s * (1 - t) * b + s * t * c + (1 - s) * t * d
        grid = [[at(i / n, j / n) for j in range(n + 1)] for i in range(n + 1)]
        return [[grid[i][j], grid[i + 1][j], grid[i + 1][j + 1], grid[i][j + 1]] for i in range(n) for j in range(n)]
    if len(points) == 3:
        a, b, c = points
        at = lambda i, j: a + (i / n) * (b - a) + (j / n) * (c - a)
        lower = [[at(i, j), at(i + 1, j), at(i, j + 1)] for i in range(n) for j in range(n - i)]
        upper = [[at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)] for i in range(n) for j in range(n - i - 1)]
        return lower + upper
    return [points]


def without_backs(faces):
    """Each face once, with whether it is a sheet of two faces back to back, of which Cycles would meet either."""
    sheets = {}
    for face in faces:
        sheets.setdefault((face[0], frozenset(tuple(point) for point in face[1])), []).append(face)
    return [(*same[0], len(same) > 1) for same in sheets.values()]


def make_material(name, values, index, is_sheet):
    """Diffuse in front, which also emits; the back is black, and invisible for the camera, as in multipath. A sheet is
    alike on both sides."""
    material = bpy.data.materials.new(name)
    material.pass_index = index
    material.use_nodes = True
    material.cycles.use_transparent_shadow = False
    nodes, links = material.node_tree.nodes, material.node_tree.links
    nodes.clear()
    front = nodes.new("ShaderNodeBsdfDiffuse")
    front.inputs["Color"].default_value = (*values["Kd"], 1)
    if values["map"]:
        image = nodes.new("ShaderNodeTexImage")
        image.image = bpy.data.images.load(values["map"])  # sRGB
        image.interpolation = "Closest"
        product = nodes.new("ShaderNodeVectorMath")
        product.operation = "MULTIPLY"
        product.inputs[1].default_value = values["Kd"]
        links.new(image.outputs["Color"], product.inputs[0])
        links.new(product.outputs[0], front.inputs["Color"])
    shader = front.outputs[0]
    if any(values["Ke"]):
        emission = nodes.new("ShaderNodeEmission")
        emission.inputs["Color"].default_value = (*[e / math.pi for e in values["Ke"]], 1)  # radiance
        both = nodes.new("ShaderNodeAddShader")
        links.new(shader, both.inputs[0])
        links.new(emission.outputs[0], both.inputs[1])
        shader = both.outputs[0]
    black, clear = nodes.new("ShaderNodeBsdfDiffuse"), nodes.new("ShaderNodeBsdfTransparent")
    black.inputs["Color"].default_value = (0, 0, 0, 1)
    path, geometry = nodes.new("ShaderNodeLightPath"), nodes.new("ShaderNodeNewGeometry")
    back, side, output = (nodes.new(kind) for kind in ("ShaderNodeMixShader",) * 2 + ("ShaderNodeOutputMaterial",))
    links.new(path.outputs["Is Camera Ray"], back.inputs[0])
    links.new(black.outputs[0], back.inputs[1])
    links.new(clear.outputs[0], back.inputs[2])
    links.new(geometry.outputs["Backfacing"], side.inputs[0])
    links.new(shader, side.inputs[1])
    links.new(back.outputs[0], side.inputs[2])
    links.new(shader if is_sheet else side.outputs[0], output.inputs["Surface"])
    return material


def build_scene(job):
    materials, faces = read_obj(job["obj"])
    grey = {"Kd": [0.5] * 3, "Ke": [0.0] * 3, "map": None}
    faces = without_backs(faces)
    names = list(dict.fromkeys(face[0] for face in faces))
    materials = {name: materials.get(name, dict(grey)) for name in names}
    for name, emittance in job["lamps"].items():
        materials[name]["Ke"] = emittance
    lamps = [face[0] for face in faces if any(materials[face[0]]["Ke"])]
    points, polygons, uvs, slots = [], [], [], []
    for name, corners, texture, is_sheet in faces:
        cuts = name in lamps and len(lamps) <= MOST_CUT and not texture
        for part in cut(corners) if cuts else [corners]:
            polygons.append(list(range(len(points), len(points) + len(part))))
            points += part
            uvs += [xy for point in texture or [(0, 0)] * len(part) for xy in point]
            slots.append(2 * names.index(name) + is_sheet)
    mesh = bpy.data.meshes.new("scene")
    mesh.from_pydata(points, [], polygons)
    mesh.uv_layers.new().data.foreach_set("uv", uvs)
    for k, name in enumerate(names):
        for is_sheet in (False, True):
            mesh.materials.append(make_material(name, materials[name], k + 1, is_sheet))
    mesh.polygons.foreach_set("material_index", slots)
    scene = bpy.data.scenes.new("scene")
    scene.collection.objects.link(bpy.data.objects.new("scene", mesh))
    scene.world = bpy.data.worlds.new("sky")
    scene.world.use_nodes = True
    sky = scene.world.node_tree.nodes["Background"].inputs
    sky["Color"].default_value = (*[e / math.pi for e in job["sky"]], 1)
    sky["Strength"].default_value = 1
    if job["sun"]:
        azimuth, elevation = (math.radians(angle) for angle in job["sun"][:2])
        sun = bpy.data.lights.new("sun", "SUN")
        sun.angle, sun.energy = 0, max(job["sun"][2:])  # W/m^2
        sun.color = [e / sun.energy for e in job["sun"][2:]]
        sun.cycles.max_bounces = 1024
        level = math.cos(elevation)  # length of the direction's horizontal part; north is -z
        towards = Vector((math.sin(azimuth) * level, math.sin(elevation), -math.cos(azimuth) * level))
        lamp = bpy.data.objects.new("sun", sun)
        lamp.rotation_euler = towards.to_track_quat("Z", "Y").to_euler()  # it shines along its -z
        scene.collection.objects.link(lamp)
    return scene


def place_camera(scene, view, width, height):
    camera = bpy.data.cameras.new("camera")
    camera.sensor_fit, camera.angle = "VERTICAL", math.radians(view["field_of_view"])
    camera.clip_start, camera.clip_end = 1e-4, 1e5
    eye = Vector(view["eye"])
    back = (eye - Vector(view["target"])).normalized()
    right = Vector(view["up"]).cross(back).normalized()
    scene.camera = bpy.data.objects.new("camera", camera)
    scene.camera.matrix_world = Matrix.Translation(eye) @ Matrix((right, back.cross(right), back)).transposed().to_4x4()
    scene.collection.objects.link(scene.camera)
    scene.render.resolution_x, scene.render.resolution_y = width, height


def set_up_cycles(scene, threads):
    scene.render.engine = "CYCLES"
    scene.render.threads_mode, scene.render.threads = "FIXED", threads
    cycles = scene.cycles
    cycles.device = "CPU"
    cycles.use_adaptive_sampling = cycles.use_denoising = False
    cycles.max_bounces = cycles.diffuse_bounces = cycles.transparent_max_bounces = 1024
    cycles.min_light_bounces = 0
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = 0
    cycles.blur_glossy = 0
    cycles.light_sampling_threshold = 0
    cycles.pixel_filter_type = "BOX"  # of one pixel
    cycles.use_auto_tile = False


def keep_passes(scene, folder):
    """Every pass as an EXR file of 32-bit floats in the folder; nothing else can be read from a render without window."""
    layer = scene.view_layers[0]
    layer.use_pass_normal = layer.use_pass_position = layer.use_pass_material_index = True
    layer.use_pass_diffuse_color = layer.use_pass_emit = layer.use_pass_environment = True
    scene.use_nodes = True
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    nodes.clear()
    layers = nodes.new("CompositorNodeRLayers")
    layers.scene = scene
    output = nodes.new("CompositorNodeOutputFile")
    output.base_path = folder
    output.format.file_format, output.format.color_depth, output.format.color_mode = "OPEN_EXR", "32", "RGB"
    output.file_slots.clear()
    emission = nodes.new("CompositorNodeMixRGB")  # what is seen directly: lamps and sky
    emission.blend_type = "ADD"
    links.new(layers.outputs["Emit"], emission.inputs[1])
    links.new(layers.outputs["Env"], emission.inputs[2])
    sources = [layers.outputs[name] for name in ("Image", "DiffCol", "Normal", "Position", "IndexMA")]
    sources.append(emission.outputs[0])
    for name, source in zip(PASSES, sources):
        output.file_slots.new(name)
        links.new(source, output.inputs[name])


def write_pfm(path, exr, factor):
    image = bpy.data.images.load(exr)
    image.colorspace_settings.name = "Non-Color"
    values = numpy.empty(len(image.pixels), numpy.float32)
    image.pixels.foreach_get(values)
    width, height = image.size
    with open(path, "wb") as file:
        file.write(b"PF\n%d %d\n-1.0\n" % (width, height))
        file.write((factor * values.reshape(height, width, 4)[:, :, :3]).astype("<f4").tobytes())
    bpy.data.images.remove(image)


def main():
    job = json.load(open(sys.argv[sys.argv.index("--") + 1]))
    scene = build_scene(job)
    bpy.context.window.scene = scene
    set_up_cycles(scene, job["threads"])
    for picture in job["pictures"]:
        place_camera(scene, job["camera"], picture["width"], picture["height"])
        scene.cycles.samples, scene.cycles.seed = picture["samples"], picture["seed"]
        folder = picture["name"] + ".passes"
        keep_passes(scene, folder)
        processor, wall = time.process_time(), time.time()
        bpy.ops.render.render(scene=scene.name)
        seconds = {"processor": time.process_time() - processor, "wall": time.time() - wall}
        for name in PASSES:
            exr = os.path.join(folder, "%s%04d.exr" % (name, scene.frame_current))
            factor = math.pi if name in ("picture", "emission") else 1  # W/m^2 from radiance
            write_pfm(picture["name"] + ("" if name == "picture" else "-" + name) + ".pfm", exr, factor)
        json.dump(seconds, open(picture["name"] + ".seconds", "w"))


main()
