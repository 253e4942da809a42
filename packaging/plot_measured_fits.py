"""Draw docs/images/measured_*.png and write docs/measured_errors.md: measured data against their lobes.

    python packaging/plot_measured_fits.py [DATA]

DATA is the folder of measured files (default: ../shared/data/brdf). The paper's Figure 6 shows measured
paints in an environment; here are also slices of each against its fit.
"""

from __future__ import annotations

import argparse
import tempfile
from collections.abc import Sequence
from pathlib import Path

import matplotlib as mpl

mpl.use("Agg")
import matplotlib.pyplot as plt
import numpy as np
from matplotlib.axes import Axes
from PIL import Image

from brdf_suite.appearance.colorimetry import LUMINANCE
from brdf_suite.documents.view import Camera, View
from brdf_suite.fitting.lobes.raised import RaisedWeights
from brdf_suite.fitting.lobes.undivided import fit_undivided
from brdf_suite.fitting.metrics import HeldOut
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.pipeline.fit_errors import held_out_errors
from brdf_suite.pipeline.lobe_fit import LobeFit, fit_material
from brdf_suite.pipeline.material import load_material
from brdf_suite.pipeline.still import render_to_file
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.tabulated.scattered import ScatteredSamples

IMAGES = Path(__file__).resolve().parent.parent / "docs" / "images"
PAGE = IMAGES.parent / "measured_errors.md"
TEXT = """\
# Errors of measured data as lobes

Written by `python packaging/plot_measured_fits.py`, over the measured files that [the page on these
fits](measured_fits.md) describes and the paints of Table 1, with the default basis.

## Errors where the fit did not look

For what can be evaluated everywhere: 4,096 direction pairs, eight lights by 16 × 32 views, even over both hemispheres.
For scattered samples: each fifth of them by a fit to the other four. "Of the data's" is the cosine-weighted RMS error
over the cosine-weighted RMS of the data. Where two errors stand under L1, they are of base and coat.

{}

## Colour differences

ΔE00 in the geometries of the trade (D65, 10°); in italics where the fit did not look. Scattered samples are compared
at the measured direction nearest to each, named by its own angles, and only within 5°.

{}

## Layers and undivided

The paints of Table 1 in both ways, on the same held-out directions.

{}
"""
FILES = {
    "cayman.brdf": "Cayman, metallic (Cornell)",
    "krylon_blue.brdf": "Krylon True Blue, frosted (Cornell)",
    "vch_golden_yellow_rgb.bsdf": "Golden Yellow wrap (RGL)",
    "paper_white_rgb.bsdf": "White paper (RGL)",
    "retro-gray-tape.dat": "Retro-reflective tape (ALTA)",
}
ONE_SAMPLE = "bird_example.json"
INCIDENCES_DEG = (20.0, 45.0, 70.0)
COLOURS = ("#1b6ca8", "#c8553d", "#3a7d44")
# A sample is of the plane of incidence where it is this near to it.
IN_PLANE_DEG = 4.0
TILE = (400, 225)


def slices(axes: Axes, found: LobeFit, title: str) -> None:
    """Draw f_r·cosθi over γ at a few incidences: the data as dots or a pale line, the lobes as a thin dark one."""
    lobes = RaisedWeights(found.weights)
    near = np.geomspace(0.05, 8.0, 60)
    gamma = np.sort(np.concatenate((np.linspace(-85.0, 140.0, 451), near, -near)))
    samples = found.reflectance if isinstance(found.reflectance, ScatteredSamples) else None
    incidences = INCIDENCES_DEG if samples is None else nearest(found.incidences_deg)
    for angle, colour in zip(incidences, COLOURS, strict=True):
        wi, wo = illumination(angle), aspecular_view(angle, gamma)
        above = wo[:, 2] > np.cos(np.radians(88.0))
        wi, wo, x = np.broadcast_to(wi, wo.shape)[above], wo[above], gamma[above]
        cosine = np.cos(np.radians(angle))
        if samples is None:
            axes.plot(
                x, cosine * (found.reflectance.eval(wi, wo) @ LUMINANCE), color=colour, alpha=0.35, lw=4
            )
        else:
            gammas, values = measured_in_plane(samples, angle)
            axes.plot(gammas, cosine * (values @ LUMINANCE), ".", color=colour, ms=4, alpha=0.6)
        axes.plot(x, lobes.reflected(wi, wo) @ LUMINANCE, color=colour, lw=1.2, label=f"{angle:.0f}°")
    axes.set_yscale("log")
    low, high = axes.get_ylim()
    axes.set_ylim(max(low, high * 1e-6), high)
    axes.set_title(title, fontsize=9)
    axes.set_xlim(-85, 140)
    axes.axvline(0.0, color="0.8", lw=0.6, zorder=0)
    axes.tick_params(labelsize=7)


def nearest(incidences_deg: Sequence[float]) -> list[float]:
    """The measured incidences nearest to the usual three."""
    return [min(incidences_deg, key=lambda one, want=want: abs(one - want)) for want in INCIDENCES_DEG]


def measured_in_plane(samples: ScatteredSamples, angle: float) -> tuple[np.ndarray, np.ndarray]:
    """γ in degrees and f_r of the samples in the plane of incidence with the light at ``angle``."""
    theta = np.degrees(np.arccos(np.clip(samples.wi[:, 2], 0.0, 1.0)))
    turn = np.arctan2(samples.wi[:, 1], samples.wi[:, 0])
    across = np.degrees(np.arcsin(np.clip(
        np.cos(turn) * samples.wo[:, 1] - np.sin(turn) * samples.wo[:, 0], -1.0, 1.0
    )))  # fmt: skip
    along = -(np.cos(turn) * samples.wo[:, 0] + np.sin(turn) * samples.wo[:, 1])
    mine = (np.abs(theta - angle) < 1.0) & (np.abs(across) < IN_PLANE_DEG)
    view = np.degrees(np.arctan2(along[mine], samples.wo[mine, 2]))
    return angle - view, samples.values[mine]


