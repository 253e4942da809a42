"""Draw docs/images/raytraced_*.png: the qualities beside the converged picture, and flakes from near, far, and moving.

    python packaging/pictures/raytraced.py [folder]

After Figures 8 and 6 of Günther et al. 2005. Times and errors, which stand in the pictures, are printed as a table too.
"""

from __future__ import annotations

import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray
from PIL import Image, ImageDraw

from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Sparkle
from brdf_suite.tracing.raytraced.picture import PRESETS, RaytracedSession
from tools.evaluation.raytraced_presets import compare_presets

CAPTION = 18
PRESET_SIZE = (340, 230)
PRESET_PAINT = "copper"
PRESET_VIEW = View(environment="sunny", surface="car", camera=Camera(40.0, 9.0))
CONVERGED_SAMPLES = 1536

SPARKLE_SIZE = (230, 180)
SPARKLE_PAINT = "coarse_silver"
MIDDLE = (0.0, 0.1, 0.0)  # of the ball of 0.2 m
SPARKLE_VIEW = View(environment="sunny", surface="sphere", sparkle=Sparkle(mode="texture"), exposure_ev=-3.0)
MOVING = (50.0, 50.6, 51.2)  # azimuth, degrees
DISTANCES = (0.12, 0.18, 0.45)  # metres from the middle


def sheet(rows: list[list[tuple[str, NDArray[np.uint8]]]]) -> Image.Image:
    """Return pictures in rows, a caption over each."""
    height, width = rows[0][0][1].shape[:2]
    whole = Image.new("RGB", (len(rows[0]) * width, len(rows) * (height + CAPTION)), "white")
    draw = ImageDraw.Draw(whole)
    for j, row in enumerate(rows):
        for i, (text, pixels) in enumerate(row):
            left, top = i * width, j * (height + CAPTION)
            draw.text((left + 6, top + 3), text, fill="black")
            whole.paste(Image.fromarray(np.asarray(pixels)), (left, top + CAPTION))
    return whole


def presets(folder: Path) -> None:
    """Draw the qualities, and print their figures."""
    found = compare_presets(PRESET_PAINT, PRESET_VIEW, PRESET_SIZE, samples=CONVERGED_SAMPLES)
    tiles = []
    print(
        "| quality | l, s, p | core seconds | mean ΔE00 | 99th percentile | FLIP |\n|---|---|---|---|---|---|"
    )
    for one in found.tried:
        q, e = PRESETS[one.name], one.errors
        numbers = f"{q.lights}, {q.reflections}, {q.samples}"
        print(f"| {one.name} | {numbers} | {one.seconds:.2f} | {e.mean:.2f} | {e.p99:.2f} | {e.flip:.3f} |")
        tiles.append(
            (f"{one.name} ({numbers}): dE00 {e.mean:.2f}, {one.seconds:.2g} core seconds", one.codes)
        )
    tiles.append((f"path traced, {found.converged_samples} samples a pixel", found.converged))
    best = found.tried[-1]
    print(
        f"path tracing to the error of {best.name}: {found.paths_as_good_as(best.errors.mean):.1f} core seconds"
    )
    print("path tracing:", [(n, round(s, 2), round(e, 3)) for n, s, e in found.paths])
    sheet([tiles[:2], tiles[2:]]).save(folder / "raytraced_presets.png", optimize=True)


def sparkle(folder: Path) -> None:
    """Draw flakes under a moving view, and from near to far."""
    session = RaytracedSession()

    def tile(text: str, camera: Camera) -> tuple[str, NDArray[np.uint8]]:
        session.show(SPARKLE_PAINT, replace(SPARKLE_VIEW, camera=camera), SPARKLE_SIZE, "medium")
        return text, session.frame().codes()

    moving = [
        tile(f"2 cm away, turned by {a - MOVING[0]:.1f} deg", Camera(a, 36.0, DISTANCES[0], MIDDLE))
        for a in MOVING
    ]
    far = [tile(f"{100 * (d - 0.1):.0f} cm away", Camera(50.0, 36.0, d, MIDDLE)) for d in DISTANCES]
    sheet([moving, far]).save(folder / "raytraced_sparkle.png", optimize=True)


def main(folder: Path) -> None:
    """Draw both."""
    folder.mkdir(parents=True, exist_ok=True)
    for draw in (sparkle, presets):
        draw(folder)


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2] / "docs" / "images")
