"""Draw docs/images/exchange_*.png and print the figures of docs/method/exchange.md.

    python packaging/pictures/exchange.py [--paints blue,pearl] [--clients blender,luxcore] [--blender FOLDER] [folder]

A sphere in each paint, path-traced from the paint itself, beside that of each client rendering what was exported, in
the light of brdf_suite/reflectance/instruments/rendered_sphere.py, as the losses are reported. ``--blender`` is the
folder of an environment for tools/blender.py, made and kept there; without it Blender is installed each time.
"""

from __future__ import annotations

import argparse
import subprocess
import sys
import tempfile
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from brdf_suite.appearance.colour.colorimetry import (
    LUMINANCE,
    REC709_TO_WORKING,
    WORKING_TO_SRGB,
    srgb_encode,
    working_to_lab,
)
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import View
from brdf_suite.files.exports import FORMATS
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.exports.luxcore import fit_carpaint
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.reference.mitsuba_modules import mi
from brdf_suite.reference.passes import trace
from brdf_suite.reference.scene.camera import PinholeCamera
from brdf_suite.reference.scene.scene import SurfacePart, build_scene
from brdf_suite.reference.variant import start
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.instruments.rendered_sphere import light_map

ROOT = Path(__file__).resolve().parents[2]
PAINTS = {
    "solid": ("solid_red", "solid_white"),
    "metallic": ("silver_metallic", "blue_metallic"),
    "pearl": ("pearl", "emerald_pearl"),
}
SIZE, BLOCK = 96, 3
DISTANCE, WIDTH, RADIUS = 2.0, 0.22, 0.1
CAPTION, GAP = 18, 4


def _ball() -> SurfacePart:
    """A fine sphere about the origin, y up."""
    theta, phi = np.meshgrid(np.linspace(0.0, np.pi, 129), np.linspace(0.0, 2.0 * np.pi, 257), indexing="ij")
    normals = np.stack(
        (np.sin(theta) * np.sin(phi), np.cos(theta), np.sin(theta) * np.cos(phi)), axis=-1
    ).reshape(-1, 3)
    first = (np.arange(128)[:, None] * 257 + np.arange(256)).ravel()
    below = first + 257
    triangles = np.concatenate(
        (np.stack((first, below, first + 1), axis=-1), np.stack((first + 1, below, below + 1), axis=-1))
    )
    return SurfacePart("paint", (RADIUS * normals).astype(np.float32), normals.astype(np.float32), triangles)


