"""Draw docs/images/texture_*.jpg: six paints at four distances, real time beside path traced, one sheet a light.

    python packaging/pictures/texture.py [folder]

A pixel is two minutes of arc, the least that an eye reads with ease, so the farther pictures show more of the ball of
0.2 m. In the sun its mirror direction is 25° off. Needs the extra for the path-traced reference.
"""

from __future__ import annotations

import math
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import SENSOR_WIDTH_MM, Camera, View
from brdf_suite.documents.view_settings import Sparkle, SurfaceLook
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.realtime.pictures.tone_curves import to_display
from brdf_suite.reference.passes import trace
from brdf_suite.tracing.reference.scene import build_reference

PAINTS = ("coarse_silver", "fine_silver", "blue", "red_metallic", "champagne", "white_pearl")
LIGHTS = ("sunny", "booth", "overcast")
DISTANCES_M = {0.07: "7 cm", 0.35: "35 cm", 1.0: "1 m", 4.0: "4 m"}
SIZE = (144, 96)
CAPTION = 16
SAMPLES = 256
RADIUS, MIDDLE = 0.1, (0.0, 0.1, 0.0)
_PIXEL = math.radians(2.0 / 60.0)
_AWAY_DEG = 25.0
_MIDDLE_GREY = 0.3
_BEHIND = 0.02


def main(folder: Path) -> None:
    """Write the sheets into ``folder``."""
    fits = {name: fit_material(load_material(name)) for name in PAINTS}
    mesh = load_shaped("sphere", SurfaceLook())
    with OffscreenScene() as scene:
        scene.set_surface(mesh, None)
        for light in LIGHTS:
            prepared = load_environment(light)
            scene.set_environment(prepared)
            azimuth, elevation = 35.0, 20.0
            if light == "sunny":
                sun = prepared.glint_lights.directions[0]
                elevation = math.degrees(math.asin(sun[1]))
                azimuth = math.degrees(math.atan2(sun[0], sun[2])) + _AWAY_DEG / math.cos(
                    math.radians(elevation)
                )
            rows = []
            for fit in fits.values():
                pictures: list[Image.Image] = []
                gain = None
                for distance in DISTANCES_M:
                    focal = SENSOR_WIDTH_MM / (SIZE[0] * _PIXEL)
                    view = View(
                        Camera(azimuth, elevation, RADIUS + distance, MIDDLE, focal),
                        light,
                        "sphere",
                        background="grey",
                    )
                    if gain is None:
                        smooth, _ = drawn(scene, fit, replace(view, sparkle=Sparkle("off")))
                        gain = _MIDDLE_GREY / float(np.median(smooth @ LUMINANCE))
                    traced = trace(
                        build_reference(fit.material, view, SIZE, prepared.environment, mesh).traced,
                        samples=SAMPLES,
                    )
                    for radiance, share in (
                        drawn(scene, fit, view),
                        (traced.radiance, traced.coverage),
                    ):
                        before = radiance * gain + (1.0 - share[..., None]) * _BEHIND
                        codes = to_display(before, 0.0, view.tone_curve)
                        pictures.append(Image.fromarray(np.asarray(codes, np.uint8)))
                rows.append((fit.material.name, pictures))
            save(sheet(rows), folder / f"texture_{light}.jpg")


def drawn(scene: OffscreenScene, fit: LobeFit, view: View) -> tuple[Floats, Floats]:
    """Return the ball's light (h, w, 3) in the real-time picture, and its share of each pixel (h, w)."""
    scene.set_material(fit, view=view)
    picture = np.asarray(scene.renderer.render_image(view, SIZE, display=LINEAR, transparent=True), float)
    return picture[..., :3], picture[..., 3]


def sheet(rows: list[tuple[str, list[Image.Image]]]) -> Image.Image:
    """Return pictures in rows, the paint's name on the first, distances over pairs of columns."""
    whole = Image.new("RGB", (2 * len(DISTANCES_M) * SIZE[0], CAPTION + len(rows) * SIZE[1]), "white")
    draw = ImageDraw.Draw(whole)
    for column, text in enumerate(DISTANCES_M.values()):
        for half, way in enumerate(("real time", "path traced")):
            draw.text(((2 * column + half) * SIZE[0] + 4, 2), f"{text}, {way}", fill="black")
    for row, (name, pictures) in enumerate(rows):
        top = CAPTION + row * SIZE[1]
        for column, picture in enumerate(pictures):
            whole.paste(picture, (column * SIZE[0], top))
        draw.text((5, top + 3), name, fill="black")
        draw.text((4, top + 2), name, fill="white")
    return whole


def save(picture: Image.Image, path: Path) -> None:
    """Write a picture whose grain stays, small enough for a page."""
    picture.save(path, quality=92, subsampling=0)
    print(f"{path}: {path.stat().st_size // 1024} kB")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "docs" / "images")