def draw_slices(path: Path, fits: dict[str, LobeFit], columns: int) -> None:
    """Draw one panel for each fit."""
    rows = -(-len(fits) // columns)
    figure, grid = plt.subplots(rows, columns, figsize=(3.4 * columns, 2.5 * rows), squeeze=False)
    for axes in grid.ravel()[len(fits) :]:
        axes.axis("off")
    for axes, (title, found) in zip(grid.ravel(), fits.items(), strict=False):
        slices(axes, found, title)
        axes.legend(fontsize=6, title="light at", title_fontsize=6, loc="upper right")
    for axes in grid[-1]:
        axes.set_xlabel("aspecular angle γ, degrees", fontsize=8)
    for axes in grid[:, 0]:
        axes.set_ylabel("Y of f_r·cosθi, 1/sr", fontsize=8)
    figure.tight_layout()
    figure.savefig(path, dpi=90)
    plt.close(figure)


def draw_pictures(path: Path, sources: Sequence[str | Path], columns: int) -> None:
    """Render each source in the generated sunny environment and put the pictures side by side."""
    rows = -(-len(sources) // columns)
    sheet = Image.new("RGB", (columns * TILE[0], rows * TILE[1]))
    view = View(Camera(azimuth_deg=35.0, elevation_deg=20.0), environment="sunny", background="grey")
    with tempfile.TemporaryDirectory() as folder:
        for k, source in enumerate(sources):
            one = Path(folder) / f"{k}.png"
            render_to_file(source, view, TILE, one)
            with Image.open(one) as image:
                if k == 0:  # places without a picture look like its background
                    sheet.paste(image.convert("RGB").getpixel((0, 0)), (0, 0, *sheet.size))
                sheet.paste(image.convert("RGB"), ((k % columns) * TILE[0], (k // columns) * TILE[1]))
    sheet.save(path, optimize=True)


def errors_table(fits: dict[str, LobeFit]) -> list[str]:
    """Return a row for each fit: its error at the samples and where it did not look."""
    lines = [
        "| | L1, worst channel | RMS, 1/sr | of the data's | cube-root | log | > 5° off: cube-root | log |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for title, found in fits.items():
        worst = ", ".join(f"{max(errors):.3f}" for errors in found.l1_errors.values())
        lines.append(f"| {title} | {worst} | {figures(found.held_out)} |")
    return lines


def figures(held_out: HeldOut | None) -> str:
    """Return the held-out figures as cells."""
    if held_out is None:
        return "– | – | – | – | – | –"
    away = held_out.away or held_out.figures
    whole = held_out.figures
    return (
        f"{whole.cosine_rms:.4f} | {held_out.relative_rms:.2f} | {whole.cube_root_rms:.4f} | {whole.log_rms:.4f} | "
        f"{away.cube_root_rms:.4f} | {away.log_rms:.4f}"
    )


def angles_table(fits: dict[str, LobeFit]) -> list[str]:
    """Return ΔE00 at each judged geometry, a row for each fit; in italics where the fit did not look."""
    lines = ["| | ΔE00 at light/aspecular angle |", "|---|---|"]
    for title, found in fits.items():
        cells = []
        for row in found.angles:
            cell = f"{row.illumination_deg:.0f}/{row.aspecular_deg:.0f}: {row.delta_e_2000:.1f}"
            cells.append(cell if row.fitted else f"*{cell}*")
        lines.append(f"| {title} | {', '.join(cells)} |")
    return lines


def both_ways_table(fits: dict[str, LobeFit]) -> list[str]:
    """Return each Cook-Torrance paint as two layers and undivided, on the same held-out directions."""
    lines = [
        "| | layers: of the data's RMS | cube-root | undivided: of the data's RMS | cube-root |",
        "|---|---|---|---|---|",
    ]
    for title, found in fits.items():
        whole = held_out_errors(found.reflectance, fit_undivided(found.reflectance).weights)
        assert whole is not None
        assert found.held_out is not None
        lines.append(
            f"| {title} | {found.held_out.relative_rms:.2f} | {found.held_out.figures.cube_root_rms:.4f} | "
            f"{whole.relative_rms:.2f} | {whole.figures.cube_root_rms:.4f} |"
        )
    return lines


def main() -> None:
    """Draw and write everything."""
    parser = argparse.ArgumentParser(
        description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter
    )
    parser.add_argument("data", nargs="?", type=Path, default=Path("../shared/data/brdf"))
    data = parser.parse_args().data
    measured = {title: fit_material(load_material(data / name), errors=True) for name, title in FILES.items()}
    paints = {paint.name: fit_material(load_material(name), errors=True) for name, paint in TABLE_1.items()}
    everything = {
        **measured,
        "One sample (BiRD)": fit_material(load_material(data / ONE_SAMPLE), errors=True),
        **paints,
    }
    tables = (errors_table(everything), angles_table({**measured, **paints}), both_ways_table(paints))
    PAGE.write_text(TEXT.format(*("\n".join(lines) for lines in tables)), encoding="utf-8")
    draw_slices(IMAGES / "measured_slices.png", measured, 3)
    draw_slices(IMAGES / "measured_slices_table1.png", paints, 4)
    draw_pictures(IMAGES / "measured_renders.png", [data / name for name in FILES], 3)
    draw_pictures(IMAGES / "measured_renders_table1.png", list(TABLE_1), 4)


if __name__ == "__main__":
    main()
