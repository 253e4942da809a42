"""Accuracy of the virtual instruments on designed paints, and time of a measurement.

The paints are the shipped ones and 60 random ones with a possible clearcoat (L* at 15° 45 to 130, any hue, 20° gloss
5 to 95). Gloss integrates the whole reflectance over the receptor, instead of the formula used to solve the coat. It
is compared with an integration over the standards' apertures that shares no step with it, at 20, 60 and 85°, for these
paints, those of Table 1 and coats alone.
"""

from __future__ import annotations

import runpy
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from brdf_suite.appearance.clearcoat_gloss import gloss_units
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import geometry_set, measured_set
from brdf_suite.documents.paint import Gloss, Measurement, Paint
from brdf_suite.errors import UnreachableError
from brdf_suite.pipeline.material import load_shipped_paint, paint_names
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.designed.build import build_paint, build_reflectance
from brdf_suite.reflectance.designed.coat_lobe import CoatLobe
from brdf_suite.reflectance.instruments.aperture import APERTURES, POINT, WIDE
from brdf_suite.reflectance.instruments.glossmeter import GLOSS_ANGLES_DEG, gloss_reading
from brdf_suite.reflectance.instruments.spectrophotometer import measure
from brdf_suite.reflectance.instruments.through_aperture import build_through
from brdf_suite.reflectance.models.table_1 import TABLE_1
from brdf_suite.reflectance.protocol import Reflectance
from tools.evaluation.gloss_apertures import aperture_gloss

NAME = "measure"

#: key: (comparison, bound, unit, meaning)
BOUNDS: dict[str, tuple[str, float | None, str, str]] = {
    "point_delta_e": ("<=", 0.05, "ΔE00", "worst reading against the document, no aperture"),
    "narrow_delta_e": (
        "<=",
        0.05,
        "ΔE00",
        "the same, solved and read with half-angles of 1° (light) and 2° (receptor)",
    ),
    "wide_delta_e": ("<=", 0.05, "ΔE00", "the same with 2° and 4°"),
    "wide_unsolved_delta_e": (
        "",
        None,
        "ΔE00",
        "the same with 2° and 4°, the paint not solved through the aperture",
    ),
    "gloss_20_gu": ("<=", 0.5, "GU", "worst total 20° gloss, integrated, against the document"),
    "gloss_aperture_gu": (
        "<=",
        0.05,
        "GU",
        "worst gloss at 20, 60 and 85° against an integration over source and receptor direction by direction",
    ),
    "coat_formula_gu": (
        "",
        None,
        "GU",
        "worst difference of integral and formula for the coat, α .002 to .05, 20 and 60°",
    ),
    "refused": ("", None, "", "random paints excluded because no clearcoat has their gloss"),
    "report_ms": ("", None, "ms", "one report: six angles, three gloss angles; no aperture, median"),
    "report_wide_ms": ("", None, "ms", "the same through 2° and 4°"),
}

_RANDOM = 60
_SEED = 27
_ROUGHNESSES = (0.002, 0.003, 0.005, 0.01, 0.02, 0.05)


def aperture_error(reflectance: Reflectance) -> float:
    """Return the largest difference in GU between the glossmeter and the apertures' integration."""
    return max(
        abs(gloss_reading(reflectance, angle) - aperture_gloss(reflectance, angle))
        for angle in GLOSS_ANGLES_DEG
    )


def paints() -> Iterator[Paint]:
    """Yield the shipped paints, then random ones without end."""
    yield from (load_shipped_paint(name) for name in paint_names())
    rng = np.random.default_rng(_SEED)
    while True:
        light = rng.uniform(45.0, 130.0)
        middle = light * rng.uniform(0.35, 0.75)
        dark = middle * rng.uniform(0.2, 0.8)
        hue, chroma = rng.uniform(0.0, 2.0 * np.pi), rng.uniform(0.0, 0.5)
        labs = [
            (level, chroma * level * np.cos(hue + turn), chroma * level * np.sin(hue + turn))
            for level, turn in zip((light, middle, dark), rng.normal(0.0, 0.3, 3), strict=True)
        ]
        readings = [
            Measurement(45.0, angle, lab) for angle, lab in zip((15.0, 45.0, 110.0), labs, strict=True)
        ]
        yield Paint("random", tuple(readings), Gloss(float(rng.uniform(5.0, 95.0))))


def run(progress: Progress | None) -> dict[str, float | None]:
    """Return the figures."""
    worst = dict.fromkeys(APERTURES, 0.0)
    unsolved, gloss, refused, used = 0.0, 0.0, 0, 0
    coats = [CoatLobe(1.53, alpha) for alpha in _ROUGHNESSES]
    others = [*coats, *map(build_reflectance, TABLE_1.values())]
    apertures = max(map(aperture_error, others))
    times: dict[str, list[float]] = {"point": [], "wide": []}
    wanted = len(paint_names()) + _RANDOM
    for paint in paints():
        if used == wanted:
            break
        report(progress, used / wanted, "paints")
        asked = np.array([m.lab for m in paint.measurements])
        angles = measured_set([(m.illumination_deg, m.aspecular_deg) for m in paint.measurements])
        try:
            plain = build_paint(paint)
        except UnreachableError:
            refused += 1
            continue
        # A colour that the working space does not hold is shown as the nearest one, and that is reported.
        if any("more saturated" in notice for notice in plain.notices):
            continue
        used += 1
        for name, through in APERTURES.items():
            solved = build_through(paint, through).reflectance
            found = delta_e_2000(asked, measure(solved, angles, through).lab).max()
            worst[name] = max(worst[name], float(found))
        unsolved = max(unsolved, float(delta_e_2000(asked, measure(plain, angles, WIDE).lab).max()))
        gloss = max(gloss, abs(gloss_reading(plain, 20) - paint.gloss.gu_20))
        apertures = max(apertures, aperture_error(plain))
        for through in (POINT, WIDE):
            start = time.perf_counter()
            measure(plain, geometry_set("six"), through)
            times[through.name].append(time.perf_counter() - start)
    formula = max(
        abs(gloss_reading(coat, angle) - gloss_units(angle, coat.ior, coat.roughness))
        for coat in coats
        for angle in (20, 60)
    )
    return {
        **{f"{name}_delta_e": value for name, value in worst.items()},
        "wide_unsolved_delta_e": unsolved,
        "gloss_20_gu": gloss,
        "gloss_aperture_gu": apertures,
        "coat_formula_gu": formula,
        "refused": float(refused),
        "report_ms": 1e3 * float(np.median(times["point"])),
        "report_wide_ms": 1e3 * float(np.median(times["wide"])),
    }


def appendix() -> str:
    """Return the readings of the eight paints of Table 1, as Markdown."""
    script = Path(__file__).resolve().parents[2] / "packaging" / "documents" / "measure_table1.py"
    return str(runpy.run_path(str(script))["readings"]())
