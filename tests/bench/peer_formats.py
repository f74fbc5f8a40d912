"""One scene (peer_scenes.py) as each renderer reads it: the same surfaces, lights, depth and filter; no clamping, no denoising, and no Russian roulette where it can be turned off."""

import json

import numpy as np

from peer_scenes import Diffuse, Glass, Lamp, Metal

ROULETTE_NEVER = 1000


def numbers(values, separator=" "):
    return separator.join(f"{float(v):.9g}" for v in values)


def write_ply(path, mesh):
    faces = np.empty(len(mesh.triangles), [("count", "u1"), ("corners", "<i4", 3)])
    faces["count"], faces["corners"] = 3, mesh.triangles
    header = ["ply", "format binary_little_endian 1.0", f"element vertex {len(mesh.points)}", *(f"property float {axis}" for axis in "xyz"),
              f"element face {len(faces)}", "property list uchar int vertex_indices", "end_header", ""]
    path.write_bytes("\n".join(header).encode() + mesh.points.astype("<f4").tobytes() + faces.tobytes())


def pbrt_material(material):
    match material:
        case Diffuse(reflectance):
            return f'"diffuse" "rgb reflectance" [ {numbers(reflectance)} ]'
        case Metal(eta, k, alpha):
            return f'"conductor" "spectrum eta" [ 300 {eta} 900 {eta} ] "spectrum k" [ 300 {k} 900 {k} ] "float roughness" {alpha} "bool remaproughness" false'
        case Glass(eta):
            return f'"dielectric" "float eta" {eta}'
        case Lamp():
            return '"diffuse" "rgb reflectance" [ 0 0 0 ]'


def write_pbrt(scene, folder, size):
    """For pbrt-v4 and Eikonal. Its cameras mirror, which the first Scale undoes."""
    text = f"""Integrator "path" "integer maxdepth" {scene.scatters}
Sampler "zsobol" "integer pixelsamples" 64
PixelFilter "box" "float xradius" 0.5 "float yradius" 0.5
Film "rgb" "string filename" "out.exr" "integer xresolution" {size} "integer yresolution" {size} "bool savefp16" false
Scale -1 1 1
LookAt {numbers(scene.eye)}  {numbers(scene.target)}  {numbers(scene.up)}
Camera "perspective" "float fov" {scene.fov:.9g}
WorldBegin
"""
    if scene.sky:
        text += f'LightSource "infinite" "rgb L" [ {numbers(scene.sky)} ]\n'
    for m in scene.meshes:
        light = f'AreaLightSource "diffuse" "rgb L" [ {numbers(m.material.radiance)} ]\n' if isinstance(m.material, Lamp) else ""
        text += f'AttributeBegin\n{light}Material {pbrt_material(m.material)}\nShape "plymesh" "string filename" "{m.name}.ply"\nAttributeEnd\n'
    (folder / "scene.pbrt").write_text(text)


def mitsuba_bsdf(material):
    match material:
        case Diffuse(reflectance):
            return f'<bsdf type="twosided"><bsdf type="diffuse"><rgb name="reflectance" value="{numbers(reflectance, ", ")}"/></bsdf></bsdf>'
        case Metal(eta, k, alpha):
            return ('<bsdf type="twosided"><bsdf type="roughconductor"><string name="distribution" value="ggx"/>'
                    f'<float name="alpha" value="{alpha}"/><spectrum name="eta" value="{eta}"/><spectrum name="k" value="{k}"/></bsdf></bsdf>')
        case Glass(eta):
            return f'<bsdf type="dielectric"><float name="int_ior" value="{eta}"/><float name="ext_ior" value="1"/></bsdf>'
        case Lamp(radiance):
            return f'<bsdf type="diffuse"><rgb name="reflectance" value="0"/></bsdf><emitter type="area"><rgb name="radiance" value="{numbers(radiance, ", ")}"/></emitter>'


