"""Draw docs/images/sparkle_*.png: the three ways to draw flakes, from near and from far, and a lamp that moves.

    python packaging/pictures/sparkle.py [folder]

Rendered off screen with the programs' own renderer, in the packaged environments, at a fixed size.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from PIL import Image, ImageDraw

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.pipeline.lobe_fit import PaintFitter
from brdf_suite.pipeline.material import load_shipped_paint
from brdf_suite.pipeline.picture import SceneRenderer
from brdf_suite.pipeline.scene import load_environment, load_surface
from brdf_suite.realtime.gl.context import create_context

SIZE = (330, 200)
CAPTION = 18
MODES = {"off": "off: flakes in their mean", "texture": "flake texture", "glints": "converging glints"}
MIDDLE = (0.0, 0.1, 0.0)  # of the ball of 0.2 m
NEAR = (
    ("blue", -0.5, Camera(50.0, 36.0, 0.17, MIDDLE), "Blue, from 7 cm"),
    ("blue", -0.5, Camera(50.0, 33.0, 0.45, MIDDLE), "Blue, from 35 cm"),
    ("coarse_silver", -3.0, Camera(50.0, 36.0, 0.17, MIDDLE), "Coarse silver, from 7 cm"),
    ("coarse_silver", -3.0, Camera(50.0, 33.0, 0.45, MIDDLE), "Coarse silver, from 35 cm"),
)
FAR = (
    ("blue", -0.5, Camera(50.0, 33.0, 1.1, MIDDLE, 120.0), "Blue, from 1 m"),
    ("blue", -0.5, Camera(50.0, 33.0, 4.1, MIDDLE, 120.0), "Blue, from 4 m"),
    ("coarse_silver", -3.0, Camera(50.0, 33.0, 1.1, MIDDLE, 120.0), "Coarse silver, from 1 m"),
    ("coarse_silver", -3.0, Camera(50.0, 33.0, 4.1, MIDDLE, 120.0), "Coarse silver, from 4 m"),
)


class Studio:
    """One renderer, and what it shows at present."""

    def __init__(self) -> None:
        self._scene = SceneRenderer(create_context())
        self._fitter = PaintFitter(time_limit_s=1.0)
        self._scene.set_surface(load_surface("sphere"))

    def light(self, name: str) -> None:
        """Light with a packaged environment."""
        self._scene.set_environment(load_environment(name))

    def picture(self, paint: str, view: View) -> Image.Image:
        """Return one picture."""
        self._scene.set_material(self._fitter.fit(load_shipped_paint(paint)))
        return Image.fromarray(np.asarray(self._scene.image(view, SIZE)))

    def close(self) -> None:
        """Give everything back."""
        self._fitter.close()
        self._scene.release()


def sheet(rows: list[tuple[str, list[Image.Image]]], captions: list[str]) -> Image.Image:
    """Return pictures in rows, with a caption over each column and beside each row."""
    columns = len(captions)
    whole = Image.new("RGB", (columns * SIZE[0], CAPTION + len(rows) * SIZE[1]), "white")
    draw = ImageDraw.Draw(whole)
    for column, text in enumerate(captions):
        draw.text((column * SIZE[0] + 6, 3), text, fill="black")
    for row, (text, pictures) in enumerate(rows):
        top = CAPTION + row * SIZE[1]
        for column, picture in enumerate(pictures):
            whole.paste(picture, (column * SIZE[0], top))
        draw.text((6, top + 4), text, fill="white")
    return whole


def main(folder: Path) -> None:
    """Write the pictures into ``folder``."""
    studio = Studio()
    studio.light("sunny")
    for name, shown in (("near", NEAR), ("far", FAR)):
        rows = []
        for paint, ev, camera, title in shown:
            view = View(camera, "sunny", "sphere", exposure_ev=ev)
            rows.append((title, [studio.picture(paint, replace(view, sparkle=Sparkle(m))) for m in MODES]))
        save(sheet(rows, list(MODES.values())), folder / f"sparkle_{name}.png")

    studio.light("overcast")
    view = View(Camera(20.0, 15.0, 0.26, MIDDLE), "overcast", "sphere", exposure_ev=-1.5, background="grey")
    lamps = [Lamp("directional", azimuth_deg=a, elevation_deg=30.0, strength=1.5) for a in (18.0, 20.0, 22.0)]
    moved = [studio.picture("red", replace(view, lamps=(lamp,))) for lamp in lamps]
    turns = ["lamp at 18 degrees", "20 degrees", "22 degrees"]
    save(sheet([("Red, one lamp beside an overcast sky", moved)], turns), folder / "sparkle_lamp.png")
    studio.close()


def save(picture: Image.Image, path: Path) -> None:
    """Write a picture of 256 colours, small enough for a page."""
    picture.quantize(256).save(path, optimize=True)
    print(f"{path}: {path.stat().st_size // 1024} kB")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "docs" / "images")
