"""Work with exported paints in Blender, without a window.

    tools/blender.py render MODEL LIGHT.exr OUTPUT.exr [--size 128]
    tools/blender.py library OUTPUT.blend MODEL.gltf...

``render`` renders a glTF, USD or ``.blend`` file in Cycles. The light is a latitude-longitude map, laid out as the
suite's; the camera looks along -z (y up) at the origin, from ``--distance`` metres, and sees ``--width`` metres there.
A ``.blend`` file is a library: ``--material`` names the one that a sphere is rendered in. The picture is linear Rec.
709 with alpha.

``library`` writes the materials of glTF files as assets, for Blender's Asset Browser.

Blender is the package ``bpy`` (374 MB), installed by uv into an environment that is deleted afterwards; ``--environment
FOLDER`` uses, or makes and keeps, one there. It needs the Python version that the package is built for, 3.11 for
Blender 5.0.
"""

from __future__ import annotations

import argparse
import math
import subprocess
import sys
import tempfile
from pathlib import Path
from typing import Any

PACKAGE = "bpy==5.0.*"
RADIUS_M = 0.1
DISTANCE_M, WIDTH_M = 2.0, 0.22
PREVIEW_SIZE, PREVIEW_SAMPLES = 128, 64


def main() -> int:
    """Run here where this is Blender's Python, else in an environment that has it."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--environment", type=Path, default=None, metavar="FOLDER")
    commands = parser.add_subparsers(dest="command", required=True)
    one = commands.add_parser("render")
    one.add_argument("model", type=Path)
    one.add_argument("light", type=Path)
    one.add_argument("output", type=Path)
    one.add_argument("--size", type=int, default=128)
    one.add_argument("--samples", type=int, default=512)
    one.add_argument("--distance", type=float, default=DISTANCE_M)
    one.add_argument("--width", type=float, default=WIDTH_M)
    one.add_argument("--material", default=None, metavar="NAME")
    many = commands.add_parser("library")
    many.add_argument("output", type=Path)
    many.add_argument("models", type=Path, nargs="+", metavar="MODEL")
    options = parser.parse_args()
    try:
        import bpy  # noqa: F401  # only to know where this runs
    except ImportError:
        if options.environment is not None:
            return elsewhere(options.environment)
        with tempfile.TemporaryDirectory(prefix="blender-") as folder:
            return elsewhere(Path(folder) / "environment")
    if options.command == "render":
        render(options)
    else:
        library(options.output, options.models)
    return 0


def elsewhere(folder: Path) -> int:
    """Run this script in an environment with Blender, made where it is missing; return its exit status."""
    python = folder / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python")
    if not python.is_file():
        uv = [sys.executable, "-m", "uv"]
        subprocess.run([*uv, "venv", "--python", "3.11", str(folder)], check=True)
        subprocess.run([*uv, "pip", "install", "--python", str(python), PACKAGE], check=True)
    return subprocess.run([str(python), __file__, *sys.argv[1:]], check=False).returncode


def library(output: Path, models: list[Path]) -> None:
    """Write the materials of glTF files as assets into a ``.blend`` file, with previews: a ball under sun and sky."""
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    for model in models:
        bpy.ops.import_scene.gltf(filepath=str(model.resolve()))
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.object.light_add(type="SUN", rotation=(math.radians(45.0), 0.0, math.radians(-45.0)))
    bpy.context.object.data.energy, bpy.context.object.data.angle = 5.0, math.radians(10.0)
    ball, scene = add_ball(), bpy.context.scene
    scene.world = bpy.data.worlds.new("sky")
    scene.world.node_tree.nodes["Background"].inputs["Color"].default_value = (0.3, 0.3, 0.3, 1.0)
    set_up_camera(DISTANCE_M, WIDTH_M)
    set_up_cycles(PREVIEW_SIZE, PREVIEW_SAMPLES)
    scene.view_settings.view_transform = "Standard"
    scene.render.image_settings.file_format = "PNG"
    count = len(bpy.data.materials)
    with tempfile.TemporaryDirectory(prefix="previews-") as folder:
        scene.render.filepath = str(Path(folder) / "preview.png")
        for material in bpy.data.materials:
            ball.data.materials.clear()
            ball.data.materials.append(material)
            bpy.ops.render.render(write_still=True)
            material.asset_mark()
            material.asset_data.author = "BRDF Suite"
            picture, preview = bpy.data.images.load(scene.render.filepath), material.preview_ensure()
            preview.image_size = picture.size
            preview.image_pixels_float = picture.pixels[:]
            bpy.data.images.remove(picture)
    ball.data.materials.clear()
    for thing in list(bpy.data.objects):
        bpy.data.objects.remove(thing)
    bpy.ops.wm.save_as_mainfile(filepath=str(output.resolve()), compress=True)
    print(f"{output}: {count} materials")


def load(model: Path, material: str | None) -> None:
    """Load what is rendered: a file's objects, or a sphere in a library's material."""
    import bpy

    path = str(model.resolve())
    if model.suffix == ".blend":
        with bpy.data.libraries.load(path, assets_only=True) as (_, wanted):
            wanted.materials = [material]
        add_ball().data.materials.append(bpy.data.materials[material])
    elif model.suffix in (".usda", ".usd"):
        bpy.ops.wm.usd_import(filepath=path)
    else:
        bpy.ops.import_scene.gltf(filepath=path)
    for thing in bpy.context.scene.objects:
        if thing.type == "MESH":
            for face in thing.data.polygons:
                face.use_smooth = True


def add_ball() -> Any:
    """Add a smooth sphere about the origin and return the object."""
    import bpy

    bpy.ops.mesh.primitive_uv_sphere_add(segments=256, ring_count=128, radius=RADIUS_M)
    bpy.ops.object.shade_smooth()
    return bpy.context.object


def set_up_camera(distance: float, width: float) -> None:
    """Let a camera look at the origin from Blender's -y."""
    import bpy
    from mathutils import Vector

    scene, camera = bpy.context.scene, bpy.data.objects.new("camera", bpy.data.cameras.new("camera"))
    scene.collection.objects.link(camera)
    camera.location = (0.0, -distance, 0.0)
    camera.rotation_euler = Vector((0.0, 1.0, 0.0)).to_track_quat("-Z", "Y").to_euler()
    camera.data.angle = 2.0 * math.atan(0.5 * width / distance)
    scene.camera = camera


