# SPDX-License-Identifier: MIT
"""Holds Ombrage's truth against Blender's Cycles. Run it with Blender's own Python:

    blender -b --factory-startup --addons cycles -P tools/witness/cycles.py -- build/release/bin/ombrage OUTPUT_FOLDER

It writes one scene as an OBJ and an Ombrage scene file, renders it with both programs (shadow under a point and under a
disk light, and ambient occlusion within a radius and without bound), and prints one row of differences for each question."""
import json
import math
import os
import subprocess
import sys

import bpy
from mathutils import Vector

PROGRAM, OUT = sys.argv[sys.argv.index("--") + 1 :][:2]
WIDTH, HEIGHT, RADIUS = 320, 240, 1.0
SAMPLES, SKY_SAMPLES = 256, 1024
EYE, TARGET, FOV_DEG = (3.5, 3.0, 4.5), (0.0, 0.5, 0.0), 40.0
LIGHT, LIGHT_RADIUS = (1.0, 5.0, 0.5), 0.5


def write_scene():
    """A floor, a wall and a sphere, y up, as triangles with one vertex each corner: both programs see the same facets."""
    faces = []
    quad = lambda a, b, c, d: faces.extend([(a, b, c), (a, c, d)])
    quad((-4, 0, 4), (4, 0, 4), (4, 0, -4), (-4, 0, -4))
    quad((-4, 0, -1.5), (4, 0, -1.5), (4, 2, -1.5), (-4, 2, -1.5))
    n, m, r, c = 96, 48, 0.7, (0.0, 1.0, 0.0)
    at = lambda i, j: (
        c[0] + r * math.sin(math.pi * j / m) * math.cos(2 * math.pi * i / n),
        c[1] + r * math.cos(math.pi * j / m),
        c[2] + r * math.sin(math.pi * j / m) * math.sin(2 * math.pi * i / n),
    )
    for i in range(n):
        for j in range(m):
            if j > 0:
                faces.append((at(i, j), at(i + 1, j), at(i, j + 1)))
            if j < m - 1:
                faces.append((at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)))
    with open(os.path.join(OUT, "witness.obj"), "w") as file:
        for face in faces:
            for v in face:
                file.write("v %.9g %.9g %.9g\n" % v)
        for i in range(len(faces)):
            file.write("f %d %d %d\n" % (3 * i + 1, 3 * i + 2, 3 * i + 3))
    light = {"type": "point", "position": LIGHT, "intensity": 40}
    disk = {"type": "spot", "position": LIGHT, "direction": [0, -1, 0], "intensity": 40, "outer_deg": 85, "inner_deg": 80}
    scene = {
        "name": "witness",
        "models": [{"file": "witness.obj"}],
        "lights": [dict(light, name="point"), dict(disk, name="disk", radius_m=LIGHT_RADIUS)],
        "cameras": [{"name": "main", "position": EYE, "target": TARGET, "fov_deg": FOV_DEG}],
        "ao_radius_m": RADIUS,
    }
    with open(os.path.join(OUT, "witness.json"), "w") as file:
        json.dump(scene, file)
    return faces


def load(path):
    """The first plane, rows from the top, numbers as they are."""
    image = bpy.data.images.load(path)
    image.colorspace_settings.name = "Non-Color"
    first = list(image.pixels)[0::4]
    return [value for y in reversed(range(HEIGHT)) for value in first[y * WIDTH : (y + 1) * WIDTH]]


def ombrage(name, *arguments):
    """Visibility in steps of 1/255, which an error below 0.002 does not show in."""
    path = os.path.join(OUT, "ombrage-" + name + ".png")
    scene, size = os.path.join(OUT, "witness.json"), "%dx%d" % (WIDTH, HEIGHT)
    command = [PROGRAM, "reference", scene, "-o", path, "--size", size, "--spp", str(SKY_SAMPLES)]
    subprocess.run(command + list(arguments), check=True)
    return load(path)


def z_up(v):
    return (v[0], -v[2], v[1])


def look(thing, eye, target):
    thing.location = z_up(eye)
    thing.rotation_euler = (Vector(z_up(target)) - Vector(z_up(eye))).to_track_quat("-Z", "Y").to_euler()


