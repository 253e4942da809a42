"""Precomputed table of a material's lobe weights over N·V.

A picture knows, at a pixel, the cosine N·V = N·R and nothing else of the angles. Weights, Fresnel's gains, amplitude
and exponent of each look-up depend on it alone. So they are computed here at 64 cosines, in 0.1 ms an edit, and the
shader reads one row of a texture for each look-up: modes of Fresnel and of the look-up differ in these numbers only.

Rows: 0 the diffuse look-up, 1 to 8 the sharp lobes, from 9 on the base's and then the coat's broad lobes. Red, green,
blue are the weight; alpha is the third coordinate in the stack of broad lobes. What is not used weighs nothing.
"""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import NDArray

from brdf_suite.arrays import Floats
from brdf_suite.documents.view import FresnelMode
from brdf_suite.documents.view import LookUp as LookUpMode
from brdf_suite.errors import GraphicsError, ValueRangeError
from brdf_suite.geometry.fresnel import fresnel_dielectric, sheet_reflectance
from brdf_suite.realtime.environment.ladder import BROADEST_SHARP, Ladder
from brdf_suite.realtime.environment.look_up_table import (
    RAMP_COSINES,
    RAMP_NODES,
    TURNS,
    LookUpTable,
    Target,
    Turn,
    direction,
    look_up_table,
)
from brdf_suite.realtime.values import MaterialWeights, WeightsOverAngle

MAX_BROAD = 24
MAX_SHARP = 8
MAX_ROWS = 1 + MAX_SHARP + MAX_BROAD
_WRITTEN = 8
"""Broad look-ups that are written at least: a program may look up more than a material has."""

#: View of the reading at γ = 110°, radians, and how much of what it lost constant light shows (64, 1).
_LOW_READING = math.radians(65.0)
_RISE: Floats = (0.42 * (1.0 - RAMP_COSINES) ** 1.5)[:, None]

#: R itself: b is 0, and R has its own sign.
_UNSHIFTED: Floats = np.array([0.0, 0.0, 0.0, 1.0])

NEGLIGIBLE = 1e-6
"""A lobe that reflects less than this share of what the material does in constant light is left out."""


@dataclass(frozen=True, eq=False)
class Ramp:
    """Ramp rows ``rows`` (n, 64, 4) float32 and their meaning.

    ``base`` and ``coat`` are the numbers of broad look-ups; ``toward_normal`` (base + coat, 4) holds b's three
    coefficients and the lobe's exponent, negative where the direction is b N - R; ``sharp`` are the exponents of the
    sharp lobes.
    """

    rows: NDArray[np.float32]
    base: int
    coat: int
    toward_normal: NDArray[np.float32]
    sharp: tuple[float, ...]


def make_ramp(
    weights: MaterialWeights,
    fresnel: FresnelMode,
    look_up: LookUpMode,
    ladder: Ladder,
    over_angle: WeightsOverAngle | None = None,
) -> Ramp:
    """Return the ramp of ``weights`` in these modes for a stack of broad lobes.

    ``over_angle``, the material's weights over the incidence, takes the place of the single fit and is never raised on
    top. Without it ``multi_angle`` is ``raised``.
    """
    if over_angle is not None and over_angle.kdd.shape[1] != len(weights.exponents):
        raise ValueRangeError("over_angle", f"expected {len(weights.exponents)} lobes, as in the single fit")
    raised = fresnel != "off" and over_angle is None
    shifted = look_up == "shifted"
    under_coat = shifted and fresnel != "off" and weights.coat == "dielectric" and weights.ior > 1.0
    if over_angle is not None and over_angle is weights.by_view:
        under_coat = over_angle.under_coat
    if over_angle is not None:
        kd, kdd, kg = over_angle.kd, over_angle.kdd, over_angle.kg
        turned = list(zip(TURNS, over_angle.turned, strict=True))
    else:
        kd, kdd, kg, turned = weights.kd[None], weights.kdd[None], weights.kg[None], []
    base_gain, gloss_gain = _gains(weights, under_coat) if raised else (np.ones((1, 1)), np.ones((1, 3)))

    exponents = np.asarray(weights.exponents)
    solid = 2.0 * np.pi / (exponents + 1.0)
    # One axis after the other: both at once take numpy five times as long.
    most = solid * np.array(
        [weight.max(axis=0).max(axis=1) for weight in (kdd, kg, *(weight for _, weight in turned))]
    )
    least = NEGLIGIBLE * (np.pi * float(kd.max()) + float(most.sum()))
    broad = exponents <= BROADEST_SHARP
    base_lobes, gloss_lobes, *turned_lobes = ((broad & found).nonzero()[0] for found in most > least)
    base_count = len(base_lobes) + sum(map(len, turned_lobes))
    count = base_count + len(gloss_lobes)
    sharp_lobes = (~broad & (most[0] + most[1] > least)).nonzero()[0]
    if count > MAX_BROAD or len(sharp_lobes) > MAX_SHARP:
        raise GraphicsError(
            f"A material has weights on {count} broad and {len(sharp_lobes)} sharp lobes; at most "
            f"{MAX_BROAD} and {MAX_SHARP} are drawn. Choose a basis of fewer lobes."
        )

    rows = np.zeros((1 + MAX_SHARP + max(count, _WRITTEN), RAMP_NODES, 4))
    toward = np.zeros((count, 4))
    table = look_up_table()
    under = under_coat
    rows[0, :, :3] = kd * base_gain * (table.diffuse_amplitude if under else np.pi)
    if raised and under:
        rows[0, :, :3] *= _diffuse_rise(weights.theta_fit_rad, weights.ior)
    rows[0, :, 3] = ladder.through_coat if under else ladder.level(1.0)
    base_target: Target = "coated" if under else "plain"
    place = 0
    groups: list[tuple[Target, NDArray[np.intp], Floats, Floats, Turn]] = [
        (base_target, base_lobes, kdd, base_gain, "unturned"),
        *(
            (base_target, lobes, weight, base_gain, turn)
            for (turn, weight), lobes in zip(turned, turned_lobes, strict=True)
        ),
        ("gloss", gloss_lobes, kg, gloss_gain, "unturned"),
    ]
    for target, lobes, weight, gain, turn in groups:
        for lobe in lobes:
            found = _look_up(table if shifted else None, target, float(exponents[lobe]), ladder, turn)
            amplitude, level, toward[place] = found
            row = rows[1 + MAX_SHARP + place]
            row[:, :3] = weight[:, lobe] * gain * amplitude
            row[:, 3] = level
            place += 1
    for place, lobe in enumerate(sharp_lobes, 1):
        exponent = float(exponents[lobe])
        base = _amplitude(base_target, exponent, shifted)
        gloss = _amplitude("gloss", exponent, shifted)
        rows[place, :, :3] = (
            kdd[:, lobe] * base_gain * base[:, None] + kg[:, lobe] * gloss_gain * gloss[:, None]
        )
    return Ramp(
        rows.astype(np.float32),
        base_count,
        len(gloss_lobes),
        toward.astype(np.float32),
        tuple(exponents[sharp_lobes].tolist()),
    )


