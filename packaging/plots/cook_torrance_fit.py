"""Draw docs/images/cook_torrance_*.png: Figure 5 of Günther et al. 2005 remade, and measured paints the same way.

    python packaging/plots/cook_torrance_fit.py [DATA]

DATA is the folder of measured files (default: ../shared/data/brdf). The paper's figure shows two lobes fitted to its
Polaris Silber; the table here is simulated from its Table 1 with 3 % noise, since the measurement itself was never
published. The figures in docs/method/cook_torrance_fit.md come from `brdf-suite bench acquisition --json`.
"""

from __future__ import annotations

import argparse
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.cli.tools.bench import load_module
from brdf_suite.files.measured import read_measured
from brdf_suite.fitting.cook_torrance import Settings
from brdf_suite.fitting.cook_torrance.reflectance_fit import FileFit, fit_cook_torrance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

CHECKOUT = Path(__file__).resolve().parents[2]
IMAGES = CHECKOUT / "docs" / "images"
SIMULATED = load_module(CHECKOUT / "tests" / "benchmarks" / "parts" / "acquisition" / "acquisition_fit.py")
COLOURS = ("#1b6ca8", "#c8553d", "#3a7d44", "#8a5aa8")
DRAWN = (0, 2, 3)
"""Which of the plot's differences are drawn."""
TICKS = (0.1, 1, 3, 10, 20, 40, 60, 90)


def panel(axes: Axes, found: FileFit, title: str) -> None:
    """Draw the luminance of f_r over θh: dots measured, lines (of samples, crosses) fitted, parts dashed."""
    plot = found.plot
    scattered = isinstance(found.reflectance, ScatteredSamples)
    for number in DRAWN:
        colour = COLOURS[number]
        measured, fitted = plot.measured[number] @ LUMINANCE, plot.fitted[number] @ LUMINANCE
        both = np.isfinite(measured) & np.isfinite(fitted)
        axes.plot(plot.theta_h_deg[both], measured[both], ".", color=colour, ms=3.5, alpha=0.55)
        label = f"θd {plot.theta_d_deg[number]:.0f}°"
        # Scattered samples stand at φd of their own, and the fit beside each is no curve.
        style = {"marker": "x", "ms": 3.5, "lw": 0.0} if scattered else {"lw": 1.3}
        axes.plot(plot.theta_h_deg[both], fitted[both], color=colour, label=label, **style)
    first = np.isfinite(plot.fitted[DRAWN[0]]).all(axis=1)
    for part in plot.parts[:, DRAWN[0]] if not scattered else ():
        axes.plot(plot.theta_h_deg[first], part[first] @ LUMINANCE, "--", color="0.45", lw=0.8)
    axes.set_xscale("function", functions=(lambda x: np.sqrt(np.maximum(x, 0.0)), np.square))
    axes.set_xticks(TICKS, [f"{tick:g}" for tick in TICKS])
    axes.set_xlim(0.0, 90.0)
    axes.set_yscale("log")
    known = plot.measured[list(DRAWN)] @ LUMINANCE
    known = known[np.isfinite(known) & (known > 0.0)]
    axes.set_ylim(max(float(known.min()), 1e-5 * float(known.max())) / 2.0, 3.0 * float(known.max()))
    axes.set_title(f"{title}\nmean |ln(fit/measured)| {found.errors_within.l1_mean:.3f}", fontsize=9)
    axes.tick_params(labelsize=7)


def draw(rows: list[tuple[str, FileFit]], path: Path, columns: int) -> None:
    """Write one picture of panels."""
    count = -(-len(rows) // columns)
    figure, grid = plt.subplots(count, columns, figsize=(3.6 * columns, 2.9 * count), squeeze=False)
    for axes, (title, found) in zip(grid.ravel(), rows, strict=False):
        panel(axes, found, title)
    for axes in grid.ravel()[len(rows) :]:
        axes.set_visible(False)
    for axes in grid[-1]:
        axes.set_xlabel("θh, degrees", fontsize=8)
    for axes in grid[:, 0]:
        axes.set_ylabel("f_r, 1/sr", fontsize=8)
    grid[0, 0].legend(fontsize=7, loc="upper right", frameon=False)
    figure.tight_layout()
    figure.savefig(path, dpi=110)
    plt.close(figure)
    print(path, path.stat().st_size // 1000, "kB")


def fitted(title: str, reflectance: Reflectance, lobes: int) -> tuple[str, FileFit]:
    """Fit and print a summary."""
    found = fit_cook_torrance(title, reflectance, Settings(lobes=lobes))
    words = "two lobes" if lobes == 2 else "three lobes"
    print(title, words, found.errors_within)
    return f"{title}, {words}", found


def main() -> None:
    """Draw everything."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    default = CHECKOUT.parent / "shared" / "data" / "brdf"
    parser.add_argument("data", nargs="?", type=Path, default=default, help="the folder of measured files")
    data: Path = parser.parse_args().data
    polaris = SIMULATED.simulated_table(TABLE_1["table1_polaris_silver"], SIMULATED.NOISE)
    matte = SIMULATED.simulated_table(TABLE_1["table1_blue_matte"], SIMULATED.NOISE)
    draw(
        [
            fitted("Polaris Silver", polaris, 2),
            fitted("Polaris Silver", polaris, 3),
            fitted("Blue Matte", matte, 3),
        ],
        IMAGES / "cook_torrance_fit.png",
        3,
    )
    names = {
        "cayman.brdf": "Cayman",
        "krylon_blue.brdf": "Krylon True Blue",
        "vch_golden_yellow_rgb.bsdf": "Golden Yellow wrap",
    }
    measured = [fitted(title, read_measured(data / name), 3) for name, title in names.items()]
    draw(measured, IMAGES / "cook_torrance_measured.png", 3)


if __name__ == "__main__":
    main()
