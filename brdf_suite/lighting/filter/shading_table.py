"""Look-up parameters of a lobe times a cosine: direction, exponent and amplitude, by least squares over the sphere.

A surface with normal N, seen along R's mirror image, reflects ``∫ L(ω) T(ω) dω`` of a lobe of exponent E, where T is

- ``plain``: ``max(0, N·ω) (R·ω)^E``, a directional-diffuse lobe as the lobe sum has it;
- ``coated``: the same times ``(1 - F(N·ω)) / (1 - F(45°))``: the light of a base crosses the coat on its way in, less
  of it the lower it stands. The lobe sum is silent about that; weights are fitted at 45°;
- ``gloss``: ``(R·ω)^E`` above the horizon, 0 below.

Each is close to one cosine lobe A·P_e(d), P_e of unit gain, with d between N and R, ``d ∝ R + b N``. A is the integral
of T, so constant light comes out exactly. b and e minimize the expected square of the error in light whose power per
degree falls as it does in pictures of surroundings (:func:`typical_power`). For R = N the plain lobe *is* the lobe of
exponent E + 1. Over the cosine c = N·R, b is a polynomial of second order; e and A are tabulated over √c.
"""

from __future__ import annotations

from typing import Any, Literal

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.lighting.filter.harmonics import COAT_IOR, coat_crossing, lobe_coefficients
from brdf_suite.progress import Progress, report

Target = Literal["plain", "coated", "gloss"]
TARGETS: tuple[Target, ...] = ("plain", "coated", "gloss")

EXPONENTS: tuple[float, ...] = tuple(float(2.0 ** (i / 2)) for i in range(17))
ROOTS = 33
"""Cosines (i / 32)², i = 0 … 32: dense at grazing, where all turns fast."""

_DEGREES = 48
_MU, _PHI = 96, 192
_ANGLES = 361
_LOWEST, _HIGHEST, _STEPS = 0.5, 900.0, 400
_LOWEST_COSINE = 1e-3


def typical_power(degrees: int) -> Floats:
    """Return the power per degree l = 0 … ``degrees`` of typical light over that of its mean.

    0.15 l^-1.1 is about the course of the geometric mean over nine environments, rooms and skies.
    """
    l = np.maximum(np.arange(degrees + 1), 1)  # noqa: E741  (the degree has this name everywhere)
    power: Floats = 0.15 * l**-1.1
    power[0] = 1.0
    return power


class LeastSquares:
    """Tables of one sphere, with the least-squares look-up for a target."""

    def __init__(self) -> None:
        from scipy.special import sph_legendre_p_all  # only this search needs it

        x, weights = np.polynomial.legendre.leggauss(_MU)
        self.mu: Floats = (x + 1.0) / 2.0  # the half sphere above the surface
        self.weights: Floats = weights / 2.0
        phi = (np.arange(_PHI) + 0.5) * np.pi / _PHI
        sine = np.sqrt(1.0 - self.mu**2)
        self.across: Floats = sine[:, None] * np.cos(phi)  # the component along the plane of incidence
        orders = np.arange(_DEGREES + 1)
        # Functions are even about the plane of incidence: cosines of the azimuth, both halves at once.
        norm = np.where(orders == 0, 1.0, np.sqrt(2.0))
        self._cosines: Floats = np.cos(np.outer(phi, orders)) * (2.0 * np.pi / _PHI * norm)
        self._legendre: Floats = sph_legendre_p_all(_DEGREES, _DEGREES, np.arccos(self.mu))[
            0, :, : _DEGREES + 1
        ]
        self.angles: Floats = np.linspace(0.0, np.pi / 2.0, _ANGLES)
        self._at_angles: Floats = (
            sph_legendre_p_all(_DEGREES, _DEGREES, self.angles)[0, :, : _DEGREES + 1] * norm[:, None]
        )
        self.exponents: Floats = np.geomspace(_LOWEST, _HIGHEST, _STEPS)
        lobes = np.stack([lobe_coefficients(e, _DEGREES) for e in self.exponents], axis=1)
        power = typical_power(_DEGREES)[:, None]
        degrees = 2.0 * np.arange(_DEGREES + 1)[:, None] + 1.0
        self._weighted: Floats = power * lobes
        self._squares: Floats = (power * lobes**2 * degrees / (4.0 * np.pi)).sum(axis=0)

    def values(self, target: Target, exponent: float, cosine: float) -> Floats:
        """Return T on the half sphere (96, 192)."""
        sine = np.sqrt(1.0 - cosine * cosine)
        lobe = np.maximum(self.across * sine + self.mu[:, None] * cosine, 0.0) ** exponent
        if target == "gloss":
            return np.asarray(lobe)
        lobe = lobe * self.mu[:, None]
        if target == "coated":
            lobe = lobe * coat_crossing(self.mu)[:, None]
        return np.asarray(lobe)

    def gain(self, values: Floats) -> tuple[Floats, float]:
        """Return what (361 angles from the normal, 400 exponents) each look-up leaves of the error, negated, and A."""
        orders = values @ self._cosines
        coefficients = np.einsum("lmu,um,u->lm", self._legendre, orders, self.weights)
        amplitude = float(coefficients[0, 0] * np.sqrt(4.0 * np.pi))
        along = np.einsum("lm,lmt->lt", coefficients, self._at_angles)
        gain: Floats = 2.0 * along.T @ self._weighted - amplitude * self._squares
        return gain, amplitude