def write_mitsuba(scene, folder, size):
    """Its depth counts edges of a path, not surfaces."""
    vector = lambda v: numbers(v, ", ")
    text = f"""<scene version="3.0.0">
<integrator type="path"><integer name="max_depth" value="{scene.scatters + 1}"/><integer name="rr_depth" value="{ROULETTE_NEVER}"/></integrator>
<sensor type="perspective"><string name="fov_axis" value="smaller"/><float name="fov" value="{scene.fov:.9g}"/><float name="near_clip" value="0.001"/><float name="far_clip" value="100000"/>
<transform name="to_world"><lookat origin="{vector(scene.eye)}" target="{vector(scene.target)}" up="{vector(scene.up)}"/></transform>
<sampler type="independent"/>
<film type="hdrfilm"><integer name="width" value="{size}"/><integer name="height" value="{size}"/><string name="pixel_format" value="rgb"/>
<string name="component_format" value="float32"/><rfilter type="box"/></film></sensor>
"""
    if scene.sky:
        text += f'<emitter type="constant"><rgb name="radiance" value="{vector(scene.sky)}"/></emitter>\n'
    for m in scene.meshes:
        text += f'<shape type="ply"><string name="filename" value="{m.name}.ply"/><boolean name="face_normals" value="true"/>{mitsuba_bsdf(m.material)}</shape>\n'
    (folder / "scene.xml").write_text(text + "</scene>\n")


def luxcore_material(material):
    match material:
        case Diffuse(reflectance):
            return {"type": "matte", "kd": numbers(reflectance)}
        case Metal(alpha=alpha):
            return {"type": "metal2", "fresnel": "conductor", "uroughness": alpha, "vroughness": alpha}
        case Glass(eta):
            return {"type": "glass", "kr": "1 1 1", "kt": "1 1 1", "interiorior": eta, "exteriorior": 1}
        case Lamp(radiance):
            return {"type": "matte", "kd": "0 0 0", "emission": numbers(radiance), "emission.gain": "1 1 1"}


def write_luxcore(scene, folder, size):
    """Its last vertex neither scatters nor is lit. Its images lie a row too low, which the screen window undoes. Its microfacets are Schlick's, not GGX."""
    depth = scene.scatters + 1
    config = {"scene.file": "scene.scn", "renderengine.type": "PATHCPU", "film.width": size, "film.height": size, "film.filter.type": "BOX", "film.filter.width": 0.5,
              "sampler.type": "SOBOL", "sampler.sobol.adaptive.strength": 0, "path.russianroulette.depth": ROULETTE_NEVER, "path.clamping.variance.maxvalue": 0,
              "path.hybridbackforward.enable": 0, "path.photongi.indirect.enabled": 0, "path.photongi.caustic.enabled": 0,
              **{f"path.pathdepth.{kind}": depth for kind in ("total", "diffuse", "glossy", "specular")}}
    row = 2 / size
    camera = {"type": "perspective", "lookat.orig": numbers(scene.eye), "lookat.target": numbers(scene.target), "up": numbers(scene.up), "fieldofview": scene.fov,
              "lensradius": 0, "autofocus.enable": 0, "screenwindow": numbers((-1, 1, -1 - row, 1 - row))}
    lines = [f"scene.camera.{k} = {v}" for k, v in camera.items()]
    if scene.sky:
        lines += ["scene.lights.sky.type = constantinfinite", f"scene.lights.sky.color = {numbers(scene.sky)}", "scene.lights.sky.gain = 1 1 1"]
    metal = next((m.material for m in scene.meshes if isinstance(m.material, Metal)), None)
    if metal:
        lines += ["scene.textures.conductor.type = fresnelconst", f"scene.textures.conductor.n = {numbers((metal.eta,) * 3)}", f"scene.textures.conductor.k = {numbers((metal.k,) * 3)}"]
    for m in scene.meshes:
        lines += [f"scene.materials.{m.name}.{k} = {v}" for k, v in luxcore_material(m.material).items()]
        lines += [f"scene.objects.{m.name}.material = {m.name}", f"scene.objects.{m.name}.ply = {m.name}.ply"]
    (folder / "scene.cfg").write_text("".join(f"{k} = {v}\n" for k, v in config.items()))
    (folder / "scene.scn").write_text("\n".join(lines) + "\n")


def write_cycles(scene, folder, size):
    """Blender has no file format for text: peer_cycles.py builds the scene from this."""
    meshes = [{"ply": f"{m.name}.ply", "kind": type(m.material).__name__, **vars(m.material)} for m in scene.meshes]
    description = {key: [float(v) for v in getattr(scene, key)] for key in ("eye", "target", "up")}
    description |= {"fov": scene.fov, "size": size, "scatters": scene.scatters, "sky": scene.sky, "meshes": meshes}
    (folder / "scene.json").write_text(json.dumps(description))


def write(scene, folder, size):
    """All of them, for images of size x size pixels."""
    folder.mkdir(parents=True, exist_ok=True)
    for m in scene.meshes:
        write_ply(folder / f"{m.name}.ply", m)
    for writer in (write_pbrt, write_mitsuba, write_luxcore, write_cycles):
        writer(scene, folder, size)
