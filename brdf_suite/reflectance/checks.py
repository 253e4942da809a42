"""Physical plausibility checks of a reflectance: reciprocity, non-negativity, energy conservation.

The checks measure; what a model declares of itself (``reciprocal``, ``energy_conserving``) decides whether a
violation is a fault or a known property, and then its size is what is reported. A reflectance that declares
nothing, a measured table for one, is only measured. All are deterministic.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import asdict, dataclass
from functools import cache
from typing import Literal

import numpy as np

from brdf_suite.arrays import Floats
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import illumination, mirror, spherical
from brdf_suite.reflectance.albedo import directional_albedo, white_furnace
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.registry import ModelEntry

INCIDENCE_DEG = (0.0, 15.0, 30.0, 45.0, 60.0, 75.0, 85.0, 89.0)
"""Where the directional albedo is measured, polar angles in degrees."""

RECIPROCITY_TOLERANCE = 1e-6
"""Relative; two evaluations of one formula differ by rounding only."""
ENERGY_TOLERANCE = 0.005
"""Of the light that arrives; what the quadrature is sure of."""

_FEWEST_AZIMUTHS, _MOST_AZIMUTHS = 64, 512
_SETTLED = 0.2 * ENERGY_TOLERANCE

_PAIRS = 4096
_SEED = 20_05

Outcome = Literal["held", "violated", "known violator", "declared, not seen", "measured"]


@dataclass(frozen=True)
class CheckFinding:
    """Result of one check: ``size`` of the largest violation (0: none), its place, and its meaning.

    ``typical`` is the median over even pairs of directions, where that says more than the worst, else None.
    ``outcome`` is ``held`` or ``violated`` where the property is claimed, ``known violator`` or ``declared, not
    seen`` where it is disclaimed, ``measured`` where nothing is declared.
    """

    check: str
    size: float
    unit: str
    where: str
    outcome: Outcome
    typical: float | None = None

    @property
    def passed(self) -> bool:
        """Return False where a claimed property is violated."""
        return self.outcome != "violated"


@dataclass(frozen=True)
class CheckReport:
    """All findings about one reflectance, and its albedo (k, 3) at ``incidence_deg``."""

    name: str
    findings: tuple[CheckFinding, ...]
    incidence_deg: tuple[float, ...]
    albedo: Floats
    furnace: Floats

    @property
    def passed(self) -> bool:
        """Return whether every claimed property held."""
        return all(finding.passed for finding in self.findings)

    def to_json(self) -> dict[str, object]:
        """Return everything as plain values, as JSON holds them.

        >>> import brdf_suite as bs
        >>> bs.check("blue").to_json()["passed"]
        True
        """
        return {
            "name": self.name,
            "passed": self.passed,
            "findings": [{**asdict(finding), "passed": finding.passed} for finding in self.findings],
            "albedo": [
                {
                    "illumination_deg": angle,
                    "directional_albedo": light.tolist(),
                    "white_furnace": view.tolist(),
                }
                for angle, light, view in zip(self.incidence_deg, self.albedo, self.furnace, strict=True)
            ],
        }


def reciprocity(reflectance: Reflectance) -> tuple[float, str, float]:
    """Return the largest |f(i,o) - f(o,i)| / max(f(i,o), f(o,i)), 0 to 1, where it is, and its median."""
    wi, wo = _pairs()
    there, back = reflectance.eval(wi, wo), reflectance.eval(wo, wi)
    larger = np.maximum(np.abs(there), np.abs(back))
    # A value below this is darkness by any measure; its rounding is of no interest.
    error = np.where(larger > 1e-12, np.abs(there - back) / np.maximum(larger, 1e-12), 0.0)
    worst = error.max(axis=-1)
    # The even pairs come first.
    return *_worst(worst, wi, wo), float(np.median(worst[:_PAIRS]))


def negativity(reflectance: Reflectance) -> tuple[float, str]:
    """Return how far below 0 the reflectance goes, in 1/sr, and where; infinite where it is not finite."""
    wi, wo = _pairs()
    value = reflectance.eval(wi, wo)
    below = np.where(np.isfinite(value), np.maximum(-value, 0.0), math.inf)
    return _worst(below.max(axis=-1), wi, wo)


def check_reflectance(
    reflectance: Reflectance,
    name: str,
    *,
    reciprocal: bool | None = None,
    energy_conserving: bool | None = None,
    incidence_deg: tuple[float, ...] = INCIDENCE_DEG,
) -> CheckReport:
    """Return the report on a reflectance.

    Parameters
    ----------
    reciprocal, energy_conserving
        What is claimed; None: what the reflectance declares itself, if anything. Where reciprocity is claimed and
        held, the white furnace is the directional albedo, to the tolerance, and is not integrated again.
    """
    if reciprocal is None:
        reciprocal = getattr(reflectance, "reciprocal", None)
    if energy_conserving is None:
        energy_conserving = getattr(reflectance, "energy_conserving", None)
    size, where = negativity(reflectance)
    verdict = _outcome(size > 0.0, True)
    findings = [CheckFinding("non_negativity", size, "1/sr", where if size else "", verdict)]
    size, where, typical = reciprocity(reflectance)
    verdict = _outcome(size > RECIPROCITY_TOLERANCE, reciprocal)
    findings.append(CheckFinding("reciprocity", size, "relative", where, verdict, typical))
    light = illumination(np.array(incidence_deg))
    albedo = _settled(directional_albedo, reflectance, light)
    # Where light and view may be exchanged both integrals are one.
    exchanged = reciprocal is True and size <= RECIPROCITY_TOLERANCE
    furnace = albedo if exchanged else _settled(white_furnace, reflectance, light)
    for check, table, fixed in (("directional_albedo", albedo, "light"), ("white_furnace", furnace, "view")):
        row, channel = np.unravel_index(int(np.argmax(table)), table.shape)
        excess = max(float(table[row, channel]) - 1.0, 0.0)
        place = f"{fixed} at {incidence_deg[row]:g}°, {('red', 'green', 'blue')[channel]}"
        verdict = _outcome(excess > ENERGY_TOLERANCE, energy_conserving)
        findings.append(CheckFinding(check, excess, "of the light", place, verdict))
    return CheckReport(name, tuple(findings), incidence_deg, albedo, furnace)


def _settled(
    integral: Callable[[Reflectance, Floats, int, float], Floats], reflectance: Reflectance, light: Floats
) -> Floats:
    """Return an albedo (k, 3), with more azimuths at each direction until more of them change nothing.

    The integrals' rings follow a highlight at the mirror direction; a peak elsewhere, as of a tape that sends light
    back to the lamp, falls between few azimuths.
    """
    few = integral(reflectance, light, _FEWEST_AZIMUTHS, 0.5)
    found: Floats = 0.5 * (few + integral(reflectance, light, _FEWEST_AZIMUTHS, 0.0))
    for row, direction in enumerate(light):
        azimuths, change = 2 * _FEWEST_AZIMUTHS, float(np.abs(found[row] - few[row]).max())
        while change > _SETTLED and azimuths < _MOST_AZIMUTHS:  # nor does it settle where it is not a number
            azimuths *= 2
            finer = integral(reflectance, direction, azimuths, 0.5)
            change = float(np.abs(finer - found[row]).max())
            found[row] = finer
    return found


def check_model(entry: ModelEntry) -> CheckReport:
    """Return the report on a registered model's example, by what its entry claims."""
    return check_reflectance(
        entry.default,
        entry.name,
        reciprocal=entry.reciprocal,
        energy_conserving=entry.energy_conserving,
    )


