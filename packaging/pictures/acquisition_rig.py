"""Draw the rig from above and simulated photographs of it, for the guide and the method page on acquisition.

.venv/bin/python packaging/pictures/acquisition_rig.py
"""

from __future__ import annotations

import math
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np

from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.acquisition.simulator.sensor import response
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
SIDE = 240
ANGLES = (20.0, 60.0, 100.0, 150.0)
EXPOSURES = (0, 6, 10, 15)
AT = 1
"""The position whose exposures are shown."""
TILE_EXPOSURE = 9


def rig() -> None:
    """Draw the rig from above, as the session's world has it."""
    figure, axes = plt.subplots(figsize=(7.0, 4.2), layout="constrained")
    turned = np.radians(np.linspace(0.0, 180.0, 181))
    axes.plot(np.cos(turned) * 0.55, np.sin(turned) * 0.55, color="0.7", lw=1.0, ls="--")
    axes.add_patch(plt.Circle((0.0, 0.0), 0.06, color="#2b6ca3"))
    axes.plot([0.9], [0.0], "s", color="black", ms=11)
    axes.annotate("camera\n(0, height, distance)", (0.9, 0.0), (0.9, -0.075), ha="center", va="top")
    for degrees in (0.0, 45.0, 90.0, 135.0, 180.0):
        x, z = 0.55 * math.sin(math.radians(degrees)), 0.55 * math.cos(math.radians(degrees))
        axes.plot([z], [x], "o", color="#e8a020", ms=8, alpha=1.0 if degrees == 45.0 else 0.35)
        name = f"lamp at {degrees:g}°" if degrees == 45.0 else f"{degrees:g}°"
        axes.annotate(name, (z, x), (1.17 * z, 1.15 * x + 0.01), ha="center", va="center")
    lamp = 0.55 * math.sqrt(0.5)
    axes.plot([0.0, lamp], [0.0, lamp], color="#e8a020", lw=1.2)
    arc = np.radians(np.linspace(0.0, 45.0, 40))
    axes.plot(0.2 * np.cos(arc), 0.2 * np.sin(arc), color="black", lw=1.0)
    axes.annotate("α", (0.23, 0.08))
    axes.annotate("sphere", (0.0, 0.0), (0.0, -0.075), ha="center", va="top")
    for end, name in (((0.3, 0.0), "z"), ((0.0, 0.3), "x")):
        axes.annotate("", end, (0.0, 0.0), arrowprops={"arrowstyle": "->", "lw": 1.2})
        axes.annotate(name, end, (end[0] + 0.02, end[1] + 0.02))
    axes.set_aspect("equal")
    axes.set_xlim(-0.72, 1.12)
    axes.set_ylim(-0.2, 0.72)
    axes.axis("off")
    figure.savefig(IMAGES / "acquisition_rig.png", dpi=110)
    plt.close(figure)


def photographs() -> None:
    """Draw the sphere under four lamps, four exposures of one, and the calibration pictures."""
    paint = CookTorrance(TABLE_1["table1_polaris_silver"])
    simulated = Simulator(paint, SimulatorSettings(size=(SIDE, SIDE), angles_deg=ANGLES), "Polaris Silver")
    irradiance = np.array(simulated.truth["irradiance_rgb"])
    top = [response("srgb", np.clip(simulated.radiance(k) / (0.45 * irradiance), 0.0, 1.0)) for k in range(4)]
    series = simulated.position(AT)
    middle = [series[k] / 4095.0 for k in EXPOSURES]
    bottom = [simulated.white()[TILE_EXPOSURE] / 4095.0, *(simulated.board(i) / 4095.0 for i in (0, 3, 8))]
    names = [
        [f"lamp at {angle:g}°" for angle in ANGLES],
        [f"{simulated.session.exposures_s[k] * 1e3:.3g} ms" for k in EXPOSURES],
        ["white reference", "chessboard", "", ""],
    ]
    figure, rows = plt.subplots(3, 4, figsize=(8.0, 6.3), layout="constrained")
    for pictures, axes, texts in zip((top, middle, bottom), rows, names, strict=True):
        for picture, one, text in zip(pictures, axes, texts, strict=True):
            one.imshow(picture)
            one.set_title(text, fontsize=9)
            one.axis("off")
    figure.savefig(IMAGES / "acquisition_simulated.png", dpi=85)
    plt.close(figure)


if __name__ == "__main__":
    rig()
    photographs()
