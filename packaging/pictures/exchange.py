"""Measure what each export to a renderer looks like there: docs/method/exchange.json and docs/images/exchange.png.

    python packaging/pictures/exchange.py [--paints blue,pearl] [--clients blender,rgl] [--blender FOLDER] [--continue]

A sphere in each paint, path-traced from the paint itself, beside that of each client rendering what was exported, in
the light of brdf_suite/reflectance/instruments/rendered_sphere.py, as the losses are reported. Figures of other paints
and clients stay as they are in the file. Those that will be measured are removed from it first and written after each
paint; ``--continue`` removes none and measures what an interrupted run left out. At the end the tables of
docs/method/exchange.md are renewed. The picture is drawn where all of ``PICTURED`` are rendered by all clients in one
run. ``--blender`` is the folder of an environment for tools/blender.py, made and kept there; without it Blender is
installed each time.
"""

from __future__ import annotations

import argparse
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from time import perf_counter
from typing import Any

import numpy as np
from PIL import Image, ImageDraw, ImageFont

from brdf_suite.appearance.colour.colorimetry import (
    LUMINANCE,
    REC709_TO_WORKING,
    WORKING_TO_SRGB,
    srgb_encode,
)
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.view import View
from brdf_suite.errors import ValueRangeError
from brdf_suite.files.exports import FORMATS
from brdf_suite.files.exports.coated_facets_fit import fit_coated_facets
from brdf_suite.files.exports.format import ExportItem
from brdf_suite.files.exports.luxcore import fit_carpaint
from brdf_suite.files.exports.model_fit import material_names
from brdf_suite.files.exports.usd_preview import loss_in_blender
from brdf_suite.pipeline.material import load_measured, paint_names
from brdf_suite.reference.bsdfs.translate import translate
from brdf_suite.reference.mitsuba_modules import mi
from brdf_suite.reference.passes import trace
from brdf_suite.reference.scene.camera import PinholeCamera
from brdf_suite.reference.scene.scene import SurfacePart, build_scene
from brdf_suite.reference.variant import start
from brdf_suite.reflectance.instruments.rendered_sphere import light_map, shown_lab, sphere_difference
from brdf_suite.reports.handover import item_of
from tools.evaluation.materialx_picture import draw_sphere, irradiance_of

ROOT = Path(__file__).resolve().parents[2]
FIGURES = ROOT / "docs" / "method" / "exchange.json"
PICTURE = ROOT / "docs" / "images" / "exchange.png"
PICTURED = (
    "solid_red",
    "solid_white",
    "silver_metallic",
    "blue_metallic",
    "pearl",
    "emerald_pearl",
    "teal_violet_shift",
)
SIZE, BLOCK = 96, 3
SAMPLES: Mapping[str, int] = {"mitsuba": 144, "blender": 64, "luxcore": 196}
"""Paths a pixel of each program. Noise makes pictures differ more; with these it adds less than ΔE00 0.1."""
FURTHEST = 0.05
"""How far the middles of two spheres may be apart, pixels."""
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


@dataclass(frozen=True)
class Studio:
    """What all pictures share.

    The light as a map, its irradiance over π and the map's file, a folder, and Blender's or None.
    """

    light: Floats
    irradiance: Floats
    light_file: Path
    folder: Path
    blender: Path | None


