"""How far one reflectance is from another, over all directions: the worst, the root mean square, the cube roots'.

Over the pairs of :func:`~brdf_suite.pipeline.fit_errors.hemisphere_pairs`; pairs where either has no number are left
out. A coat's lobe outweighs all else by 10⁴, so the same is said once more without the views within 5° of the light's
mirror direction.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import cache

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import angle_between, mirror
from brdf_suite.pipeline.fit_errors import NEAR_MIRROR_DEG, hemisphere_pairs
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


def fit_errors(target: Reflectance, fit: Reflectance) -> Errors:
    """Return the errors of a fit; its target comes first."""
    return errors_between(target, fit)


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
