"""What is said of any reflectance in numbers: albedo over incidence, reciprocity, energy, colours at aspecular angles.

A value that is not a number (a hole of a measurement) is left out and counted, so that a table with holes has figures.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS, Geometry, GeometrySet
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Lab
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.inspection.figures.errors import Errors, errors_between, fit_errors
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.checks import Turned, even_pairs, reciprocity
from brdf_suite.reflectance.protocol import Reflectance

INCIDENCES_DEG = (0.0, 10.0, 20.0, 30.0, 40.0, 45.0, 50.0, 60.0, 70.0, 75.0, 80.0, 85.0, 89.0)
"""Where the albedo is taken, polar angles of the light in degrees."""

CHANNELS = ("red", "green", "blue")

_AZIMUTHS, _AZIMUTHS_ANISOTROPIC = 64, 128
_LUMINANCE = np.array([0.2627, 0.6780, 0.0593])
"""Of linear Rec. 2020 (ITU-R BT.2020, table 4)."""


@dataclass(frozen=True, eq=False)
class AlbedoCurve:
    """The share of the light that is sent back: ``albedo`` (k, 3) at ``incidence_deg`` (k,), linear Rec. 2020."""

    incidence_deg: Floats
    albedo: Floats

    @property
    def luminous(self) -> Floats:
        """Return the share (k,) of white light, by luminance."""
        luminous: Floats = self.albedo @ _LUMINANCE
        return luminous

    @property
    def hemispherical(self) -> Floats:
        """Return the share (3,) of even light: the mean of the albedo over sin²θ, straight between the angles."""
        share = np.sin(np.radians(self.incidence_deg)) ** 2
        # The first and the last angle stand for what lies before and beyond them.
        x = np.concatenate(([0.0], share, [1.0]))
        y = np.concatenate((self.albedo[:1], self.albedo, self.albedo[-1:]))
        mean: Floats = np.einsum("k,kc->c", np.diff(x), 0.5 * (y[1:] + y[:-1]))
        return mean

    @property
    def largest(self) -> tuple[float, float, str]:
        """Return the largest share of any channel, the incidence where it is, and the channel's name."""
        row, channel = np.unravel_index(int(np.argmax(self.albedo)), self.albedo.shape)
        return (
            float(self.albedo[row, channel]),
            float(self.incidence_deg[row]),
            CHANNELS[channel],
        )


@dataclass(frozen=True)
class Reciprocity:
    """|f(i,o) - f(o,i)| over the larger of both: the worst, where it is, and the median of even pairs."""

    worst: float
    where: str
    typical: float


@dataclass(frozen=True)
class AngleReading:
    """L*a*b* (D65, 10°) at one geometry, None where nothing was measured; ΔE00 of fit and of reference to it."""

    geometry: Geometry
    lab: Lab | None
    delta_e_fit: float | None = None
    delta_e_reference: float | None = None


@dataclass(frozen=True, eq=False)
class ReflectanceFigures:
    """All figures of one reflectance. ``missing`` is the share of even pairs of directions without a number."""

    curve: AlbedoCurve
    reciprocity: Reciprocity
    readings: tuple[AngleReading, ...]
    geometry_set: GeometrySet
    azimuth_deg: float
    missing: float
    fit: Errors | None = None
    reference: Errors | None = None


@dataclass(frozen=True, eq=False)
class FiguresRequest:
    """What figures are wanted of: a reflectance, its fit, and what it is compared with, as light comes from an azimuth.

    ``azimuth_deg`` is that of the plane of incidence; of an isotropic reflectance nothing depends on it.
    """

    reflectance: Reflectance
    fit: Reflectance | None = None
    reference: Reflectance | None = None
    azimuth_deg: float = 0.0
    isotropic: bool = True
    geometry_set: GeometrySet = GEOMETRY_SETS[DEFAULT_SET]


