"""Readings: virtual instruments, comparison, physical checks, colour differences and the nearest paints."""

from __future__ import annotations

import os
from typing import TypeAlias

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.difference.tolerance import Tolerances, find_difference
from brdf_suite.appearance.geometries import geometry_set
from brdf_suite.arrays import Floats
from brdf_suite.documents.cook_torrance import CookTorrancePaint
from brdf_suite.documents.factored import FactoredPaint
from brdf_suite.documents.paint import Paint
from brdf_suite.documents.palette import Palette
from brdf_suite.errors import PathLike
from brdf_suite.geometry.directions import spherical as unit_directions
from brdf_suite.inspection.measuring import Comparison, read_material
from brdf_suite.inspection.measuring import compare as compare_materials
from brdf_suite.library.subjects import Subject, material_for
from brdf_suite.palettes.columns import labs_of
from brdf_suite.palettes.nearest_entries import NearEntry, colours_of_material, nearest_entries
from brdf_suite.palettes.search import Combine
from brdf_suite.pipeline.material import load_document, load_palette_file
from brdf_suite.reflectance.checks import CheckReport, check_model, check_reflectance
from brdf_suite.reflectance.instruments.aperture import aperture as aperture_named
from brdf_suite.reflectance.instruments.spectrophotometer import InstrumentReport
from brdf_suite.reflectance.registry import MODELS

Colours: TypeAlias = npt.ArrayLike


def spherical(theta: npt.ArrayLike, phi: npt.ArrayLike) -> Floats:
    """Return unit directions (..., 3) of polar angles ``theta`` and azimuthal angles ``phi``, radians; z is the normal.

    The angles broadcast.

    >>> import brdf_suite as bs
    >>> bs.spherical([0.0, 0.3], 0.0)[0].tolist()
    [0.0, 0.0, 1.0]
    """
    return unit_directions(theta, phi)


def measure(
    subject: Subject,
    *,
    geometry: str = "six",
    aperture: str = "point",
    observer_deg: int = 10,
    texture: bool = True,
) -> InstrumentReport:
    """Read a subject with a virtual multi-angle spectrophotometer (D65, 10°), glossmeter and texture instrument.

    Parameters
    ----------
    subject
        A name, a file, a paint, a material, a fit, or anything with ``eval``.
    geometry
        One of ``names("geometries")``, or angles in degrees: ``"45:15,45,110"``, the light before the colon.
    aperture
        The receptor's half-angle in degrees, ``"LIGHT,RECEPTOR"``, or ``point``, ``narrow``, ``wide``.
    observer_deg
        2 or 10: the observer through which the spectra of a measured file become colour.
    texture
        Read sparkle and graininess too, which take most of the time of a paint with flakes; otherwise they are None.

    Returns
    -------
    InstrumentReport
        ``lab`` (k, 3), and per reading XYZ, L*C*h and the reflectance factor; ``gloss`` in gloss units by 20, 60 and
        85°; ``haze``, ``flop`` and ``travel``; ``texture``: ``sparkle`` in light from 15, 45 and 75° (points per mm²,
        share of the area, contrast, grade) and ``graininess``, on the suite's own scale, 0 without flakes.

    Raises
    ------
    SuiteError
        As :func:`load`; there is no such geometry or aperture.

    >>> import brdf_suite as bs
    >>> blue = bs.measure("blue", geometry="45:15,45,110")
    >>> blue.lab.shape, [one.light_deg for one in blue.texture.sparkle], 0.0 < blue.texture.graininess < 1.0
    ((3, 3), [15.0, 45.0, 75.0], True)
    """
    geometries, through = geometry_set(geometry), aperture_named(aperture)
    item = material_for(subject, observer_deg=observer_deg)
    return read_material(item, geometries, through, texture=texture)


