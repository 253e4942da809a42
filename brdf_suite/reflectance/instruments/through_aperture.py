"""A designed paint whose readings were taken through an instrument's aperture.

An aperture averages over directions, so a paint built from its readings as if they were of single directions measures
back differently: darker at 15°, where the colour falls steeply. The readings are therefore corrected until the paint
that they build reads, through that aperture, what was asked.

What is asked are the paint's own colours, as its rule gives them in single directions. A rule with fewer numbers than
there are readings (a bell of flakes through six angles) passes near them only, with an aperture or without; then the
nearest paint is taken, and its residual is reported.
"""

from __future__ import annotations

import math
from dataclasses import dataclass, replace

import numpy as np

from brdf_suite.appearance.colour.colorimetry import lab_to_working, working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats, triple
from brdf_suite.documents.paint import Paint
from brdf_suite.errors import UnreachableError, ValueRangeError
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.designed.build import TOLERANCE_DELTA_E, build_paint, format_interpolation_notice
from brdf_suite.reflectance.designed.paint_reflectance import PaintReflectance
from brdf_suite.reflectance.instruments.aperture import POINT, Aperture, reflectance_factor

_SETTLED_DELTA_E = 0.005
_MOST_TURNS = 12
_DARKEST = 1e-9


@dataclass(frozen=True)
class SolvedPaint:
    """A paint whose readings through the aperture equal the given ones.

    ``delta_e`` is ΔE00 per reading between what the solved paint reads through the aperture and what the paint as
    it was reads without; ``missed`` that between the latter and the document: 0 where the rule passes through
    every reading.
    """

    reflectance: PaintReflectance
    paint: Paint
    aperture: Aperture
    delta_e: tuple[float, ...]
    missed: tuple[float, ...]
    turns: int

    @property
    def notices(self) -> tuple[str, ...]:
        """Notices for the user: the construction, and the residuals of the rule at the readings."""
        misses = format_interpolation_notice(self.paint, self.missed)
        if misses and self.aperture != POINT:
            misses += (
                f"Through the aperture the rule's own colours are met to ΔE00 {max(self.delta_e):.2f}.",
            )
        return self.reflectance.notices + misses


def build_through(paint: Paint, aperture: Aperture) -> SolvedPaint:
    """Return the reflectance that reads the paint's own colours through ``aperture``.

    To ΔE00 0.05, or, where the paint's rule does not pass through its readings, to no more than it misses them by.

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
    plain = build_paint(paint)
    # The colours as the rule gives them; outside of the working space the paint's own notice reports the rest.
    wanted = np.maximum(math.pi * plain.eval(wi, wo), _DARKEST)
    missed = tuple(delta_e_2000([m.lab for m in paint.measurements], working_to_lab(wanted)).tolist())
    corrected, reflectance = paint, plain
    best: SolvedPaint | None = None
    # What is corrected are the document's readings, which the rule may pass at a distance.
    rho = np.maximum(lab_to_working([m.lab for m in paint.measurements]), _DARKEST)
    for turn in range(1, _MOST_TURNS + 1):
        read = np.array(
            [reflectance_factor(reflectance, wi[k], wo[k], aperture)[0] for k in range(len(wanted))]
        )
        delta = delta_e_2000(working_to_lab(wanted), working_to_lab(read))
        solved = SolvedPaint(reflectance, corrected, aperture, tuple(delta.tolist()), missed, turn)
        if best is None or max(solved.delta_e) < max(best.delta_e):
            best = solved
        if max(solved.delta_e) <= _SETTLED_DELTA_E:
            break
        rho = rho * wanted / np.maximum(read, _DARKEST)
        try:
            corrected = _with_colours(paint, working_to_lab(rho))
            reflectance = build_paint(corrected)
        except (ValueRangeError, UnreachableError):
            # A correction has left what a paint can be; the best one so far is judged below.
            break
    # A rule that misses its readings anyway need not be met more closely than it meets them.
    if best is None or max(best.delta_e) > max(TOLERANCE_DELTA_E, *missed):
        raise UnreachableError(_refusal(paint, aperture, best))
    return best


def _with_colours(paint: Paint, lab: Floats) -> Paint:
    measurements = tuple(replace(m, lab=triple(row)) for m, row in zip(paint.measurements, lab, strict=True))
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
