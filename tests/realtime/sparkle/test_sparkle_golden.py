"""Flakes from near and from far against pictures that were looked at and kept.

Renew with ``BRDF_SUITE_RENEW_GOLDEN=1``, after looking at the new pictures. A failing run keeps its picture and the
difference, eight times enlarged in value, in ``tests/golden/differences``. Drawn by Mesa's software renderer. A flake
at the edge of being seen may differ by rounding elsewhere: few pixels may be far off, the mean hardly.
"""

from __future__ import annotations

import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from PIL import Image

from brdf_suite.cli.tools.bench import load_module
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, Sparkle
from brdf_suite.realtime.lights.block import DistantLights

BALL = load_module(Path(__file__).resolve().parents[2] / "benchmarks" / "parts" / "ball.py")
FOLDER = Path(__file__).resolve().parents[2] / "golden"
SIZE = (240, 160)
MEAN_CODES, FAR_CODES, FAR_SHARE = 0.25, 12, 0.004


@pytest.mark.parametrize("mode", ["texture", "glints"])
@pytest.mark.parametrize("distance", [0.12, 1.2])
def test_flakes_on_a_ball(renderer, scenes, mode, distance):
    weights = scenes.weights(kd=0.03, gloss=0.04, directional=0.35)
    weights = replace(weights, kdd=weights.kdd * np.array([0.3, 0.5, 1.0]))
    sun = np.array([[0.3, 0.5, 0.81]]) / np.linalg.norm([0.3, 0.5, 0.81])
    lights = DistantLights(sun, np.full((1, 3), 1.5), np.array([0.005]))
    renderer.set_environment(scenes.constant(0.4), lambda: lights)
    renderer.set_mesh([BALL.ball(0.05, 64, with_uvs=True)])
    renderer.set_material("paint", weights)
    renderer.set_flakes("paint", Flakes(90.0, 30.0, 0.17, 0.3))
    view = View(
        Camera(10.0, 12.0, distance, (0.0, 0.0, 0.0), 50.0 * max(1.0, distance / 0.25)),
        lamps=(Lamp("point", (-0.1, 0.05, 0.2), strength=0.02),),
        sparkle=Sparkle(mode, strength=1.5),
        background="grey",
    )
    picture = renderer.render_image(view, SIZE)
    where = "near" if distance < 1 else "far"
    compare(picture, FOLDER / f"sparkle_{mode}_{where}.png")


def compare(picture, path):
    """Compare with the kept picture, or keep this one."""
    if os.environ.get("BRDF_SUITE_RENEW_GOLDEN") == "1":
        Image.fromarray(picture).save(path, optimize=True)
    with Image.open(path) as image:
        golden = np.asarray(image.convert("RGB"), int)
    difference = np.abs(picture.astype(int) - golden)
    share = (difference.max(-1) > FAR_CODES).mean()
    if difference.mean() > MEAN_CODES or share > FAR_SHARE:
        kept = path.parent / "differences"
        kept.mkdir(exist_ok=True)
        Image.fromarray(picture).save(kept / path.name)
        Image.fromarray(np.clip(8 * difference, 0, 255).astype(np.uint8)).save(
            kept / f"difference_{path.name}"
        )
        raise AssertionError(
            f"{path.name}: mean difference {difference.mean():.2f} codes, {100 * share:.2f} % of the pixels by more "
            f"than {FAR_CODES}; see {kept}"
        )