def compare(
    reference: Subject,
    sample: Subject,
    *,
    geometry: str = "six",
    aperture: str = "point",
    tolerances: Tolerances | None = None,
) -> Comparison:
    """Compare two subjects: colour differences at every angle, and errors over all directions.

    Parameters
    ----------
    reference, sample
        Subjects as of :func:`measure`; differences are of the sample against the reference.
    geometry, aperture
        As of :func:`measure`.
    tolerances
        What the sample is judged by; left out, there is no verdict.

    Returns
    -------
    Comparison
        ``differences`` by formula (``2000``, ``76``, ``cmc21`` …), a number for each angle; ``sentence`` in the trade's
        words; ``figures``, errors of f_r; ``verdict``.

    Raises
    ------
    SuiteError
        As :func:`measure`.

    >>> import brdf_suite as bs
    >>> same = bs.compare("blue", "blue")
    >>> max(same.differences["2000"])
    0.0
    """
    first, second = material_for(reference), material_for(sample)
    return compare_materials(first, second, geometry_set(geometry), aperture_named(aperture), tolerances)


def check(subject: Subject) -> CheckReport:
    """Check whether a subject, as of :func:`measure`, is reciprocal, never negative, and reflects no more than arrives.

    ``passed`` is whether every property that is claimed holds; ``findings`` has each with its size and its place,
    ``albedo`` and ``furnace`` (k, 3) the share that is reflected at ``incidence_deg``.

    Raises
    ------
    SuiteError
        As :func:`load`.

    >>> import brdf_suite as bs
    >>> bs.check("blue").passed
    True
    """
    if isinstance(subject, str) and subject in MODELS:
        return check_model(MODELS[subject])
    material = material_for(subject)
    return check_reflectance(material.reflectance, material.name)


def delta_e(reference: Colours, sample: Colours, formula: str = "2000") -> Floats:
    """Return colour differences (...) of L*a*b* colours.

    Parameters
    ----------
    reference, sample
        (..., 3), CIE 1976, D65 and 10°; they broadcast.
    formula
        ``2000`` (CIEDE2000), ``76``, ``cmc21``, ``cmc11``, ``cam02ucs``, or ``cmc:l:c`` with weights of one's own.

    Raises
    ------
    ValueRangeError
        There is no such formula.

    >>> import brdf_suite as bs
    >>> float(bs.delta_e([50.0, 0.0, 0.0], [52.0, 0.0, 0.0], "76"))
    2.0
    """
    return np.asarray(find_difference(formula)(reference, sample))


def find_nearest(
    subject: Subject, palette: Palette | PathLike, *, count: int = 10, combine: Combine = "mean"
) -> tuple[NearEntry, ...]:
    """Return the entries of a palette that look most like a subject, the nearest first.

    Colours are compared at 15, 45 and 110° from the mirror direction, light at 45°, by ΔE00.

    Parameters
    ----------
    subject
        As of :func:`measure`.
    palette
        A palette, or a file of any palette format.
    count
        How many at most.
    combine
        What orders them: the ``mean`` of the angles' differences, or the ``worst``.

    Returns
    -------
    tuple of NearEntry
        ``entry``, ``delta_e`` and ``per_angle`` (3,), NaN where a colour is not known.

    Raises
    ------
    SuiteError
        As :func:`load`; or the subject's colour is not known at any of the angles.

    >>> import brdf_suite as bs
    >>> mine = bs.Palette("mine", tuple(bs.Entry(bs.load(n, bs.Paint)) for n in ("blue", "fine_silver")))
    >>> [(near.entry.name, near.delta_e) for near in bs.find_nearest("blue", mine, count=1)]
    [('Blue', 0.0)]
    """
    known = palette if isinstance(palette, Palette) else load_palette_file(palette).palette
    return nearest_entries(known, _colours(subject), count, combine)


def _colours(subject: Subject) -> Floats:
    document = load_document(subject) if isinstance(subject, (str, os.PathLike)) else subject
    if isinstance(document, (Paint, CookTorrancePaint, FactoredPaint)):
        return labs_of(document)  # also of a paint that cannot be built
    return colours_of_material(material_for(subject))