def _outcome(broken: bool, claimed: bool | None) -> Outcome:
    if claimed is None:
        return "measured"
    if claimed:
        return "violated" if broken else "held"
    return "known violator" if broken else "declared, not seen"


@cache
def _pairs() -> tuple[Floats, Floats]:
    """Pairs of directions (n, 3): even ones, some near the mirror direction, some near grazing, some in one plane."""
    random = np.random.default_rng(_SEED)
    even = warps.cosine_hemisphere(random.random((2, _PAIRS, 2)))
    # The half vector of these lies within the narrowest coat lobe to the widest.
    light = warps.cosine_hemisphere(random.random((_PAIRS, 2)))
    away = 10.0 ** random.uniform(-3.5, -0.3, _PAIRS)
    near = mirror(light) + away[:, None] * random.normal(size=(_PAIRS, 3))
    near /= np.linalg.norm(near, axis=-1, keepdims=True)
    low = spherical(
        0.5 * math.pi - 10.0 ** random.uniform(-4.0, -0.7, (2, _PAIRS)),
        random.uniform(-3.1, 3.1, (2, _PAIRS)),
    )
    polar = random.uniform(-1.55, 1.55, (2, _PAIRS))
    plane = np.stack((np.sin(polar), np.zeros_like(polar), np.cos(polar)), axis=-1)
    light, view = (np.concatenate(side) for side in zip(even, (light, near), low, plane, strict=True))
    up = (light[:, 2] > 0.0) & (view[:, 2] > 0.0)
    return light[up], view[up]


def _worst(size: Floats, wi: Floats, wo: Floats) -> tuple[float, str]:
    index = int(np.argmax(size))
    angles = [
        (math.degrees(math.acos(min(1.0, w[2]))), math.degrees(math.atan2(w[1], w[0])))
        for w in (wi[index], wo[index])
    ]
    (theta_i, phi_i), (theta_o, phi_o) = angles
    where = f"light at ({theta_i:.1f}°, {phi_i:.0f}°), view at ({theta_o:.1f}°, {phi_o:.0f}°) polar, azimuth"
    return float(size[index]), where
