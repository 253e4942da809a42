"""A small scene against a picture that was looked at and kept.

Renew with ``BRDF_SUITE_RENEW_GOLDEN=1``, after looking at the new picture. A failing run keeps its picture and the
difference, eight times enlarged in value, in ``tests/golden/differences``. Drawn by Mesa's software renderer; on
other renderers a few codes more are allowed.
"""

from __future__ import annotations

import os
from pathlib import Path

import numpy as np
from PIL import Image

from brdf_suite.documents.view import Camera, View
from brdf_suite.realtime.values import EnvironmentMaps, MaterialWeights

GOLDEN = Path(__file__).resolve().parent.parent / "golden" / "realtime_materials.png"
SIZE = (420, 130)
MEAN_CODES, FAR_CODES, FAR_SHARE = 0.25, 12, 0.002


def sky(d):
    """A sky, a ground, and a soft box."""
    height = d[..., 1:2]
    light = np.where(
        height > 0, np.array([0.35, 0.45, 0.6]) * (0.6 + 0.8 * height), np.array([0.2, 0.17, 0.14])
    )
    box = (np.abs(d[..., :1] - 0.2) < 0.25) & (height > 0.6) & (np.abs(d[..., 2:]) < 0.6)
    return np.where(box, 6.0, light)


def prefiltered(scenes, exponent, size):
    omega = scenes.directions(40).reshape(-1, 3).astype(np.float32)
    solid = np.abs(omega).max(-1, keepdims=True) ** 3
    light = np.hstack([sky(omega) * solid, solid])
    sums = np.empty((6 * size, size, 4))
    # Row by row, as the whole kernel would be a gigabyte; a whole power by squares takes a third of the time.
    rows = scenes.directions(size).reshape(6 * size, size, 3).astype(np.float32)
    for towards, row in zip(rows, sums, strict=True):
        square, kernel = np.maximum(towards @ omega.T, 0), 1.0
        for bit in reversed(f"{int(exponent):b}"):
            kernel = kernel * square if bit == "1" else kernel
            square = square * square
        row[:] = kernel @ light
    return scenes.cube((sums[..., :3] / sums[..., 3:]).reshape(6, size, size, 3), 2.0)


def test_materials(renderer, scenes):
    exponents = (6.0, 40.0, 300.0, 50000.0)
    sharp = scenes.cube(sky(scenes.directions(256)), 2.0)
    maps = EnvironmentMaps(
        exponents,
        (*(prefiltered(scenes, e, s) for e, s in zip(exponents[:3], (16, 32, 48), strict=True)), sharp),
        prefiltered(scenes, 1.0, 16),
        prefiltered(scenes, 1.17, 16),
        sharp,
    )
    kdd, kg = np.zeros((4, 3)), np.zeros((4, 3))
    kdd[0] = np.array([0.03, 0.09, 0.4]) * 7 / (2 * np.pi)
    kg[3] = 0.0502 * 50001 / (2 * np.pi)
    renderer.set_environment(maps)
    renderer.set_material("paint", MaterialWeights(exponents, np.array([0.01, 0.02, 0.05]) / np.pi, kdd, kg))
    names = ("paint", "glass", "rubber", "chrome", "lamp", "trim", "neutral")
    renderer.set_mesh([scenes.sphere(name, 0.1, (0.23 * i, 0, 0), rings=48) for i, name in enumerate(names)])
    picture = renderer.render_image(View(Camera(8, 14), exposure_ev=0.5, background="grey"), SIZE)

    if os.environ.get("BRDF_SUITE_RENEW_GOLDEN") == "1":
        GOLDEN.parent.mkdir(exist_ok=True)
        Image.fromarray(picture).save(GOLDEN, optimize=True)
    with Image.open(GOLDEN) as image:
        golden = np.asarray(image.convert("RGB"), int)
    difference = np.abs(picture.astype(int) - golden)
    if difference.mean() > MEAN_CODES or (difference.max(-1) > FAR_CODES).mean() > FAR_SHARE:
        kept = GOLDEN.parent / "differences"
        kept.mkdir(exist_ok=True)
        Image.fromarray(picture).save(kept / GOLDEN.name)
        Image.fromarray(np.clip(8 * difference, 0, 255).astype(np.uint8)).save(
            kept / f"difference_{GOLDEN.name}"
        )
        raise AssertionError(
            f"{GOLDEN.name}: mean difference {difference.mean():.2f} codes, "
            f"{100 * (difference.max(-1) > FAR_CODES).mean():.2f} % of the pixels by more than {FAR_CODES}; "
            f"see {kept}"
        )