@lru_cache(maxsize=256)
def _look_up(
    table: LookUpTable | None, target: Target, exponent: float, ladder: Ladder, turn: Turn
) -> tuple[Floats, Floats, Floats]:
    """Return amplitude (64, 1), level (64,) or (), and the row of ``toward_normal`` (4,); none to be written."""
    if table is None:  # the paper's look-ups
        amplitude, level, toward = _amplitude(target, exponent, False), ladder.level(exponent), _UNSHIFTED
    else:
        found = table.find(target, exponent)
        amplitude, level, toward = (
            found.amplitude,
            ladder.level(found.exponent),
            direction(found, exponent, turn),
        )
    return amplitude[:, None], level, toward * np.array([1.0, 1.0, 1.0, exponent])


def _amplitude(target: Target, exponent: float, shifted: bool) -> Floats:
    """Return the look-up's amplitude (64,): from the table, or the paper's N·R (equation 7) and 1 (equation 8)."""
    if shifted:
        return look_up_table().find(target, exponent).amplitude
    solid = 2.0 * np.pi / (exponent + 1.0)
    return solid * (np.ones(RAMP_NODES) if target == "gloss" else RAMP_COSINES)


def _diffuse_rise(theta_fit_rad: float, ior: float) -> Floats:
    """Return by how much the diffuse base under a coat rises towards grazing (64, 1): 3 % with an index of 1.5.

    Light from beside the view comes at large γ, where the base of the aspecular model is brighter by the T that its
    readings, at low views, have lost (docs/method/shading.md). For an index up to about 3, as clearcoats have.
    """
    here, low = (1.0 - float(fresnel_dielectric(math.cos(at), ior)) for at in (theta_fit_rad, _LOW_READING))
    return 1.0 + max(here / low - 1.0, 0.0) * _RISE


def _gains(weights: MaterialWeights, crossing_in_table: bool) -> tuple[Floats, Floats]:
    """Return Fresnel's gains of base (64, 1) and gloss (64, 3) over the incidence of the fit.

    Gloss: F(θ)/F(θ_fit), at most so that constant light comes back whole; that of a metal by Schlick's form. Base
    under a coat: T(θ)²/T(θ_fit)², or T(θ)/T(θ_fit) where the table has the way in.
    """
    base, gloss = np.ones((RAMP_NODES, 1)), np.ones((RAMP_NODES, 3))
    albedo = (weights.kg * (2.0 * np.pi / (np.asarray(weights.exponents) + 1.0))[:, None]).sum(axis=0)
    if weights.coat == "metal":
        g = np.maximum(albedo, 1e-4)
        gloss = (g + np.maximum(1.0 - g, 0.0) * ((1.0 - RAMP_COSINES) ** 5)[:, None]) / g
        return base, gloss
    mirrored = sheet_reflectance if weights.coat == "sheet" else fresnel_dielectric
    at_fit = float(mirrored(np.cos(weights.theta_fit_rad), weights.ior))
    if weights.coat == "none" or at_fit < 1e-6:  # no interface: its ratios would be 0/0
        return base, gloss
    reflected = mirrored(RAMP_COSINES, weights.ior)
    if weights.coat == "dielectric":
        passed = (1.0 - reflected) / (1.0 - at_fit)
        base = (passed if crossing_in_table else passed**2)[:, None]
    most = max(1.0 / max(float(albedo.max()), 1e-6), 1.0)
    return base, gloss * np.minimum(reflected / at_fit, most)[:, None]
