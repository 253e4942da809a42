"""Error figures of fits as quoted by the suite.

The target is a reflectance (anything with ``eval``), the fit a
:class:`~brdf_suite.fitting.lobes.weights.LobeWeights`; both give f_r in 1/sr, linear Rec. 2020.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from brdf_suite.appearance.colour.colorimetry import working_to_lab
from brdf_suite.appearance.difference.formulas import delta_e_2000
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Lab
from brdf_suite.geometry.directions import aspecular_view, illumination
from brdf_suite.reflectance.protocol import Reflectance


@dataclass(frozen=True)
class ErrorFigures:
    """Errors over an angle set: all are 0 for a perfect fit.

    ``cosine_rms`` ``√(Σw cos²θi (f-f̂)²/Σw)`` in 1/sr; ``cube_root_rms`` the same over ``f^⅓``; ``log_rms``
    the RMS of the difference of ``ln(1 + f cosθi)``. Means over the three channels are inside the sums.
    """

    cosine_rms: float
    cube_root_rms: float
    log_rms: float


@dataclass(frozen=True)
class AngleError:
    """L*a*b* (D65, 10°) of data and lobes in one geometry, and ΔE00; ``fitted``: the fit looked there."""

    illumination_deg: float
    aspecular_deg: float
    lab: Lab
    lab_fitted: Lab
    delta_e_2000: float
    fitted: bool = True


@dataclass(frozen=True)
class HeldOut:
    """Errors where the fit did not look.

    ``where`` says where that is; ``figures`` are of all of it, ``relative_rms`` is ``cosine_rms`` over the
    cosine-weighted RMS of the data themselves, ``away`` leaves out views within 5° of the mirror direction.
    """

    where: str
    pairs: int
    figures: ErrorFigures
    relative_rms: float
    away: ErrorFigures | None


def aspecular_lab(
    reflectance: Reflectance, aspecular_deg: Sequence[float], illumination_deg: float = 45.0
) -> Floats:
    """Return the L*a*b* (D65, 10°) ``(k, 3)`` that an instrument reads at aspecular angles, in degrees."""
    wi = illumination(illumination_deg)
    wo = aspecular_view(illumination_deg, np.asarray(aspecular_deg, np.float64))
    return working_to_lab(np.pi * reflectance.eval(wi, wo))


def aspecular_delta_e(
    target: Reflectance, fit: Reflectance, aspecular_deg: Sequence[float], illumination_deg: float = 45.0
) -> Floats:
    """Return ΔE00 ``(k,)`` between target and fit at aspecular angles, in degrees."""
    return delta_e_2000(*(aspecular_lab(one, aspecular_deg, illumination_deg) for one in (target, fit)))


def error_figures(
    target: Reflectance, fit: Reflectance, wi: Floats, wo: Floats, solid_angle: Floats
) -> ErrorFigures:
    """Return the errors over directions ``wi``, ``wo`` ``(k, 3)``, weights ``solid_angle`` ``(k,)`` in sr.

    Give directions that were not used in the fit.
    """
    return value_errors(target.eval(wi, wo), fit.eval(wi, wo), wi, solid_angle)


def value_errors(wanted: Floats, given: Floats, wi: Floats, solid_angle: Floats) -> ErrorFigures:
    """Return :func:`error_figures` of values ``(k, 3)`` that are known already."""
    cosine = np.clip(np.asarray(wi)[..., 2], 0.0, None)[..., None]
    weight = np.broadcast_to(solid_angle[..., None], wanted.shape)

    def rms(difference: Floats) -> float:
        return float(np.sqrt((weight * difference**2).sum() / weight.sum()))

    return ErrorFigures(
        cosine_rms=rms(cosine * (wanted - given)),
        cube_root_rms=rms(cosine * (np.cbrt(wanted) - np.cbrt(given))),
        log_rms=rms(np.log1p(wanted * cosine) - np.log1p(given * cosine)),
    )
