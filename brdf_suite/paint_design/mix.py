"""Between two paints, and beyond them: colours, gloss, flakes and orange peel, each in the measure in which it is even.

Colours go straight through L*a*b* at each angle of the first paint; the second one's colours there are its readings or,
where it was not read, what its reflectance gives. Gloss is linear in gloss units; sizes and densities of flakes go
by ratios; the rest is linear.
"""

from __future__ import annotations

import math
from dataclasses import replace

from brdf_suite.appearance.colour.flat_colours import within_paint
from brdf_suite.documents.paint import PARAMETERS, STEEPEST_PEEL_DEG, Flakes, Gloss, OrangePeel, Paint
from brdf_suite.errors import ValueRangeError
from brdf_suite.paint_design.standard import Standard, paint_like, readings_like, standard_of

LEAST_SHARE, MOST_SHARE = -0.5, 1.5

_DECIMALS = 2
_LEAST_DENSITY = 0.5
# Flakes fewer than this per mm² are not seen; a density fades from here, as ratios cannot start at nothing.


def second_end(first: Paint, second: Paint | Standard) -> Paint:
    """Return the second paint read at the first one's angles; a paint of the same angles is returned as it is.

    Raises :class:`SuiteError`: it has no colour at one of them.
    """
    standard = second if isinstance(second, Standard) else standard_of(second)
    if standard.paint is not None and _angles(standard.paint) == _angles(first):
        return standard.paint
    if standard.paint is None:
        return paint_like(standard, first)
    return replace(standard.paint, measurements=readings_like(standard, first))


def mixed(first: Paint, second: Paint, share: float, name: str = "") -> Paint:
    """Return the paint at ``share`` of the way from first (0) to second (1), from -0.5 to 1.5.

    Both must have the same angles (:func:`second_end`). At 0 and 1 it is the very first and second, but for the name.

    Raises :class:`ValueRangeError`: the share is out of its range, or the angles differ.
    """
    if not LEAST_SHARE <= share <= MOST_SHARE:
        raise ValueRangeError("share", f"from {LEAST_SHARE:g} to {MOST_SHARE:g} is wanted, not {share:g}")
    if _angles(first) != _angles(second):
        raise ValueRangeError("measurements", "both paints must be read at the same angles")
    named = name or f"{first.name[:90]} {100.0 * share:.0f} % {second.name[:90]}"
    if share in (0.0, 1.0):
        return replace(first if share == 0.0 else second, name=named)
    nearer = first if share < 0.5 else second
    order = {(m.illumination_deg, m.aspecular_deg): m for m in second.measurements}
    measurements = []
    for m in first.measurements:
        pairs = zip(m.lab, order[m.illumination_deg, m.aspecular_deg].lab, strict=True)
        lab = within_paint([round(a + share * (b - a), _DECIMALS) + 0.0 for a, b in pairs])
        measurements.append(replace(m, lab=lab))
    return replace(
        nearer,
        name=named,
        measurements=tuple(measurements),
        gloss=_gloss(first.gloss, second.gloss, share),
        flakes=_flakes(first.flakes, second.flakes, share),
        orange_peel=_peel(first.orange_peel, second.orange_peel, share),
        near_specular=_limited("near_specular", first.near_specular, second.near_specular, share),
        notes="",
        source="",
    )


def _angles(paint: Paint) -> frozenset[tuple[float, float]]:
    return frozenset((m.illumination_deg, m.aspecular_deg) for m in paint.measurements)


def _limited(name: str, one: float, other: float, share: float, *, by_ratio: bool = False) -> float:
    known = PARAMETERS[name]
    if by_ratio:
        low = max(known.low, 1e-6)
        value = math.exp((1.0 - share) * math.log(max(one, low)) + share * math.log(max(other, low)))
    else:
        value = one + share * (other - one)
    return min(known.high, max(known.low, value))


def _gloss(one: Gloss, other: Gloss, share: float) -> Gloss:
    gu_20 = round(_limited("gloss.gu_20", one.gu_20, other.gu_20, share), _DECIMALS)
    if one.gu_60 is None or other.gu_60 is None:
        # One reading more than both have would be made up.
        return Gloss(gu_20)
    return Gloss(gu_20, round(_limited("gloss.gu_60", one.gu_60, other.gu_60, share), _DECIMALS))


def _flakes(one: Flakes | None, other: Flakes | None, share: float) -> Flakes | None:
    there = one or other
    if there is None:
        return None
    # Of no flakes only the density says something: they fade in or out, of one kind.
    first = one or replace(there, density_per_mm2=_LEAST_DENSITY)
    second = other or replace(there, density_per_mm2=_LEAST_DENSITY)
    found = Flakes(
        *(
            _limited(
                f"flakes.{name}",
                getattr(first, name),
                getattr(second, name),
                share,
                by_ratio=name in ("density_per_mm2", "size_um"),
            )
            for name in ("density_per_mm2", "size_um", "roughness", "colour_spread")
        )
    )
    return found if found.density_per_mm2 >= _LEAST_DENSITY else None


def _peel(one: OrangePeel | None, other: OrangePeel | None, share: float) -> OrangePeel | None:
    there = one or other
    if there is None:
        return None
    first, second = one or replace(there, amplitude_um=0.0), other or replace(there, amplitude_um=0.0)
    wavelength = _limited("orange_peel.wavelength_mm", first.wavelength_mm, second.wavelength_mm, share)
    amplitude = _limited("orange_peel.amplitude_um", first.amplitude_um, second.amplitude_um, share)
    # Beyond the two ends the waves could become steeper than any that has run out.
    steepest = math.tan(math.radians(STEEPEST_PEEL_DEG)) * wavelength * 1e3 / (2.0 * math.pi)
    return OrangePeel(min(amplitude, math.floor(1e3 * steepest) / 1e3), wavelength)
