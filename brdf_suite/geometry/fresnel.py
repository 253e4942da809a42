"""Fresnel's equations for an interface between air and a clear dielectric, unpolarised light.

With c = cos θ outside and t = cos θ' = √(1 - (1 - c²)/n²) inside (Snell),

    r_s = (c - n t) / (c + n t),    r_p = (n c - t) / (n c + t),    F = (r_s² + r_p²) / 2.

Born and Wolf, Principles of Optics, section 1.5.
"""

from __future__ import annotations

import math

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats


def fresnel_dielectric(cos_theta: npt.ArrayLike, ior: float) -> Floats:
    """Return the reflected share F (...), 0 to 1, at ``cos_theta`` (outside, clipped to 0…1) for ``ior`` ≥ 1.

    >>> round(float(fresnel_dielectric(1.0, 1.5)), 6)
    0.04
    """
    if ior == 1.0:  # there is no interface; at grazing the formula is 0/0
        return np.zeros(np.shape(cos_theta))
    if np.ndim(cos_theta) == 0:
        # One light of an edit: plain numbers are ten times as fast as arrays of one, and round alike.
        return np.asarray(_of_number(min(max(float(cos_theta), 0.0), 1.0), ior))  # type: ignore[arg-type] # of no dimension
    # np.clip would take as long as the rest of it for the few values of an edit.
    c = np.minimum(np.maximum(np.asarray(cos_theta, float), 0.0), 1.0)
    t = np.sqrt(1.0 - (1.0 - c * c) * (1.0 / (ior * ior)))
    nt, nc = ior * t, ior * c
    r_s, r_p = (c - nt) / (c + nt), (nc - t) / (nc + t)
    return np.asarray(0.5 * (r_s * r_s + r_p * r_p))


def _of_number(c: float, ior: float) -> float:
    t = math.sqrt(1.0 - (1.0 - c * c) * (1.0 / (ior * ior)))
    nt, nc = ior * t, ior * c
    r_s, r_p = (c - nt) / (c + nt), (nc - t) / (nc + t)
    return 0.5 * (r_s * r_s + r_p * r_p)


def sheet_reflectance(cos_theta: npt.ArrayLike, ior: float) -> Floats:
    """Return what a clear thin sheet mirrors from both of its faces together, again and again: 2 F / (1 + F).

    >>> round(float(sheet_reflectance(1.0, 1.5)), 4)
    0.0769
    """
    f = fresnel_dielectric(cos_theta, ior)
    return np.asarray(2.0 * f / (1.0 + f))


def fresnel_at(theta_deg: float, ior: float) -> float:
    """Return F for one angle in degrees; a plain number, for solvers that need it many times."""
    c = math.cos(math.radians(theta_deg))
    t = math.sqrt(1.0 - (1.0 - c * c) / (ior * ior))
    r_s = (c - ior * t) / (c + ior * t)
    r_p = (ior * c - t) / (ior * c + t)
    return 0.5 * (r_s * r_s + r_p * r_p)
