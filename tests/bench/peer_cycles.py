"""Builds a scene of peer_formats.write_cycles in Blender's Python module and renders it with Cycles on the processor, with path guiding if it says "guiding".

    VENV/bin/python peer_cycles.py SCENE.json SAMPLES SEED IMAGE.exr THREADS

Prints a line "@@ {...}" with the seconds until the render call; Cycles itself prints how long it has rendered.
"""

import json
import math
import os
import pathlib
import sys
import time

START = time.time()

import bpy
import mathutils
import numpy as np


def read_ply(path):
    """Points and triangles of a file that peer_formats.py wrote."""
    data = path.read_bytes()
    body = data.index(b"end_header\n") + len(b"end_header\n")
    counts = {words[1]: int(words[2]) for words in (line.split() for line in data[:body].decode().splitlines()) if words[0] == "element"}
    points = np.frombuffer(data, "<f4", 3 * counts["vertex"], body)
    faces = np.frombuffer(data, [("count", "u1"), ("corners", "<i4", 3)], counts["face"], body + points.nbytes)
    return points, np.ascontiguousarray(faces["corners"]).ravel()


def material(about):
    made = bpy.data.materials.new("material")
    made.use_nodes = True
    nodes, links = made.node_tree.nodes, made.node_tree.links
    nodes.clear()
    output = nodes.new("ShaderNodeOutputMaterial")
    if about["kind"] == "Diffuse":
        surface = nodes.new("ShaderNodeBsdfDiffuse")
        surface.inputs["Color"].default_value = (*about["reflectance"], 1)
    elif about["kind"] == "Metal":
        surface = nodes.new("ShaderNodeBsdfMetallic")
        surface.distribution, surface.fresnel_type = "GGX", "PHYSICAL_CONDUCTOR"
        surface.inputs["IOR"].default_value = (about["eta"],) * 3
        surface.inputs["Extinction"].default_value = (about["k"],) * 3
        surface.inputs["Roughness"].default_value = math.sqrt(about["alpha"])
    elif about["kind"] == "Glass":
        surface = nodes.new("ShaderNodeBsdfGlass")
        surface.inputs["Roughness"].default_value = 0
        surface.inputs["IOR"].default_value = about["eta"]
    else:
        surface = nodes.new("ShaderNodeEmission")
        surface.inputs["Color"].default_value = (*about["radiance"], 1)
        geometry, front = nodes.new("ShaderNodeNewGeometry"), nodes.new("ShaderNodeMath")
        front.operation, front.inputs[0].default_value = "SUBTRACT", 1
        links.new(geometry.outputs["Backfacing"], front.inputs[1])
        links.new(front.outputs[0], surface.inputs["Strength"])
        made.cycles.emission_sampling = "FRONT"
    links.new(surface.outputs[0], output.inputs["Surface"])
    return made


def add_mesh(scene, folder, about):
    points, corners = read_ply(folder / about["ply"])
    data = bpy.data.meshes.new("mesh")
    data.vertices.add(len(points) // 3)
    data.vertices.foreach_set("co", points)
    data.loops.add(len(corners))
    data.loops.foreach_set("vertex_index", corners)
    data.polygons.add(len(corners) // 3)
    data.polygons.foreach_set("loop_start", np.arange(0, len(corners), 3, dtype=np.int32))
    data.update(calc_edges=True)
    data.shade_flat()
    data.materials.append(material(about))
    scene.collection.objects.link(bpy.data.objects.new("mesh", data))


def add_camera(scene, about):
    camera = bpy.data.cameras.new("camera")
    camera.lens_unit, camera.angle = "FOV", math.radians(about["fov"])
    camera.clip_start, camera.clip_end = 1e-3, 1e5
    seen = bpy.data.objects.new("camera", camera)
    eye = mathutils.Vector(about["eye"])
    back = (eye - mathutils.Vector(about["target"])).normalized()
    right = mathutils.Vector(about["up"]).cross(back).normalized()
    seen.matrix_world = mathutils.Matrix.Translation(eye) @ mathutils.Matrix((right, back.cross(right), back)).transposed().to_4x4()
    scene.collection.objects.link(seen)
    scene.camera = seen


def main():
    file, samples, seed, image, threads = sys.argv[1:]
    folder, about = pathlib.Path(file).resolve().parent, json.loads(pathlib.Path(file).read_text())
    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    render, cycles = scene.render, scene.cycles
    render.engine, cycles.device = "CYCLES", "CPU"
    render.threads_mode, render.threads = "FIXED", int(threads)
    render.resolution_x = render.resolution_y = about["size"]
    render.resolution_percentage = 100
    render.image_settings.file_format, render.image_settings.color_depth, render.image_settings.color_mode = "OPEN_EXR", "32", "RGB"
    render.filepath, render.use_file_extension, render.dither_intensity = os.path.abspath(image), False, 0
    render.use_compositing = render.use_sequencer = False
    cycles.samples, cycles.seed = int(samples), int(seed)
    cycles.use_adaptive_sampling = cycles.use_denoising = cycles.use_fast_gi = False
    cycles.sample_clamp_direct = cycles.sample_clamp_indirect = cycles.light_sampling_threshold = cycles.blur_glossy = 0
    cycles.pixel_filter_type, cycles.filter_width = "BOX", 1
    cycles.use_guiding = about.get("guiding", False)
    for bounces in ("max_bounces", "diffuse_bounces", "glossy_bounces", "transmission_bounces", "min_light_bounces"):
        setattr(cycles, bounces, about["scatters"] - 1)   # the first surface does not count
    world = scene.world = bpy.data.worlds.new("world")
    world.use_nodes = True
    background = world.node_tree.nodes.get("Background") or world.node_tree.nodes.new("ShaderNodeBackground")
    background.inputs["Color"].default_value = (*(about["sky"] or (0, 0, 0)), 1)
    add_camera(scene, about)
    for each in about["meshes"]:
        add_mesh(scene, folder, each)
    load = time.time() - START
    bpy.ops.render.render(write_still=True)
    print("@@ " + json.dumps({"load": load, "spp": int(samples)}), flush=True)
    os._exit(0)   # the module may hang when it ends


main()
