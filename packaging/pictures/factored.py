"""Draw docs/images/factored_*.png: measured paints on a teapot under three moving lights, beside their factors.

    python packaging/pictures/factored.py [--shared FOLDER] [--output docs/images] [--width 300] [NAME …]

NAME is a measured file in FOLDER/brdf without its ending; cayman and krylon_blue if left out. The upper row evaluates
the measured reflectance at every pixel, the lower one is the renderer's, from the textures that ``brdf-suite
factorize`` gives. Columns differ by where the lamps stand. Differences are printed: over all lit
pixels, and over those farther than 12° from every lamp's half vector, which are not of the peak.
"""

from __future__ import annotations

import argparse
import os
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.view import Camera, View
from brdf_suite.documents.view_settings import Lamp, LightColour, Sparkle, SurfaceLook
from brdf_suite.files.images.png import write_png
from brdf_suite.fitting.homomorphic.reflectance_fit import factor_reflectance
from brdf_suite.pipeline.lobe_fit import fit_material
from brdf_suite.pipeline.material import Material, load_material
from brdf_suite.pipeline.picture import OffscreenScene
from brdf_suite.pipeline.scene import load_environment
from brdf_suite.pipeline.surface import load_shaped
from brdf_suite.realtime.camera import compose
from brdf_suite.realtime.pictures.display import LINEAR
from brdf_suite.realtime.pictures.probe import geometry_picture
from brdf_suite.realtime.pictures.tone_curves import to_display, tone_curve
from tools.evaluation.direct_lamps import half_angles_deg, lamp_radiance

ROOT = Path(__file__).resolve().parents[2]
GAP = 4
FINER = 2
"""Places along a pixel's edge that are evaluated; the means are taken of what the screen shows."""
PEAK_DEG = 12.0
STEPS_DEG = (0.0, 50.0, 100.0)

LAMPS = (
    (-70.0, 35.0, 0.6, 0.30, 6500.0),
    (25.0, 55.0, 0.7, 0.40, 5000.0),
    (110.0, 20.0, 0.6, 0.22, 9000.0),
)
"""Azimuth and elevation in degrees, distance in metres from the middle of the teapot, strength, colour in kelvin."""


def lamps(turned_deg: float) -> tuple[Lamp, ...]:
    """Return the three lamps, each gone round by an angle, at a pace of its own."""
    found = []
    for number, (azimuth, elevation, distance, strength, kelvin) in enumerate(LAMPS):
        a, e = np.radians([azimuth + turned_deg * (1.0 - 0.6 * number), elevation])
        place = distance * np.array([np.cos(e) * np.sin(a), np.sin(e), np.cos(e) * np.cos(a)])
        x, y, z = place.tolist()
        found.append(Lamp("point", (x, y + 0.07, z), strength=strength, temperature_k=kelvin))
    return tuple(found)


def view_of(shared: Path) -> View:
    """Return the teapot in the dark."""
    return View(
        camera=Camera(25.0, 18.0),
        surface=str((shared / "meshes" / "teapot.obj").absolute()),
        surface_look=SurfaceLook(scale=0.05, recentre=True, occlusion=False),
        light_colour=LightColour(brightness=0.0),
        sparkle=Sparkle("off"),
        background="colour",
        background_colour=(0.0, 0.0, 0.0),
    )


def pictures(path: Path, view: View, size: tuple[int, int]) -> tuple[list[list[Floats]], dict[str, float]]:
    """Return two rows of radiance pictures, measured and factored, FINER times as fine, and what they differ by."""
    item = load_material(path)
    fit = fit_material(Material(item.name, factor_reflectance(item.name, item.reflectance).value))
    fine = (size[0] * FINER, size[1] * FINER)
    rows: list[list[Floats]] = [[], []]
    away: list[NDArray[np.bool_]] = []
    with OffscreenScene() as scene:
        scene.set_environment(load_environment("overcast"))
        scene.set_surface(load_shaped(view.surface, view.surface_look))
        scene.set_material(fit)
        view = replace(view, camera=compose(view.camera, scene.renderer.bounds, fine))
        seen = geometry_picture(scene.renderer, view, fine)
        for step in STEPS_DEG:
            lit = lamps(step)
            rows[0].append(lamp_radiance(item.reflectance, seen, lit))
            drawn = scene.renderer.render_image(replace(view, lamps=lit), fine, 1, display=LINEAR)
            rows[1].append(drawn[..., :3].astype(np.float64) * drawn[..., 3:])
            away.append(half_angles_deg(seen, lit) > PEAK_DEG)
    return rows, differences(rows, away)