def ours(name: str, light: Floats, samples: int) -> Floats:
    """Path-trace a paint; return light and coverage (h, w, 4), linear Rec. 709."""
    from brdf_suite.reference.bsdfs.translate import translate

    term = translate(build_paint(load_shipped_paint(name))).term
    eye = PinholeCamera(np.array([0.0, 0.0, DISTANCE]), np.eye(3), 0.5 * WIDTH / DISTANCE)
    scene = build_scene([_ball()], {"paint": term}, light, eye, View(), (SIZE, SIZE))
    found = trace(scene, samples=samples, samples_per_pass=max(samples // 4, 1))
    print(f"{name}: path-traced, noise {100.0 * found.noise:.1f} % of the luminance", flush=True)
    return np.concatenate((found.radiance @ WORKING_TO_SRGB.T, found.coverage[..., None]), axis=-1)


def read(path: Path) -> Floats:
    """Return a picture (h, w, 4) of an EXR file."""
    bitmap = mi.Bitmap(str(path)).convert(
        mi.Bitmap.PixelFormat.RGBA, mi.Struct.Type.Float32, srgb_gamma=False
    )
    return np.array(bitmap, float)


def in_blender(model: Path, light: Path, samples: int, folder: Path | None) -> Floats:
    """Render an exported model in Blender; return light and coverage (h, w, 4)."""
    output = model.with_suffix(".blender.exr")
    kept = [] if folder is None else ["--environment", str(folder)]
    numbers = ["--size", str(SIZE), "--samples", str(samples)]
    command = [sys.executable, str(ROOT / "tools" / "blender.py"), str(model), str(light), str(output)]
    subprocess.run([*command, *numbers, *kept], check=True, capture_output=True)
    return read(output)


# LuxCore ends in its own way, so it has a process of its own. Its z is up: its (x, y, z) is our (x, -z, y).
_LUX = """
import math, os, sys, time
import numpy as np
import pyluxcore
material, name, light, output = sys.argv[1:5]
size, samples, distance, width, radius = (float(value) for value in sys.argv[5:])
pyluxcore.Init(lambda message: None)
scene, lines = pyluxcore.Scene(), pyluxcore.Properties()
lines.SetFromString(open(material).read() + f'''
scene.camera.type = "perspective"
scene.camera.lookat.orig = 0 {-distance} 0
scene.camera.lookat.target = 0 0 0
scene.camera.up = 0 0 1
scene.camera.fieldofview = {2.0 * math.degrees(math.atan(0.5 * width / distance))}
scene.camera.screenwindow = -1 1 -1 1
scene.camera.autofocus.enable = 0
scene.lights.sky.type = "infinite"
scene.lights.sky.file = "{light}"
scene.lights.sky.gamma = 1
scene.lights.sky.colorspace = "nop"
scene.lights.sky.visibilitymap.enable = 0
''')
scene.Parse(lines)
points, normals, faces = [], [], []
for i in range(129):
    for k in range(257):
        theta, phi = math.pi * i / 128, 2.0 * math.pi * k / 256
        n = (math.sin(theta) * math.cos(phi), math.sin(theta) * math.sin(phi), math.cos(theta))
        normals.append(n)
        points.append(tuple(radius * x for x in n))
for i in range(128):
    for k in range(256):
        a = i * 257 + k
        faces += [(a, a + 257, a + 1), (a + 1, a + 257, a + 258)]
scene.DefineMesh("ball", points, faces, normals, None, None, None)
lines = pyluxcore.Properties()
lines.SetFromString(f'scene.objects.ball.shape = "ball"\\nscene.objects.ball.material = "{name}"')
scene.Parse(lines)
settings = pyluxcore.Properties()
settings.SetFromString(f'''
renderengine.type = "PATHCPU"
sampler.type = "SOBOL"
film.width = {int(size)}
film.height = {int(size)}
film.filter.type = "NONE"
film.imagepipelines.0.0.type = "NOP"
film.outputs.0.type = "ALPHA"
film.outputs.0.filename = "alpha.exr"
path.pathdepth.total = 4
path.clamping.variance.maxvalue = 0
native.threads.count = 2
batch.haltspp = {int(samples)}
''')
session = pyluxcore.RenderSession(pyluxcore.RenderConfig(settings, scene))
session.Start()
while not session.HasDone():
    session.UpdateStats()
    time.sleep(0.05)
session.Stop()
film = session.GetFilm()
count = int(size) ** 2
pixels, alpha = np.zeros(count * 3, np.float32), np.zeros(count, np.float32)
film.GetOutputFloat(pyluxcore.FilmOutputType.RGB_IMAGEPIPELINE, pixels, 0)
film.GetOutputFloat(pyluxcore.FilmOutputType.ALPHA, alpha, 0)
whole = np.concatenate((pixels.reshape(-1, 3), alpha[:, None]), axis=1).reshape(int(size), int(size), 4)
np.save(output, whole[::-1])
os._exit(0)
"""


def in_luxcore(model: Path, name: str, light: Path, samples: int) -> Floats:
    """Render an exported material in LuxCore; return light and coverage (h, w, 4)."""
    output = model.with_suffix(".luxcore.npy")
    command = [sys.executable, "-c", _LUX, str(model), name, str(light), str(output)]
    numbers = map(str, (SIZE, samples, DISTANCE, WIDTH, RADIUS))
    subprocess.run([*command, *numbers], check=True, capture_output=True)
    return np.asarray(np.load(output), float)


def difference(first: Floats, other: Floats) -> tuple[float, Floats, Floats]:
    """Return the mean ΔE00, exposed for the first, and both as shown (h, w, 3).

    It is that of the blocks, each the mean of its pixels that are whole in both, and counted by their number.
    """
    inside = (first[..., 3] > 0.999) & (other[..., 3] > 0.999)
    light = first[..., :3] @ REC709_TO_WORKING.T @ LUMINANCE
    factor = 0.18 / float(np.median(light[inside]))
    pixels = _blocks(inside[..., None].astype(float))[..., 0]
    used = pixels > 0.0
    lab, other_lab = (
        working_to_lab(np.clip(factor * mean, 0.0, 1.0) @ REC709_TO_WORKING.T)
        for picture in (first, other)
        for mean in (_blocks(picture[..., :3] * inside[..., None])[used] / pixels[used][:, None],)
    )
    seen = np.average(delta_e_2000(lab, other_lab), weights=pixels[used])
    shown = [np.clip(picture[..., :3] * factor, 0.0, 1.0) for picture in (first, other)]
    return float(seen), shown[0], shown[1]


def _blocks(picture: Floats) -> Floats:
    """Return the means of blocks of pixels, in which noise counts little."""
    count = SIZE // BLOCK
    return np.asarray(picture.reshape(count, BLOCK, count, BLOCK, -1).mean(axis=(1, 3)))


def tile(shown: Floats, coverage: Floats, text: str) -> Image.Image:
    """Return a picture over grey under a line of text."""
    over = srgb_encode(shown) * coverage[..., None] + 0.85 * (1.0 - coverage[..., None])
    picture = Image.fromarray(np.round(255.0 * np.clip(over, 0.0, 1.0)).astype(np.uint8))
    whole = Image.new("RGB", (picture.width, picture.height + CAPTION), "white")
    whole.paste(picture, (0, CAPTION))
    ImageDraw.Draw(whole).text((2, 2), text, fill="black", font=ImageFont.load_default(11))
    return whole


def sheet(rows: list[list[Image.Image]]) -> Image.Image:
    """Return rows of pictures of one size."""
    width, height = rows[0][0].size
    whole = Image.new("RGB", (len(rows[0]) * (width + GAP) - GAP, len(rows) * (height + GAP) - GAP), "white")
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            whole.paste(picture, (x * (width + GAP), y * (height + GAP)))
    return whole


def main() -> int:
    """Render, compare and draw."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("folder", nargs="?", type=Path, default=ROOT / "docs" / "images")
    parser.add_argument("--paints", default=",".join(name for names in PAINTS.values() for name in names))
    parser.add_argument("--clients", default="blender,luxcore")
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--name", default="exchange", help="the picture's name, without its ending")
    parser.add_argument("--blender", type=Path, default=None, metavar="FOLDER")
    options = parser.parse_args()
    start()
    light = np.repeat(light_map(512)[..., None], 3, axis=2).astype(np.float32)
    formats = {known.name: known for known in FORMATS}
    clients = options.clients.split(",")
    rows = []
    with tempfile.TemporaryDirectory(prefix="exchange-") as temporary:
        work = Path(temporary)
        lit = work / "light.exr"
        mi.Bitmap(light).write(str(lit))
        for name in options.paints.split(","):
            paint = load_shipped_paint(name)
            truth = ours(name, light, options.samples)
            shown: list[tuple[str, Floats, float]] = []
            if "blender" in clients:
                formats["gltf"].write([ExportItem(paint)], work / f"{name}.gltf", None)
                picture = in_blender(work / f"{name}.gltf", lit, options.samples, options.blender)
                shown.append(("Blender", picture, fit_coated_facets(paint, "gltf").on_sphere))
            if "usd" in clients:
                formats["usd"].write([ExportItem(paint)], work / f"{name}.usda", None)
                picture = in_blender(work / f"{name}.usda", lit, options.samples, options.blender)
                shown.append(("Blender, USD", picture, fit_coated_facets(paint, "usd").on_sphere))
            if "luxcore" in clients:
                formats["luxcore"].write([ExportItem(paint)], work / f"{name}.scn", None)
                material = paint.name.replace(" ", "_")
                picture = in_luxcore(work / f"{name}.scn", material, lit, options.samples)
                shown.append(("LuxCore", picture, fit_carpaint(paint).on_sphere))
            tiles = []
            for client, picture, reported in shown:
                seen, first, other = difference(truth, picture)
                if not tiles:
                    tiles.append(tile(first, truth[..., 3], name.replace("_", " ")))
                tiles.append(tile(other, picture[..., 3], f"{client}: dE00 {seen:.1f}"))
                print(f"| {name} | {client} | {reported:.2f} | {seen:.2f} |", flush=True)
            rows.append(tiles)
            sheet(rows).save(options.folder / f"{options.name}.png", optimize=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())