def shading_table(progress: Progress | None = None) -> dict[str, Any]:
    """Return the table as plain values: by target and exponent ``toward_normal`` (3), ``exponent``, ``amplitude``.

    ``toward_normal`` holds b's coefficients of c⁰, c¹, c²; ``exponent`` and ``amplitude`` are at ``cosines``.
    ``diffuse`` is the look-up of ``N·ω`` times the coat's crossing, at N itself.
    """
    search = LeastSquares()
    cosines = (np.arange(ROOTS) / (ROOTS - 1)) ** 2
    targets: dict[str, object] = {}
    for step, target in enumerate(TARGETS):
        rows = []
        for index, exponent in enumerate(EXPONENTS):
            report(
                progress,
                (step + index / len(EXPONENTS)) / len(TARGETS),
                f"{target} lobe of exponent {exponent:.3g}",
            )
            rows.append(lobe_row(search, target, exponent, cosines))
        targets[target] = rows
    report(progress, 1.0, "the table is made")
    gain, amplitude = search.gain(np.tile((search.mu * coat_crossing(search.mu))[:, None], (1, _PHI)))
    return {
        "kind": "shading-table",
        "version": 1,
        "coat_ior": COAT_IOR,
        "exponents": list(EXPONENTS),
        "cosines": cosines.tolist(),
        "targets": targets,
        "diffuse": {"exponent": _rounded(_peak(search.exponents, gain[0])), "amplitude": _rounded(amplitude)},
    }


def lobe_row(search: LeastSquares, target: Target, exponent: float, cosines: Floats) -> dict[str, Any]:
    """Return one lobe's row of the table, at ``cosines`` (n,)."""
    held = np.maximum(cosines, _LOWEST_COSINE)
    found = [search.gain(search.values(target, exponent, float(c))) for c in held]
    sines = np.sqrt(1.0 - held**2)
    angles = np.array([_peak(search.angles, gain.max(axis=1), log=False) for gain, _ in found])
    # d = R + b N stands at the angle t from N where tan t = sinθ / (cosθ + b).
    tilted = (sines > 0.05) & (angles > 1e-3)
    b = sines[tilted] / np.tan(angles[tilted]) - held[tilted]
    # An error of b turns d by sin²t / sinθ times as much; where R is all but N, b says little.
    sensitivity = np.sin(angles[tilted]) ** 2 / sines[tilted]
    powers = np.stack([np.ones_like(b), held[tilted], held[tilted] ** 2], axis=1)
    polynomial = np.linalg.lstsq(powers * sensitivity[:, None], b * sensitivity, rcond=None)[0]
    toward = np.maximum(polynomial @ np.stack([np.ones_like(held), held, held**2]), 0.0)
    angles = np.arctan2(sines, held + toward)
    exponents = []
    for angle, (gain, _) in zip(angles, found, strict=True):
        place = angle / search.angles[1]
        low = min(int(place), _ANGLES - 2)
        share = place - low
        exponents.append(_peak(search.exponents, (1.0 - share) * gain[low] + share * gain[low + 1]))
    return {
        "toward_normal": [_rounded(float(p)) for p in polynomial],
        "exponent": [_rounded(e) for e in exponents],
        "amplitude": [_rounded(amplitude) for _, amplitude in found],
    }


def _peak(places: Floats, values: Floats, *, log: bool = True) -> float:
    """Return where ``values`` are largest, between the places by a parabola; ``log``: even in the logarithm."""
    at = int(np.clip(values.argmax(), 1, len(values) - 2))
    before, here, after = values[at - 1 : at + 2]
    bend = before - 2.0 * here + after
    shift = float(np.clip(0.5 * (before - after) / bend, -1.0, 1.0)) if bend < 0.0 else 0.0
    if log:
        return float(places[at] * (places[1] / places[0]) ** shift)
    return float(max(places[at] + shift * (places[1] - places[0]), 0.0))


def _rounded(value: float) -> float:
    return float(f"{value:.6g}")
