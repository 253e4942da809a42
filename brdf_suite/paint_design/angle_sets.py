"""A paint at other angles than it was measured at: what its model gives there, so that it keeps its look.

A reading whose geometry stays keeps its numbers to the last digit; a new one is what base and coat of the paint give
there, as CIE L*a*b*, rounded to hundredths, which no instrument resolves.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.geometries import GEOMETRY_SETS, Geometry
from brdf_suite.arrays import triple
from brdf_suite.documents.paint import Lab, Measurement, Paint
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.designed.build import build_paint
from brdf_suite.reflectance.protocol import Reflectance

DIGITS = 2
"""Decimals of the L*a*b* that is worked out for a new angle."""
FEWEST = 3
"""Readings under one light that a paint needs."""

_SAME_DEG = 1e-6


def set_name(paint: Paint) -> str | None:
    """Return which named set of geometries the paint's readings are at, in any order; None for another one."""
    own = {(m.illumination_deg, m.aspecular_deg) for m in paint.measurements}
    for name, entry in GEOMETRY_SETS.items():
        if own == {(g.illumination_deg, g.aspecular_deg) for g in entry.geometries}:
            return name
    return None


def at_geometries(
    paint: Paint, geometries: Sequence[Geometry], reflectance: Reflectance | None = None
) -> Paint:
    """Return the paint with readings at ``geometries``, in that order.

    ``reflectance`` is the paint's own where it is at hand; left out, it is built.

    Raises
    ------
    ValueRangeError
        There are fewer than three geometries under one light, or one twice.
    UnreachableError
        The paint has no reflectance, so nothing is known between its readings.
    """
    lights = [geometry.illumination_deg for geometry in geometries]
    if not lights or max(lights.count(light) for light in lights) < FEWEST:
        raise ValueRangeError("measurements", f"at least {FEWEST} readings under one light are wanted")
    kept = [_own(paint, geometry) for geometry in geometries]
    if None in kept:
        model = build_paint(paint) if reflectance is None else reflectance
        computed = _model_lab(model, geometries)
    else:
        computed = [(0.0, 0.0, 0.0)] * len(geometries)
    return replace(
        paint,
        measurements=tuple(
            Measurement(geometry.illumination_deg, geometry.aspecular_deg, found or new)
            for geometry, found, new in zip(geometries, kept, computed, strict=True)
        ),
    )


def with_angle(paint: Paint, geometry: Geometry, reflectance: Reflectance | None = None) -> Paint:
    """Return the paint with one reading more; errors as :func:`at_geometries`, also where it is there already."""
    if _own(paint, geometry) is not None:
        raise ValueRangeError("aspecular_deg", f"there is a reading at {geometry.aspecular_deg:g}° already")
    items = [Geometry(m.illumination_deg, m.aspecular_deg) for m in paint.measurements]
    place = next(
        (
            index
            for index, item in enumerate(items)
            if item.illumination_deg == geometry.illumination_deg
            and item.aspecular_deg > geometry.aspecular_deg
        ),
        len(items),
    )
    return at_geometries(paint, [*items[:place], geometry, *items[place:]], reflectance)


def without_angle(paint: Paint, index: int) -> Paint:
    """Return the paint without the reading ``index``.

    Raises :class:`ValueRangeError`: Fewer than three readings under one light would be left.
    """
    left = [m for i, m in enumerate(paint.measurements) if i != index]
    lights = [m.illumination_deg for m in left]
    if max(lights.count(light) for light in lights) < FEWEST:
        raise ValueRangeError(
            "measurements", f"a paint needs at least {FEWEST} readings under one light, so this one stays"
        )
    return replace(paint, measurements=tuple(left))


def _own(paint: Paint, geometry: Geometry) -> Lab | None:
    for reading in paint.measurements:
        if (
            abs(reading.illumination_deg - geometry.illumination_deg) <= _SAME_DEG
            and abs(reading.aspecular_deg - geometry.aspecular_deg) <= _SAME_DEG
        ):
            return reading.lab
    return None


def _model_lab(model: Reflectance, geometries: Sequence[Geometry]) -> list[Lab]:
    lights = np.array([geometry.illumination_deg for geometry in geometries])
    angles = np.array([geometry.aspecular_deg for geometry in geometries])
    rho = np.pi * model.eval(illumination(lights), aspecular_view(lights, angles))
    # Adding 0 turns -0.0, which would be saved as such, into 0.
    rows = np.round(working_to_lab(rho), DIGITS) + 0.0
    rows[:, 0] = np.maximum(rows[:, 0], 0.0)
    return [triple(row) for row in rows]