def exposure(rows: list[list[Floats]]) -> float:
    """Return the EV at which the median of what is lit has 12 %, so that little leaves the screen's gamut."""
    grey = np.concatenate([picture.reshape(-1, 3) @ LUMINANCE for picture in rows[0]])
    return float(np.log2(0.12 / np.median(grey[grey > 0.02 * grey.mean()])))


def differences(rows: list[list[Floats]], away: list[NDArray[np.bool_]]) -> dict[str, float]:
    """Return relative RMS of the radiance, mean and median ΔE00 of the pictures, over all and away from the peak."""
    gain = 2.0 ** exposure(rows)
    measured, factored = (np.concatenate([p.reshape(-1, 3) for p in row]) for row in rows)
    far = np.concatenate([mask.ravel() for mask in away])
    lit = measured.max(axis=1) > 0.0
    shown = [working_to_lab(tone_curve(gain * one[lit], "faithful")) for one in (measured, factored)]
    colour = np.asarray(delta_e_2000(*shown))
    off = far[lit]
    found = {}
    for name, keep in (("all", np.ones(off.shape, np.bool_)), ("away", off)):
        truth, guess = measured[lit][keep], factored[lit][keep]
        found[f"{name}_rel_rms"] = float(np.sqrt(((truth - guess) ** 2).mean() / (truth**2).mean()))
        found[f"{name}_delta_e_mean"] = float(colour[keep].mean())
        found[f"{name}_delta_e_median"] = float(np.median(colour[keep]))
    found["away_share"] = float(off.mean())
    return found


def sheet(rows: list[list[Floats]]) -> NDArray[np.uint8]:
    """Return the rows as one picture, with gaps."""
    ev = exposure(rows)
    lines = []
    for row in rows:
        shown = []
        for picture in row:
            codes = to_display(picture, ev).astype(np.float64)
            height, width = (n // FINER for n in codes.shape[:2])
            small = codes.reshape(height, FINER, width, FINER, 3).mean(axis=(1, 3))
            shown.append(np.pad(small, ((0, GAP), (0, GAP), (0, 0)), constant_values=128.0))
        lines.append(np.concatenate(shown, axis=1))
    whole = np.concatenate(lines)[:-GAP, :-GAP]
    return np.ascontiguousarray(np.rint(whole), np.uint8)


def main() -> int:
    """Write the pictures and print the table."""
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    default = os.environ.get("BRDF_SUITE_SHARED", str(ROOT.parent / "shared"))
    parser.add_argument("--shared", type=Path, default=Path(default) / "data")
    parser.add_argument("--output", type=Path, default=ROOT / "docs" / "images")
    parser.add_argument("--width", type=int, default=300, help="of one of the six pictures, pixels")
    parser.add_argument("names", nargs="*", default=["cayman", "krylon_blue"])
    options = parser.parse_args()
    size = (options.width, options.width * 2 // 3)
    for name in options.names:
        rows, table = pictures(options.shared / "brdf" / f"{name}.brdf", view_of(options.shared), size)
        path = options.output / f"factored_{name}.png"
        write_png(path, sheet(rows), {"Title": f"{name}: measured above, factored below"})
        print(f"{path.name}: {path.stat().st_size / 1024:,.0f} KiB")
        for key, value in table.items():
            print(f"  {key}: {value:.3f}")
    return 0


if __name__ == "__main__":
    sys.exit(main())
