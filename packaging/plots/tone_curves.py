"""Make the pictures of docs/method/pictures.md: one paint through every tone curve, and the curves themselves.

Run ``.venv/bin/python packaging/plots/tone_curves.py``; it writes docs/images/tone_curves.png and tone_curves.svg.
"""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

import matplotlib as mpl
import numpy as np
from PIL import Image, ImageDraw

from brdf_suite.appearance.colour.colorimetry import srgb_encode
from brdf_suite.documents.view import TONE_CURVES, View
from brdf_suite.output.still import loaded_scene
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.realtime.pictures.display import Display
from brdf_suite.realtime.pictures.tone_curves import tone_curve
from brdf_suite.reports.sheet_text import font_for

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
SIZE = (236, 140)
TITLES = {
    "faithful": "faithful (default)",
    "neutral": "Khronos PBR Neutral",
    "characteristic": "characteristic curve",
    "aces": "ACES (fitted)",
    "agx": "AgX",
    "linear": "linear, clipping marked",
}
DASHES = {
    "faithful": "solid",
    "neutral": (0, (6, 2)),
    "characteristic": (0, (2, 1)),
    "aces": (0, (6, 2, 1, 2)),
    "agx": (0, (1, 1)),
    "linear": (0, (8, 4)),
}


def pictures() -> Image.Image:
    """Return red and blue on the speed form in the light booth, one exposure brighter, through all curves."""
    view = View(environment="booth", surface="speed_form", exposure_ev=1.0)
    font, _ = font_for(["A"], 13)
    line = 20
    sheet = Image.new("RGB", (len(TONE_CURVES) // 2 * SIZE[0], 4 * SIZE[1] + 2 * line), (119, 119, 119))
    draw = ImageDraw.Draw(sheet)
    with loaded_scene(view) as loaded:
        for row, paint in enumerate(("blue", "red")):
            loaded.scene.set_material(fit_material(load_material(paint)))
            for number, kind in enumerate(TONE_CURVES):
                shown = replace(loaded.composed(view, SIZE), tone_curve=kind, clipping_marks=kind == "linear")
                # Without dither, which no packing makes smaller.
                pixels = loaded.scene.renderer.render_image(shown, SIZE, display=Display(dithered=False))
                left = number % 3 * SIZE[0]
                top = number // 3 * (2 * SIZE[1] + line)
                draw.text((left + 6, top + 2), TITLES[kind], (0, 0, 0), font)
                codes = np.rint(pixels / 257.0).astype(np.uint8)
                sheet.paste(Image.fromarray(codes), (left, top + line + row * SIZE[1]))
    return sheet


def plot() -> None:
    """Draw what each curve makes of a neutral radiance."""
    mpl.use("svg")
    mpl.rcParams["svg.hashsalt"] = "tone curves"
    from matplotlib import pyplot as plt

    stops = np.linspace(-7.0, 6.0, 400)
    radiance = 0.18 * 2.0**stops
    figure, axes = plt.subplots(figsize=(7.5, 4.2))
    for kind in TONE_CURVES:
        toned = tone_curve(np.repeat(radiance[:, None], 3, axis=1), kind)[:, 0]
        codes = 255.0 * srgb_encode(np.clip(toned, 0.0, 1.0))
        axes.plot(stops, codes, label=TITLES[kind], linestyle=DASHES[kind])
    axes.set_xlabel("stops from 0.18, a grey card in the light that makes white 1")
    axes.set_ylabel("code of the screen, 8 bits sRGB")
    axes.grid(alpha=0.3)
    axes.legend()
    figure.tight_layout()
    figure.savefig(IMAGES / "tone_curves.svg", metadata={"Date": None})


def main() -> None:
    """Write both."""
    IMAGES.mkdir(parents=True, exist_ok=True)
    sheet = pictures()
    sheet.save(IMAGES / "tone_curves.png", optimize=True)
    plot()
    for name in ("tone_curves.png", "tone_curves.svg"):
        print(f"{name}: {(IMAGES / name).stat().st_size / 1e3:.0f} kB")


if __name__ == "__main__":
    main()