def reflectance_figures(request: FiguresRequest, progress: Progress | None = None) -> ReflectanceFigures:
    """Return all figures; :class:`~brdf_suite.errors.Cancelled` where the progress callback asks for it."""
    whole = turned(request.reflectance, request.azimuth_deg)
    known = OnlyNumbers(whole)
    albedo = []
    for place, incidence in enumerate(INCIDENCES_DEG):
        report(progress, 0.7 * place / len(INCIDENCES_DEG), "albedo")
        azimuths = _AZIMUTHS if request.isotropic else _AZIMUTHS_ANISOTROPIC
        albedo.append(directional_albedo(known, illumination(incidence), azimuths))
    report(progress, 0.7, "reciprocity")
    worst, where, typical = reciprocity(_InBothOrders(whole))
    report(progress, 0.8, "errors")
    fit = None if request.fit is None else turned(request.fit, request.azimuth_deg)
    reference = None if request.reference is None else turned(request.reference, request.azimuth_deg)
    readings = angle_readings(whole, fit, reference, request.geometry_set)
    return ReflectanceFigures(
        AlbedoCurve(np.array(INCIDENCES_DEG), np.array(albedo)),
        Reciprocity(worst, where if worst else "", typical),
        readings,
        request.geometry_set,
        request.azimuth_deg,
        missing_share(whole),
        None if fit is None else fit_errors(whole, fit),
        None if reference is None else errors_between(reference, whole),
    )


def turned(reflectance: Reflectance, azimuth_deg: float) -> Reflectance:
    """Return the reflectance as it is where the plane of incidence has that azimuth, degrees."""
    return reflectance if azimuth_deg == 0.0 else Turned(reflectance, math.radians(azimuth_deg))


def missing_share(reflectance: Reflectance) -> float:
    """Return the share, 0 to 1, of even pairs of directions at which there is no number."""
    wi, wo = even_pairs()
    return float(np.mean(~np.isfinite(reflectance.eval(wi, wo)).all(axis=-1)))


@dataclass(frozen=True, eq=False)
class OnlyNumbers:
    """A reflectance with 0 where the inner one has no finite number."""

    inner: Reflectance

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, always finite."""
        value = np.asarray(self.inner.eval(wi, wo))
        return value if np.isfinite(value).all() else np.where(np.isfinite(value), value, 0.0)


@dataclass(frozen=True, eq=False)
class _InBothOrders:
    """A reflectance with 0 where a pair or its swap has no finite number, so that holes are no lack of reciprocity."""

    inner: Reflectance

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, always finite."""
        value = np.asarray(self.inner.eval(wi, wo))
        if np.isfinite(value).all() and np.isfinite(other := np.asarray(self.inner.eval(wo, wi))).all():
            return value
        other = np.asarray(self.inner.eval(wo, wi))
        return np.where(np.isfinite(value) & np.isfinite(other), value, 0.0)


def angle_readings(
    whole: Reflectance, fit: Reflectance | None, reference: Reflectance | None, angles: GeometrySet
) -> tuple[AngleReading, ...]:
    """Return the colour at every geometry, and ΔE00 of fit and of reference to it; azimuth 0."""
    lights = illumination([g.illumination_deg for g in angles.geometries])
    views = aspecular_view(
        [g.illumination_deg for g in angles.geometries], [g.aspecular_deg for g in angles.geometries]
    )
    own, of_fit, of_reference = (
        None if r is None else np.asarray(r.eval(lights, views)) for r in (whole, fit, reference)
    )
    found = []
    for place, geometry in enumerate(angles.geometries):
        lab = _lab(own, place)
        found.append(
            AngleReading(
                geometry,
                lab,
                _delta_e(_lab(of_fit, place), lab),
                _delta_e(_lab(of_reference, place), lab),
            )
        )
    return tuple(found)


def _lab(values: Floats | None, place: int) -> Lab | None:
    if values is None or not np.isfinite(values[place]).all():
        return None
    lightness, a, b = working_to_lab(math.pi * values[place])
    return float(lightness), float(a), float(b)


def _delta_e(one: Lab | None, other: Lab | None) -> float | None:
    return None if one is None or other is None else float(delta_e_2000(one, other))