def traced(term: Any, studio: Studio) -> Floats:
    """Path-trace the sphere in a BSDF; return light and coverage (h, w, 4) in the BSDF's own space."""
    eye = PinholeCamera(np.array([0.0, 0.0, DISTANCE]), np.eye(3), 0.5 * WIDTH / DISTANCE)
    light = studio.light.astype(np.float32)
    scene = build_scene([_ball()], {"paint": term}, light, eye, View(), (SIZE, SIZE))
    found = trace(scene, samples=SAMPLES["mitsuba"], samples_per_pass=SAMPLES["mitsuba"] // 4)
    return np.concatenate((found.radiance, found.coverage[..., None]), axis=-1)


def ours(item: ExportItem, studio: Studio) -> Floats:
    """Path-trace a paint; return light and coverage (h, w, 4), linear Rec. 709."""
    found = traced(translate(item.reflectance).term, studio)
    found[..., :3] = found[..., :3] @ WORKING_TO_SRGB.T
    return found


def read(path: Path) -> Floats:
    """Return a picture (h, w, 4) of an EXR file."""
    bitmap = mi.Bitmap(str(path)).convert(
        mi.Bitmap.PixelFormat.RGBA, mi.Struct.Type.Float32, srgb_gamma=False
    )
    return np.array(bitmap, float)


def export(item: ExportItem, name: str, studio: Studio) -> Path:
    """Write a paint in a format; return the file."""
    known = next(one for one in FORMATS if one.name == name)
    path = studio.folder / f"paint{known.ending}"
    known.write([item], path, None)
    return path


def in_blender(model: Path, studio: Studio) -> Floats:
    """Render an exported model in Blender; return light and coverage (h, w, 4)."""
    output = model.with_suffix(".exr")
    kept = [] if studio.blender is None else ["--environment", str(studio.blender)]
    numbers = ["--size", str(SIZE), "--samples", str(SAMPLES["blender"])]
    command = [sys.executable, str(ROOT / "tools" / "blender.py"), *kept, "render", str(model)]
    subprocess.run(
        [*command, str(studio.light_file), str(output), *numbers], check=True, stdout=subprocess.DEVNULL
    )
    return read(output)


def gltf_in_blender(item: ExportItem, studio: Studio) -> tuple[Floats, float]:
    """Return the picture (h, w, 4) of the glTF and the loss that is reported of it; so do the others below."""
    return in_blender(export(item, "gltf", studio), studio), fit_coated_facets(item, "gltf").on_sphere


def usd_in_blender(item: ExportItem, studio: Studio) -> tuple[Floats, float]:
    """Render the USD Preview Surface."""
    return in_blender(export(item, "usd", studio), studio), loss_in_blender(item)


def openpbr_in_materialx(item: ExportItem, studio: Studio) -> tuple[Floats, float]:
    """Draw the OpenPBR surface by the shader that MaterialX generates."""
    path = export(item, "openpbr", studio)
    light = (studio.light, studio.irradiance)
    picture = draw_sphere(path, *light, SIZE, radius=RADIUS, distance=DISTANCE, width=WIDTH)
    return picture, fit_coated_facets(item, "openpbr").on_sphere


def table_in_mitsuba(item: ExportItem, studio: Studio) -> tuple[Floats, float]:
    """Path-trace the RGL table by Mitsuba's own plug-in; what is reported is that of the table as it is read back."""
    path = export(item, "rgl", studio)
    picture = traced(mi.load_dict({"type": "measured", "filename": str(path)}), studio)
    return picture, sphere_difference(item.reflectance, load_measured(path).reflectance)


# LuxCore ends in its own way, so it has a process of its own. Its z is up: its (x, y, z) is our (x, -z, y). Its film is
# one row of pixels off the window that it is given, so the window is moved by one.
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
scene.camera.screenwindow = -1 1 {-1.0 - 2.0 / size} {1.0 - 2.0 / size}
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
path.forceblackbackground.enable = 1
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


def carpaint_in_luxcore(item: ExportItem, studio: Studio) -> tuple[Floats, float]:
    """Render the car paint."""
    path = export(item, "luxcore", studio)
    output = path.with_suffix(".npy")
    command = [sys.executable, "-c", _LUX, str(path), *material_names([item.name]), str(studio.light_file)]
    numbers = map(str, (SIZE, SAMPLES["luxcore"], DISTANCE, WIDTH, RADIUS))
    subprocess.run([*command, str(output), *numbers], check=True, stdout=subprocess.DEVNULL)
    return np.asarray(np.load(output), float), fit_carpaint(item).on_sphere


CLIENTS: Mapping[str, Callable[[ExportItem, Studio], tuple[Floats, float]]] = {
    "blender": gltf_in_blender,
    "luxcore": carpaint_in_luxcore,
    "usd": usd_in_blender,
    "openpbr": openpbr_in_materialx,
    "rgl": table_in_mitsuba,
}


def check_place(client: str, truth: Floats, picture: Floats) -> None:
    """Raise where a client's sphere is not where the truth's is: a row of pixels alone is a difference of ΔE00 1.8."""
    rows, columns = np.indices(truth.shape[:2])
    first, other = (
        np.array([np.average(where, weights=one[..., 3]) for where in (columns, rows)])
        for one in (truth, picture)
    )
    if np.abs(other - first).max() > FURTHEST:
        raise ValueRangeError("picture", f"the sphere of {client} is {other - first} pixels from the truth's")


def difference(first: Floats, other: Floats) -> tuple[float, Floats, Floats]:
    """Return the mean ΔE00, exposed for the first, and both as shown (h, w, 3).

    It is that of the blocks, each the mean light of what the sphere covers of it, and counted by the area. The rim is
    part of it, as of the losses that are reported. Light is cut off at 1 in the working space, as it is there: a
    material whose colours end with Rec. 709 differs from a paint that is outside.
    """
    light = first[..., :3] @ REC709_TO_WORKING.T @ LUMINANCE
    whole = first[..., 3] > 0.999
    factor = 0.18 / float(np.median(light[whole]))
    covered = [_blocks(picture[..., 3:]) for picture in (first, other)]
    area = np.minimum(*covered)[..., 0]
    used = area > 0.0
    lab, other_lab = (
        shown_lab(_blocks(picture[..., :3])[used] / cover[used] @ REC709_TO_WORKING.T, factor)
        for picture, cover in zip((first, other), covered, strict=True)
    )
    seen = np.average(delta_e_2000(lab, other_lab), weights=area[used])
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


def sheet(rows: list[list[Image.Image]], titles: list[str]) -> Image.Image:
    """Return rows of pictures of one size, under titles of their columns."""
    width, height = rows[0][0].size
    top = 2 * CAPTION + GAP
    whole = Image.new(
        "RGB", (len(rows[0]) * (width + GAP) - GAP, top + len(rows) * (height + GAP) - GAP), "white"
    )
    draw = ImageDraw.Draw(whole)
    for x, title in enumerate(titles):
        lines = title.replace(" in ", "\nin ")
        draw.text((x * (width + GAP) + 2, 3), lines, fill="black", font=ImageFont.load_default(12))
    for y, row in enumerate(rows):
        for x, picture in enumerate(row):
            whole.paste(picture, (x * (width + GAP), top + y * (height + GAP)))
    return whole


Figures = dict[str, dict[str, dict[str, float]]]
"""The losses of the file, reported and seen, by paint and client."""


def read_figures() -> Figures:
    """Return the figures of the file."""
    return json.loads(FIGURES.read_text(encoding="utf-8")) if FIGURES.is_file() else {}


def write_figures(figures: Figures) -> None:
    """Write the file; paints without figures have no place in it."""
    kept = {name: row for name, row in figures.items() if row}
    FIGURES.write_text(json.dumps(kept, indent=1, sort_keys=True) + "\n", encoding="utf-8")


def in_order(names: list[str]) -> list[str]:
    """Return paints with those of the picture first, so that it is drawn early."""
    return [*(name for name in PICTURED if name in names), *(name for name in names if name not in PICTURED)]


def remove_figures(names: list[str], clients: list[str]) -> None:
    """Remove what will be measured from the file, so that an interrupted run leaves gaps and no old figures."""
    figures = read_figures()
    for name in names:
        figures[name] = {
            client: row for client, row in figures.get(name, {}).items() if client not in clients
        }
    write_figures(figures)


def gaps(names: list[str], clients: list[str]) -> dict[str, list[str]]:
    """Return the clients of each paint that the file lacks, and print the others.

    The picture needs all of its paints in one run: where one is not finished, all of them are measured again.
    """
    figures = read_figures()
    found = {name: [client for client in clients if client not in figures.get(name, {})] for name in names}
    if pictures_all(names, clients) and any(found[name] for name in PICTURED):
        found.update(dict.fromkeys(PICTURED, clients))
    for name, lacking in found.items():
        for client in clients:
            if client not in lacking:
                row = figures[name][client]
                print(
                    f"{name}, {client}: in the file, reported {row['reported']:.2f}, seen {row['seen']:.2f}"
                )
    return {name: lacking for name, lacking in found.items() if lacking}


def pictures_all(names: list[str], clients: list[str]) -> bool:
    """Return whether a run measures all that the picture shows."""
    return set(PICTURED) <= set(names) and set(clients) == set(CLIENTS)


def measure_paint(name: str, clients: list[str], studio: Studio) -> list[Image.Image]:
    """Render a paint and its exports, add the figures to the file, and return the row of the picture."""
    item = item_of(name)
    truth = ours(item, studio)
    tiles: list[Image.Image] = []
    row: dict[str, dict[str, float]] = {}
    for client in clients:
        start_time = perf_counter()
        picture, reported = CLIENTS[client](item, studio)
        check_place(client, truth, picture)
        seen, first, other = difference(truth, picture)
        row[client] = {"reported": round(reported, 3), "seen": round(seen, 3)}
        seconds = perf_counter() - start_time
        print(f"{name}, {client}: reported {reported:.2f}, seen {seen:.2f} ({seconds:.0f} s)", flush=True)
        if not tiles:
            tiles.append(tile(first, truth[..., 3], name.replace("_", " ")))
        tiles.append(tile(other, np.minimum(truth[..., 3], picture[..., 3]), f"dE00 {seen:.1f}"))
    figures = read_figures()
    figures.setdefault(name, {}).update(row)
    write_figures(figures)
    return tiles


def draw_picture(rows: dict[str, list[Image.Image]], clients: list[str], titles: Mapping[str, str]) -> None:
    """Draw the picture of the document."""
    heads = ["path-traced", *(titles[client] for client in clients)]
    sheet([rows[name] for name in PICTURED], heads).save(PICTURE, optimize=True)


def main() -> int:
    """Render, compare, keep the figures and draw."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("--paints", default=",".join(paint_names()))
    parser.add_argument("--clients", default=",".join(CLIENTS))
    parser.add_argument("--continue", dest="continued", action="store_true")
    parser.add_argument("--blender", type=Path, default=None, metavar="FOLDER")
    options = parser.parse_args()
    names, clients = in_order(options.paints.split(",")), options.clients.split(",")
    if unknown := [*sorted({*names} - {*paint_names()}), *sorted({*clients} - {*CLIENTS})]:
        parser.error(f"there is no paint or client {', '.join(unknown)}")
    if not options.continued:
        remove_figures(names, clients)
    wanted = gaps(names, clients)
    documents = load_module(ROOT / "packaging" / "documents" / "insert_figures.py")
    start()
    light = np.repeat(light_map(512)[..., None], 3, axis=2)
    rows: dict[str, list[Image.Image]] = {}
    with tempfile.TemporaryDirectory(prefix="exchange-") as temporary:
        folder = Path(temporary)
        studio = Studio(light, irradiance_of(light), folder / "light.exr", folder, options.blender)
        mi.Bitmap(light.astype(np.float32)).write(str(studio.light_file))
        for name, lacking in wanted.items():
            rows[name] = measure_paint(name, lacking, studio)
            if name == PICTURED[-1] and pictures_all(list(rows), clients):
                draw_picture(rows, clients, documents.EXCHANGE_CLIENTS)
    if not pictures_all(list(rows), clients):
        print("The picture is as it was: it needs its paints by all clients in one run.")
    documents.insert_into_documents(ROOT)
    return 0


if __name__ == "__main__":
    sys.exit(main())
