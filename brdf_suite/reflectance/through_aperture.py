"""A designed paint whose readings were taken by an instrument with an aperture.

An aperture averages over directions, so a paint built from its readings as if they were of single directions measures
back differently: darker at 15°, where the colour falls steeply. The readings are therefore corrected until the paint
that they build reads, through that aperture, what was asked.
"""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.appearance.colorimetry import lab_to_working, working_to_lab
from brdf_suite.appearance.difference import delta_e_2000
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import UnreachableError, ValueRangeError
from brdf_suite.geometry.directions import Floats, aspecular_view, illumination
from brdf_suite.reflectance.aperture import Aperture, reflectance_factor
from brdf_suite.reflectance.build import build_paint
from brdf_suite.reflectance.paint_reflectance import PaintReflectance

TOLERANCE_DELTA_E = 0.05
"""The largest ΔE00 between a reading that was asked for and what the solved paint reads."""

_SETTLED_DELTA_E = 0.005
_MOST_TURNS = 12
_DARKEST = 1e-9


@dataclass(frozen=True)
class SolvedPaint:
    """The paint whose single directions give the readings through the aperture, built; ``delta_e`` per reading."""

    reflectance: PaintReflectance
    paint: Paint
    aperture: Aperture
    delta_e: tuple[float, ...]
    turns: int


def build_through(paint: Paint, aperture: Aperture) -> SolvedPaint:
    """Return the reflectance that reads the paint's own L*a*b* through ``aperture``, to ΔE00 0.05.

    Each turn multiplies a corrected reading, channel by channel in the working space, by asked / read.

    Raises
    ------
    UnreachableError
        No such paint was found, or the gloss or a colour is one that no paint can have; the message says which.
    """
    wi = illumination([m.illumination_deg for m in paint.measurements])
    wo = aspecular_view(
        [m.illumination_deg for m in paint.measurements], [m.aspecular_deg for m in paint.measurements]
    )
    wanted_lab = np.array([m.lab for m in paint.measurements])
    # What lies outside of the working space cannot be built; the paint's own notice says so.
    wanted = np.maximum(lab_to_working(wanted_lab), _DARKEST)
    corrected = paint
    best: SolvedPaint | None = None
    rho = wanted
    for turn in range(1, _MOST_TURNS + 1):
        reflectance = build_paint(corrected)
        read = np.array(
            [reflectance_factor(reflectance, wi[k], wo[k], aperture)[0] for k in range(len(wanted))]
        )
        delta = delta_e_2000(working_to_lab(wanted), working_to_lab(read))
        solved = SolvedPaint(reflectance, corrected, aperture, tuple(delta.tolist()), turn)
        if best is None or max(solved.delta_e) < max(best.delta_e):
            best = solved
        if max(solved.delta_e) <= _SETTLED_DELTA_E:
            break
        rho = rho * wanted / np.maximum(read, _DARKEST)
        try:
            corrected = _with_colours(paint, working_to_lab(rho))
        except ValueRangeError:
            break
    if best is None or max(best.delta_e) > TOLERANCE_DELTA_E:
        raise UnreachableError(_refusal(paint, aperture, best))
    return best


def _with_colours(paint: Paint, lab: Floats) -> Paint:
    measurements = tuple(
        replace(m, lab=(float(row[0]), float(row[1]), float(row[2])))
        for m, row in zip(paint.measurements, lab, strict=True)
    )
    return replace(paint, measurements=measurements)


def _refusal(paint: Paint, aperture: Aperture, best: SolvedPaint | None) -> str:
    if best is None:
        return f"{paint.name}: no paint reads these colours through {aperture.title}."
    worst = int(np.argmax(best.delta_e))
    angle = paint.measurements[worst].aspecular_deg
    return (
        f"{paint.name}: through {aperture.title}, no paint was found that reads the colour at {angle:g}° to better "
        f"than ΔE00 {best.delta_e[worst]:.2f}; use a smaller aperture, or correct that reading."
    )