class Cycles:
    """The same scene in Blender, direct light only, a box of one pixel as filter."""

    def __init__(self, faces):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        self.scene = bpy.context.scene
        render, cycles = self.scene.render, self.scene.cycles
        render.engine = "CYCLES"
        cycles.device, cycles.seed = "CPU", 1
        cycles.use_adaptive_sampling = cycles.use_denoising = False
        cycles.max_bounces = cycles.diffuse_bounces = 0
        cycles.pixel_filter_type, cycles.filter_width = "BOX", 1.0
        render.resolution_x, render.resolution_y, render.resolution_percentage = WIDTH, HEIGHT, 100
        render.image_settings.file_format, render.image_settings.color_depth = "OPEN_EXR", "32"
        self.scene.view_settings.view_transform = "Raw"
        self.scene.world = bpy.data.worlds.new("world")
        self.scene.world.use_nodes = True
        self.sky(0)
        mesh = bpy.data.meshes.new("mesh")
        corners = [z_up(v) for face in faces for v in face]
        mesh.from_pydata(corners, [], [(3 * i, 3 * i + 1, 3 * i + 2) for i in range(len(faces))])
        self.model = bpy.data.objects.new("model", mesh)
        self.scene.collection.objects.link(self.model)
        camera = bpy.data.cameras.new("camera")
        camera.sensor_fit, camera.angle = "VERTICAL", math.radians(FOV_DEG)
        eye = bpy.data.objects.new("camera", camera)
        self.scene.collection.objects.link(eye)
        self.scene.camera = eye
        look(eye, EYE, TARGET)

    def sky(self, strength):
        background = self.scene.world.node_tree.nodes["Background"]
        background.inputs[0].default_value, background.inputs[1].default_value = (1, 1, 1, 1), strength

    def material(self, kind):
        """A white diffuse surface, or one that shows its ambient occlusion within RADIUS."""
        material = bpy.data.materials.new(kind)
        material.use_nodes = True
        nodes, links = material.node_tree.nodes, material.node_tree.links
        nodes.clear()
        output = nodes.new("ShaderNodeOutputMaterial")
        if kind == "diffuse":
            surface = nodes.new("ShaderNodeBsdfDiffuse")
            surface.inputs[0].default_value = (1, 1, 1, 1)
        else:
            surface, occlusion = nodes.new("ShaderNodeEmission"), nodes.new("ShaderNodeAmbientOcclusion")
            occlusion.samples, occlusion.inputs["Distance"].default_value = 4, RADIUS
            links.new(occlusion.outputs["AO"], surface.inputs[0])
        links.new(surface.outputs[0], output.inputs[0])
        self.model.data.materials.clear()
        self.model.data.materials.append(material)

    def light(self, kind):
        light = bpy.data.lights.new(kind, kind)
        light.energy = 1000
        if kind == "POINT":
            light.shadow_soft_size = 0
        else:
            light.shape, light.size = "DISK", 2 * LIGHT_RADIUS
        self.lamp = bpy.data.objects.new(kind, light)
        self.scene.collection.objects.link(self.lamp)
        look(self.lamp, LIGHT, (LIGHT[0], 0, LIGHT[2]))

    def render(self, name, samples=SAMPLES):
        self.scene.cycles.samples = samples
        path = os.path.join(OUT, "cycles-" + name + ".exr")
        self.scene.render.filepath = path
        bpy.ops.render.render(write_still=True)
        return load(path)

    def shadow(self, kind, name):
        """With shadow over without: dark where no light comes either way."""
        self.material("diffuse")
        self.light(kind)
        lit = self.render(name)
        self.model.visible_shadow = False
        open_ = self.render(name + "-open")
        self.model.visible_shadow = True
        bpy.data.objects.remove(self.lamp)
        # Below 2 % of the brightest the quotient of two noisy numbers says little.
        least = 0.02 * max(open_)
        return [a / b if b > least else 0 for a, b in zip(lit, open_)], [b > least for b in open_]


def near_edge(picture, i):
    """The 3x3 neighbourhood spans more than 0.2."""
    x, y = i % WIDTH, i // WIDTH
    rows = range(max(y - 1, 0), min(y + 2, HEIGHT))
    values = [picture[r * WIDTH + c] for r in rows for c in range(max(x - 1, 0), min(x + 2, WIDTH))]
    return max(values) - min(values) > 0.2


def compare(name, theirs, ours, valid):
    pixels = [i for i in range(WIDTH * HEIGHT) if valid[i]]
    difference = {i: abs(theirs[i] - ours[i]) for i in pixels}
    worst = max(pixels, key=difference.get)
    smooth = [i for i in pixels if not near_edge(ours, i)]
    mean = lambda some: sum(difference[i] for i in some) / len(some)
    within = sum(difference[i] <= 0.02 for i in smooth) / len(smooth)
    row = (name, mean(pixels), difference[worst], worst % WIDTH, worst // WIDTH)
    row += (mean(smooth), max(difference[i] for i in smooth), 100 * within)
    print("%-21s mean %.5f max %.4f at (%d,%d); off edges: mean %.5f max %.4f, %.2f %% within 0.02" % row, flush=True)


os.makedirs(OUT, exist_ok=True)
cycles = Cycles(write_scene())
point, valid = cycles.shadow("POINT", "point")
compare("point light", point, ombrage("point", "--quantity", "shadow", "--light", "point", "--truth", "area"), valid)
disk, valid = cycles.shadow("AREA", "disk")
compare("disk light", disk, ombrage("disk", "--quantity", "shadow", "--light", "disk", "--truth", "area"), valid)
cycles.material("occlusion")
occlusion = cycles.render("occlusion", SAMPLES // 4)
surface = [value > 0 for value in occlusion]
compare("occlusion within 1 m", occlusion, ombrage("occlusion", "--quantity", "ao", "--truth", "area"), surface)
cycles.material("diffuse")
cycles.sky(1)
sky = cycles.render("sky", SKY_SAMPLES)
compare("occlusion, unbounded", sky, ombrage("sky", "--quantity", "ao", "--truth", "T4"), surface)
