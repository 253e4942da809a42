"""Draw what the outline and the highlights of a simulated rig out of line leave unexplained; docs/images/.

    python packaging/plots/acquisition_geometry.py [FOLDER]

The lamp is 0.5° and the sphere 2 pixels off; photographs with noise, an unknown response and a lens with distortion.
"""

from __future__ import annotations

import sys
from pathlib import Path

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from brdf_suite.acquisition.geometry.lens import lens_pixels
from brdf_suite.acquisition.geometry.refinement.refinement import Refinement, refine
from brdf_suite.acquisition.geometry.sphere.outline import SphereOutline
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from tools.evaluation.simulated_source import SimulatorSource

PAINT = "table1_polaris_silver"
SETTINGS = SimulatorSettings(
    size=(320, 320), positions=24, light_offset_deg=0.5, centre_offset_px=(2.0, 0.0), light_height_m=0.04
)
_LONG = 200.0  # pixels of arrow for each pixel of residual


def main(folder: Path) -> None:
    """Simulate the rig, calibrate it and draw."""
    road = Acquisition(SimulatorSource(Simulator(CookTorrance(TABLE_1[PAINT]), SETTINGS, PAINT)))
    road.calibrate(lambda fraction, what: print(f"\r{fraction:4.0%} {what:40}", end="", flush=True))
    print()
    outline, refinement = road.outline, road.refinement
    assert outline is not None
    assert refinement is not None
    assert road.union is not None
    stated = refine(outline.geometry, outline, road.highlights)
    figure, axes = plt.subplots(
        1, 3, figsize=(13.2, 4.6), width_ratios=(1.0, 1.15, 1.15), layout="constrained"
    )
    draw_outline(axes[0], road.union, outline)
    draw_highlights(axes[1], axes[2], refinement)
    path = folder / "acquisition_residuals.png"
    figure.savefig(path, dpi=90)
    print(path)
    for row in stated.parameters:
        print(
            f"{row.name:40} {row.stated:9.5f} ± {row.stated_sigma:.5f} → {row.value:9.5f} ± {row.sigma:.5f} {row.unit}"
            f"  {row.observed:4.0%}"
        )
    print(f"outline {outline.rms_px:.4f} px of {np.count_nonzero(outline.used)} points")
    print(f"highlights {refinement.before_px:.3f} → {refinement.rms_px:.4f} px", end=", ")
    print(f"{refinement.before_deg:.3f} → {refinement.rms_deg:.4f}°, {len(refinement.positions)} of them")


def draw_outline(axes: Axes, union: np.ndarray, outline: SphereOutline) -> None:
    """Draw the sum of photographs with the edge's points and their residuals, magnified."""
    top = float(np.quantile(union, 0.995))
    axes.imshow(np.cbrt(np.clip(union / top, 0.0, 1.0)), cmap="gray")
    whole = outline.geometry.outline(np.linspace(0.0, 2.0 * np.pi, 361))
    axes.plot(*whole.T, color="#4aa3ff", lw=0.8)
    middle = lens_pixels(outline.geometry.lens, outline.centre_m)
    inward = middle - outline.points
    inward /= np.linalg.norm(inward, axis=-1, keepdims=True)
    ends = outline.points + _LONG * outline.residuals_px[:, None] * inward
    for point, end, used in zip(outline.points, ends, outline.used, strict=True):
        axes.plot(*np.stack((point, end)).T, color="#ff9f1c" if used else "#e63946", lw=1.2)
    axes.plot(*outline.points[outline.used].T, ".", color="#ffd166", ms=2.5)
    axes.set_title(f"Outline: RMS {outline.rms_px:.3f} pixels (drawn {_LONG:g} times)", fontsize=10)
    axes.set_xticks([])
    axes.set_yticks([])


def draw_highlights(left: Axes, right: Axes, refinement: Refinement) -> None:
    """Draw the residuals of the highlights against the lamp's angle, in pixels and in degrees."""
    angles = np.array(refinement.geometry.angles_deg)[refinement.positions]
    left.axhline(0.0, color="#999999", lw=0.8)
    for column, name, colour in ((0, "to the right", "#1d6fb8"), (1, "downward", "#d1495b")):
        left.plot(angles, refinement.residuals_px[:, column], "o-", ms=3, lw=0.9, color=colour, label=name)
    left.set_title(
        f"Highlights: RMS {refinement.before_px:.2f} pixels as stated, {refinement.rms_px:.3f} refined",
        fontsize=10,
    )
    left.set_xlabel("lamp, degrees")
    left.set_ylabel("seen less expected, pixels")
    left.legend(frameon=False, fontsize=9)
    right.plot(angles, refinement.residuals_deg, "o-", ms=3, lw=0.9, color="#2a9d8f")
    right.set_ylim(bottom=0.0)
    right.set_title(
        f"Lamp: RMS {refinement.before_deg:.2f}° as stated, {refinement.rms_deg:.3f}° refined",
        fontsize=10,
    )
    right.set_xlabel("lamp, degrees")
    right.set_ylabel("highlight's lamp to refined lamp, degrees")


if __name__ == "__main__":
    main(Path(sys.argv[1]) if len(sys.argv) > 1 else Path("docs/images"))
