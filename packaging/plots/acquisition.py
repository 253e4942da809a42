"""Draw docs/images/acquisition_*: a simulated rig reconstructed, its errors, and Figure 4 of Günther et al. 2005.

    python packaging/plots/acquisition.py [FOLDER] [--size 320] [--positions 180] [--paint table1_polaris_silver]

The photographs are those that ``acquire --simulate`` wrote into FOLDER; without one they are simulated as they are
asked for, with noise, a response that is not stated, and 12 bits.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.colors import LogNorm

from brdf_suite.acquisition.reconstruction.options import AcquireOptions, coverage_map, deviation_map, within
from brdf_suite.acquisition.reconstruction.reconstruction import Acquisition
from brdf_suite.acquisition.reconstruction.table import Acquired, reconstruct
from brdf_suite.acquisition.simulator import Simulator, SimulatorSettings
from brdf_suite.acquisition.table.sums import LAYOUTS, Parameterization
from brdf_suite.acquisition.table.table_from_sums import ParameterizedTable
from brdf_suite.geometry.directions import from_half_angle_coordinates
from brdf_suite.reflectance.models.cook_torrance import CookTorrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from tools.evaluation.simulated_source import SimulatorSource

IMAGES = Path(__file__).resolve().parents[2] / "docs" / "images"
TITLES = {
    "traditional": "θi, θo, Δφ",
    "linear": "θh, θd, φd, linear θh",
    "half-angle": "θh, θd, φd, non-linear θh",
}
BALL = 300
LIMIT_DEG = 75.0
INK, PALE = "#1a1a1a", "#8a8a8a"


def main() -> None:
    """Reconstruct and draw."""
    arguments = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    arguments.add_argument("folder", nargs="?", type=Path)
    arguments.add_argument("--size", type=int, default=320)
    arguments.add_argument("--positions", type=int, default=180)
    arguments.add_argument("--paint", default="table1_polaris_silver", choices=list(TABLE_1))
    options = arguments.parse_args()
    truth = CookTorrance(TABLE_1[options.paint])
    settings = SimulatorSettings(size=(options.size, options.size), positions=options.positions)
    wanted = AcquireOptions(compare=True)
    if options.folder is None:
        road = Acquisition(SimulatorSource(Simulator(truth, settings, options.paint)), wanted)
    else:
        road = Acquisition.open(options.folder, wanted)
    road.calibrate(show_progress)
    found = reconstruct(road, show_progress)
    draw_errors(found, truth, IMAGES / "acquisition_errors.png")
    draw_slices(found, truth, IMAGES / "acquisition_slices.png")
    draw_layouts(found, truth, IMAGES / "acquisition_parameterizations.jpg")


def show_progress(fraction: float, what: str) -> None:
    """Say how far the work is."""
    print(f"\r{fraction:4.0%} {what:40}", end="", file=sys.stderr, flush=True)


def relative_error(found: Acquired, truth: Reflectance) -> np.ndarray:
    """Return (θh, θd, φd), mean over the channels; NaN beyond 75° or below the horizon."""
    table = found.table
    error = np.full(table.values.shape[:3], np.nan)
    there = within(table, LIMIT_DEG)
    for h in range(table.grid.theta_h):
        wi, wo = table.grid.pairs(h)
        value = truth.eval(wi[there[h]], wo[there[h]])
        error[h][there[h]] = np.abs(table.values[h][there[h]] / value - 1.0).mean(axis=1)
    return error


def median_over_phi(values: np.ndarray) -> np.ndarray:
    """Return (θd, θh), NaN where a line of φd holds nothing."""
    answer = np.full(values.shape[:2], np.nan)
    known = ~np.isnan(values).all(axis=2)
    answer[known] = np.nanmedian(values[known], axis=1)
    return answer.T


def draw_errors(found: Acquired, truth: Reflectance, path: Path) -> None:
    """Draw what was measured, how far off it is, and how far off it says it is."""
    table = found.table
    error = relative_error(found, truth)
    holes = np.asarray(table.holes)
    measured = np.where(holes, np.nan, error)
    figure, axes = plt.subplots(1, 3, figsize=(12.0, 3.9), constrained_layout=True)
    pictures = (
        (coverage_map(table, LIMIT_DEG), "share of bins measured", None, "cividis"),
        (median_over_phi(measured), "median relative error, measured bins", LogNorm(1e-3, 1e-1), "magma"),
        (deviation_map(table), "median deviation as the table states it", LogNorm(1e-3, 1e-1), "magma"),
    )
    for panel, (values, title, norm, colours) in zip(axes, pictures, strict=True):
        limits = {"norm": norm} if norm else {"vmin": 0.0, "vmax": 1.0}
        image = panel.imshow(
            values, origin="lower", aspect="auto", cmap=colours, interpolation="nearest", **limits
        )
        ticks = np.array([0, 1, 5, 15, 30, 60, 90])
        panel.set_xticks(90.0 * np.sqrt(ticks / 90.0) - 0.5, [str(t) for t in ticks])
        panel.set_xlabel("θh, degrees (non-linear bins)")
        panel.set_title(title, fontsize=10)
        figure.colorbar(image, ax=panel)
    axes[0].set_ylabel("θd, degrees")
    figure.savefig(path, dpi=110)
    plt.close(figure)
    filled = np.where(holes, error, np.nan)
    print(f"\nmedian error, measured below {LIMIT_DEG:g}°: {np.nanmedian(measured):.4f}", file=sys.stderr)
    print(
        f"95th percentile: {np.nanpercentile(measured, 95):.4f}; filled: {np.nanmedian(filled):.4f}",
        file=sys.stderr,
    )


def draw_slices(found: Acquired, truth: Reflectance, path: Path) -> None:
    """Draw the table over θh at a few θd beside the truth, with the deviation that it states."""
    table = found.table
    theta_h, theta_d, phi_d = table.grid.centres()
    figure, axes = plt.subplots(1, 3, figsize=(12.0, 3.9), sharey=True, constrained_layout=True)
    for panel, wanted in zip(axes, (15.0, 40.0, 65.0), strict=True):
        d = int(np.argmin(np.abs(theta_d - np.radians(wanted))))
        p = table.grid.phi_d // 2
        fine = np.linspace(0.0, 0.5 * np.pi, 1500)
        wi, wo = from_half_angle_coordinates(fine, 0.0, theta_d[d], phi_d[p])
        value = truth.eval(wi, wo)
        known = ~np.asarray(table.holes)[:, d, p]
        for channel, colour in enumerate(("#b3392f", "#3a7d44", "#1b6ca8")):
            panel.plot(np.degrees(fine), value[:, channel], color=colour, lw=0.8)
            there = table.values[:, d, p, channel]
            panel.plot(np.degrees(theta_h)[known], there[known], ".", color=colour, ms=4)
            panel.plot(
                np.degrees(theta_h)[~known], there[~known], "o", color=colour, ms=3, mfc="none", mew=0.5
            )
        panel.set_yscale("log")
        panel.set_xscale("function", functions=(root, square))
        panel.set_xticks([0, 1, 5, 15, 30, 60, 90])
        panel.set_ylim(3e-2, 3e2)
        panel.set_xlim(0.0, 90.0)
        panel.set_title(f"θd = {np.degrees(theta_d[d]):.1f}°, φd = {np.degrees(phi_d[p]):.1f}°", fontsize=10)
        panel.set_xlabel("θh, degrees")
    axes[0].set_ylabel("f_r, 1/sr")
    axes[0].plot([], [], color=PALE, lw=0.8, label="truth")
    axes[0].plot([], [], ".", color=PALE, ms=5, label="measured bin")
    axes[0].plot([], [], "o", color=PALE, ms=3, mfc="none", mew=0.5, label="filled bin")
    axes[0].legend(fontsize=8, frameon=False)
    figure.savefig(path, dpi=110)
    plt.close(figure)


def root(x: np.ndarray) -> np.ndarray:
    """Return the axis of the non-linear bins."""
    return np.sqrt(np.maximum(x, 0.0))


def square(x: np.ndarray) -> np.ndarray:
    """Return the inverse of :func:`root`."""
    return np.asarray(x) ** 2


def draw_layouts(found: Acquired, truth: Reflectance, path: Path) -> None:
    """Draw balls under one light from each layout: its bins as they are, empty ones black, and filled and blended."""
    table = found.table
    tables = {
        **found.compared,
        "half-angle": ParameterizedTable(table.values, np.asarray(table.holes), Parameterization()),
    }
    figure, axes = plt.subplots(2, 4, figsize=(12.0, 6.4), constrained_layout=True)
    for column, layout in enumerate(sorted(LAYOUTS, key=list(TITLES).index)):
        one = tables[layout]

        def bins(wi: np.ndarray, wo: np.ndarray, one: ParameterizedTable = one) -> np.ndarray:
            value, known = one.nearest(wi, wo)
            return np.where(known[:, None], value, 0.0)

        axes[0, column].imshow(ball(bins))
        axes[1, column].imshow(ball(one.eval))
        axes[0, column].set_title(TITLES[layout], fontsize=10)
    axes[1, 3].imshow(ball(truth.eval))
    axes[1, 3].set_title("the paint itself", fontsize=10)
    for panel in axes.flat:
        panel.set_xticks([])
        panel.set_yticks([])
        panel.set_frame_on(False)
    axes[0, 0].set_ylabel("bins, empty ones black")
    axes[1, 0].set_ylabel("filled and blended")
    figure.savefig(path, dpi=100, pil_kwargs={"quality": 90})
    plt.close(figure)


def ball(reflectance: Callable[[np.ndarray, np.ndarray], np.ndarray]) -> np.ndarray:
    """Return a picture (h, w, 3), 0 to 1, of a ball under a distant light at 40°, its highlight enlarged."""
    light = np.array(
        [np.sin(np.radians(40.0)) * 0.8, np.sin(np.radians(40.0)) * 0.6, np.cos(np.radians(40.0))]
    )
    light /= np.linalg.norm(light)
    side = (np.arange(BALL) + 0.5) / BALL * 2.0 - 1.0
    whole = shaded(reflectance, light, side, side[::-1])
    half = light + np.array([0.0, 0.0, 1.0])
    half /= np.linalg.norm(half)
    near = 0.14 * ((np.arange(BALL // 3) + 0.5) / (BALL // 3) * 2.0 - 1.0)
    detail = shaded(reflectance, light, half[0] + near, half[1] + near[::-1])
    whole[-BALL // 3 :, : BALL // 3] = detail
    return whole


def shaded(
    reflectance: Callable[[np.ndarray, np.ndarray], np.ndarray],
    light: np.ndarray,
    across: np.ndarray,
    upward: np.ndarray,
) -> np.ndarray:
    """Return the unit ball's picture, seen from +z without perspective, at places across and upward."""
    x, y = np.meshgrid(across, upward)
    inside = x * x + y * y < 0.999
    normal = np.stack((x, y, np.sqrt(np.maximum(1.0 - x * x - y * y, 0.0))), axis=-1)[inside]
    # A frame about the normal; the paint knows no direction, so any tangent serves.
    tangent = np.cross(np.array([0.0, 1.0, 0.0]), normal)
    tangent /= np.linalg.norm(tangent, axis=1)[:, None]
    frame = np.stack((tangent, np.cross(normal, tangent), normal), axis=1)
    wi, wo = frame @ light, frame @ np.array([0.0, 0.0, 1.0])
    lit = wi[:, 2] > 0.02
    radiance = np.zeros_like(normal)
    radiance[lit] = reflectance(wi[lit], wo[lit]) * wi[lit, 2:]
    picture = np.ones((*x.shape, 3))
    picture[inside] = (radiance / (radiance + 1.0) * 1.25).clip(0.0, 1.0) ** (1.0 / 2.2)
    return picture


if __name__ == "__main__":
    main()
