"""The eight paints of Table 1 of Günther et al. 2005, as the virtual instruments read them.

Run in a checkout, it writes ``docs/method/table1.md``; ``brdf-suite bench measure --write`` puts :func:`readings` into
``docs/method/measurements.md``. The figures are computed, nothing is copied::

    python packaging/measure_table1.py [FILE]
"""

from __future__ import annotations

import sys
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace
from pathlib import Path
from typing import Literal

import numpy as np

from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.geometry.directions import spherical
from brdf_suite.reflectance.aperture import POINT, WIDE, Aperture
from brdf_suite.reflectance.build import build_reflectance
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.spectrophotometer import Report, measure

HEAD = """\
# The measured paints of Table 1

Günther, Chen, Goesele, Wald and Seidel (VMV 2005) fitted three Cook-Torrance lobes to each of eight car paints. Their
L*a*b*, gloss, flop and travel, from the authors' own numbers, stand in
[the measurements](measurements.md#the-eight-paints-of-table-1); here is what an aperture changes, and what their two
facet distributions mean. Written by

    python packaging/measure_table1.py

Their equation 1 and their section 5.1.3 print facet distributions that differ by a factor of four, so both are here:
*full* is `D = exp(-tan²θ/m²)/(m² cos⁴θ)`, *quarter* a fourth of it. For *full* speaks that the sharpest lobe of the
silvers then reflects 0.054 to 0.057 at 45°, about what a clearcoat of index 1.5 does (0.050), and that no albedo
passes 1 up to 75° (at 89° Blue Matte's does, 1.10 in blue); for *quarter*, that L* at 15° is then about 100 for the
silvers, as for other measured silver paints, and not 160 to 180. The suite's default is *full*, with the paper's
equation.
"""

READINGS = """\
### The eight paints of Table 1

Günther et al. 2005, three Cook-Torrance lobes each, by the authors' own numbers with the *full* facet distribution; the
channels of their camera are taken as linear Rec. 2020. Read with the virtual multi-angle spectrophotometer (light at
45°, single directions, D65, 10° observer) and glossmeter. `brdf-suite measure table1_ford_f8 --json` gives more of
each, and [table1.md](table1.md) the readings through an aperture and the other facet distribution.

L*, a*, b* per aspecular angle:
"""

_ANGLES = "six"
_GRAZING_DEG = (0.0, 45.0, 75.0)
_NORMS: tuple[Literal["full"], Literal["quarter"]] = ("full", "quarter")
_RINGS, _AZIMUTHS = 400, 96


def directional_albedo(reflectance: Reflectance, theta_deg: float) -> float:
    """Return the share of light at a polar angle that is reflected, the largest of the channels.

    Half vectors are graded towards the normal (tan θh even in its cube root), where the lobes are: dω = 4 wi·h dωh.
    """
    wi = spherical(np.radians(theta_deg), np.pi)
    # θh from 0 to 90°, dense near 0: θh = 90° t³.
    t = (np.arange(_RINGS) + 0.5) / _RINGS
    theta_h, step = 0.5 * np.pi * t**3, 1.5 * np.pi * t**2 / _RINGS
    phi = 2.0 * np.pi * (np.arange(_AZIMUTHS) + 0.5) / _AZIMUTHS
    half = spherical(theta_h[:, None], phi[None, :])
    cosine = half @ wi
    wo = 2.0 * cosine[..., None] * half - wi
    seen = (cosine > 0.0) & (wo[..., 2] > 0.0)
    solid = (
        np.sin(theta_h)[:, None] * step[:, None] * (2.0 * np.pi / _AZIMUTHS) * 4.0 * np.maximum(cosine, 0.0)
    )
    values = reflectance.eval(wi, np.where(seen[..., None], wo, [0.0, 0.0, 1.0]))
    weights = np.where(seen, solid * np.maximum(wo[..., 2], 0.0), 0.0)
    return float(np.einsum("ij,ijc->c", weights, values).max())