def set_up_cycles(size: int, samples: int) -> None:
    """Let Cycles trace a square picture without anything that makes it smoother than it is."""
    import bpy

    scene, cycles = bpy.context.scene, bpy.context.scene.cycles
    scene.render.engine = "CYCLES"
    cycles.samples, cycles.use_adaptive_sampling, cycles.use_denoising = samples, False, False
    cycles.sample_clamp_indirect = cycles.sample_clamp_direct = cycles.blur_glossy = 0.0
    cycles.pixel_filter_type = "BOX"
    scene.render.film_transparent = True
    scene.render.resolution_x = scene.render.resolution_y = size
    scene.render.resolution_percentage = 100


def render(options: argparse.Namespace) -> None:
    """Render with ``bpy``; Blender's axes have z up: its (x, y, z) is our (x, -z, y)."""
    import bpy

    bpy.ops.wm.read_factory_settings(use_empty=True)
    scene = bpy.context.scene
    load(options.model, options.material)

    world = bpy.data.worlds.new("light")
    scene.world = world
    nodes, links = world.node_tree.nodes, world.node_tree.links
    image = bpy.data.images.load(str(options.light.resolve()))
    image.colorspace_settings.name = "Non-Color"
    texture, place = nodes.new("ShaderNodeTexEnvironment"), nodes.new("ShaderNodeMapping")
    texture.image, texture.interpolation = image, "Linear"
    # Our centre column looks along Blender's -y, Blender's along +x.
    place.inputs["Rotation"].default_value = (0.0, 0.0, math.radians(90.0))
    links.new(nodes.new("ShaderNodeTexCoord").outputs["Generated"], place.inputs["Vector"])
    links.new(place.outputs["Vector"], texture.inputs["Vector"])
    links.new(texture.outputs["Color"], nodes["Background"].inputs["Color"])

    set_up_camera(options.distance, options.width)
    set_up_cycles(options.size, options.samples)
    scene.view_settings.view_transform = "Raw"
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.color_depth = "OPEN_EXR", "RGBA", "32"
    scene.render.filepath = str(options.output.resolve())
    bpy.ops.render.render(write_still=True)


if __name__ == "__main__":
    sys.exit(main())
