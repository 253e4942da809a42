"""What is said of any reflectance in numbers: albedo over incidence, reciprocity, energy, colours at aspecular angles.

A value that is not a number (a hole of a measurement) is left out and counted, so that a table with holes has figures.

How far one reflectance is from another is said over :func:`~brdf_suite.pipeline.fit_errors.hemisphere_pairs` without
pairs where either has no number. A coat's lobe outweighs all else by 10⁴, so the same is said once more without the
views within 5° of the light's mirror direction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.appearance.geometries import DEFAULT_SET, GEOMETRY_SETS, Geometry, GeometrySet
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Lab
from brdf_suite.geometry.directions import angle_between, aspecular_view, illumination, mirror
from brdf_suite.pipeline.fit_errors import NEAR_MIRROR_DEG, hemisphere_pairs
from brdf_suite.progress import Progress, report
from brdf_suite.reflectance.albedo import directional_albedo
from brdf_suite.reflectance.checks import reciprocity
from brdf_suite.reflectance.isotropy import Turned, even_pairs
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True)
class ErrorSet:
    """Errors over one set of directions, means over the channels inside the sums, 0 for equal reflectances.

    ``worst`` the largest ``|f - f̂|·cosθi``, 1/sr; ``rms`` ``√(Σw cos²θi (f - f̂)²/Σw)``, 1/sr; ``relative_rms`` is it
    over that of ``f`` itself; ``cube_root_rms`` as ``rms`` of ``f^⅓``.
    """

    worst: float
    rms: float
    relative_rms: float
    cube_root_rms: float


@dataclass(frozen=True)
class Errors:
    """Errors over all views, and away from the mirror direction; ``where`` says where the worst is.

    ``share`` of the pairs, 0 to 1, had a number in both.
    """

    whole: ErrorSet
    away: ErrorSet
    where: str
    share: float


def errors_between(reference: Reflectance, other: Reflectance) -> Errors:
    """Return how far ``other`` is from ``reference``; all 0, of no share, where no pair has numbers in both."""
    wi, wo, weight, near = _pairs()
    wanted, given = np.asarray(reference.eval(wi, wo)), np.asarray(other.eval(wi, wo))
    known = np.asarray(np.isfinite(wanted).all(axis=-1) & np.isfinite(given).all(axis=-1))
    wanted, given = np.where(known[:, None], wanted, 0.0), np.where(known[:, None], given, 0.0)
    cosine = wi[:, 2:3]
    size = np.abs(wanted - given) * cosine
    row = int(np.argmax(size.max(axis=-1)))
    return Errors(
        _set(wanted, given, cosine, np.where(known, weight, 0.0)),
        _set(wanted, given, cosine, np.where(known & ~near, weight, 0.0)),
        _place(wi[row], wo[row]) if size.max() > 0.0 else "",
        float(known.mean()),
    )


def _set(wanted: Floats, given: Floats, cosine: Floats, weight: Floats) -> ErrorSet:
    total = 3.0 * float(weight.sum())
    if total == 0.0:
        return ErrorSet(0.0, 0.0, 0.0, 0.0)

    def rms(difference: Floats) -> float:
        return math.sqrt(float((weight[:, None] * difference**2).sum()) / total)

    size, error = rms(cosine * wanted), rms(cosine * (wanted - given))
    used = weight > 0.0
    return ErrorSet(
        float((np.abs(wanted - given) * cosine)[used].max()),
        error,
        error / size if size > 0.0 else (0.0 if error == 0.0 else math.inf),
        rms(cosine * (np.cbrt(wanted) - np.cbrt(given))),
    )


@cache
def _pairs() -> tuple[Floats, Floats, Floats, npt.NDArray[np.bool_]]:
    wi, wo, weight = hemisphere_pairs()
    near = np.asarray(angle_between(mirror(wi), wo) < math.radians(NEAR_MIRROR_DEG))
    return wi, wo, weight, near


def _place(wi: Floats, wo: Floats) -> str:
    light, view = (math.degrees(math.acos(min(1.0, float(w[2])))) for w in (wi, wo))
    azimuth = math.degrees(math.atan2(wo[1], wo[0]) - math.atan2(-wi[1], -wi[0]))
    return f"light at {light:.0f}°, view at {view:.0f}°, {(azimuth + 180.0) % 360.0 - 180.0:.0f}° out of the plane"


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
        return float(self.albedo[row, channel]), float(self.incidence_deg[row]), CHANNELS[channel]


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
        float(np.mean(~np.isfinite(whole.eval(*even_pairs())).all(axis=-1))),
        None if fit is None else errors_between(whole, fit),
        None if reference is None else errors_between(reference, whole),
    )


def turned(reflectance: Reflectance, azimuth_deg: float) -> Reflectance:
    """Return the reflectance as it is where the plane of incidence has that azimuth, degrees."""
    return reflectance if azimuth_deg == 0.0 else Turned(reflectance, math.radians(azimuth_deg))


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
        lab, *others = (_lab(values, place) for values in (own, of_fit, of_reference))
        found.append(AngleReading(geometry, lab, *(_delta_e(other, lab) for other in others)))
    return tuple(found)


def _lab(values: Floats | None, place: int) -> Lab | None:
    if values is None or not np.isfinite(values[place]).all():
        return None
    lightness, a, b = working_to_lab(math.pi * values[place])
    return float(lightness), float(a), float(b)


def _delta_e(one: Lab | None, other: Lab | None) -> float | None:
    return None if one is None or other is None else float(delta_e_2000(one, other))