def table(head: Sequence[str], rows: Iterator[Sequence[str]]) -> str:
    """Return a Markdown table."""
    lines = [f"| {' | '.join(head)} |", "|" + "---|" * len(head)]
    return "\n".join([*lines, *(f"| {' | '.join(row)} |" for row in rows)]) + "\n"


def _colours(reports: Mapping[str, Report]) -> str:
    first = next(iter(reports.values()))
    head = ["paint", *(f"{r.geometry.aspecular_deg:g}°" for r in first.readings)]
    rows = (
        [name, *(", ".join(f"{value:.1f}" for value in r.lab) for r in report.readings)]
        for name, report in reports.items()
    )
    return table(head, rows)


def _figures(reports: Mapping[str, Report]) -> str:
    def row(name: str, report: Report) -> list[str]:
        flop, path = report.flop, report.travel
        assert flop is not None
        assert path is not None
        uncertain = "" if flop.notice is None else " (uncertain: L*45 below 12)"
        gloss = [f"{report.gloss[angle]:.1f}" for angle in (20, 60, 85)]
        return [name, *gloss, f"{report.haze:.1f}", f"{flop.value:.1f}{uncertain}", f"{path.length:.1f}"]

    head = ["paint", "G20", "G60", "G85", "haze", "flop index", "travel in a*b*"]
    return table(head, (row(name, report) for name, report in reports.items()))


def _both_norms(paints: Mapping[str, CookTorrancePaint]) -> str:
    def row(paint: CookTorrancePaint, norm: Literal["full", "quarter"]) -> list[str]:
        reflectance = build_reflectance(replace(paint, d_norm=norm))
        report = measure(reflectance, geometry_set("e2194"))
        lightness = [f"{reading.lab[0]:.1f}" for reading in report.readings]
        albedo = [f"{directional_albedo(reflectance, angle):.3f}" for angle in _GRAZING_DEG]
        # The sharpest lobe is the clearcoat's; its share is what the paint loses without it.
        sharpest = min(range(len(paint.lobes)), key=lambda k: paint.lobes[k].m)
        coat = build_reflectance(
            replace(paint, d_norm=norm, kd=(0.0, 0.0, 0.0), lobes=(paint.lobes[sharpest],))
        )
        return [paint.name, norm, *lightness, *albedo, f"{directional_albedo(coat, 45.0):.4f}"]

    head = ["paint", "D", "L15", "L45", "L110", "albedo 0°", "45°", "75°", "sharpest lobe alone, 45°"]
    return table(head, (row(paint, norm) for paint in paints.values() for norm in _NORMS))


def _reports(aperture: Aperture) -> dict[str, Report]:
    return {
        paint.name: measure(build_reflectance(paint), geometry_set(_ANGLES), aperture)
        for paint in TABLE_1.values()
    }


def readings() -> str:
    """Return the colours, gloss, flop and travel of the eight paints as Markdown under one heading."""
    reports = _reports(POINT)
    gloss = "Gloss units of the whole paint, coat and base; haze, flop index and travel:\n"
    return "\n".join([READINGS, _colours(reports), gloss, _figures(reports)])


def page() -> str:
    """Return the whole page."""
    return "\n".join(
        [
            HEAD,
            f"## L*, a*, b* per aspecular angle, through an aperture\n\n{WIDE.title[0].upper()}{WIDE.title[1:]}; "
            "light at 45°; *full*.\n",
            _colours(_reports(WIDE)),
            "## Both facet distributions\n\nAlbedo: the share of light at 0, 45 and 75° that is reflected, the "
            "largest of the channels. Single directions.\n",
            _both_norms(TABLE_1),
        ]
    )


def main() -> int:
    """Write to the file named on the command line, or into the docs."""
    default = Path(__file__).resolve().parent.parent / "docs" / "method" / "table1.md"
    path = Path(sys.argv[1]) if len(sys.argv) > 1 else default
    path.write_text(page(), encoding="utf-8")
    print(path)
    return 0


if __name__ == "__main__":
    sys.exit(main())
