"""Shader inputs for single lights: their block (the environment's brightest, the lamps) and materials' lobe tables."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import lru_cache

import numpy as np
from numpy.typing import ArrayLike, NDArray

from brdf_suite.appearance.flakes.visible import (
    ASPECULAR,
    LARGEST_SHARE,
    flake_dimming,
    mirrored_by_flakes,
    mirrored_share,
    seen_tilts,
)
from brdf_suite.appearance.light.matrix import environment_matrix, lamp_colour
from brdf_suite.arrays import Floats
from brdf_suite.documents.paint import Flakes
from brdf_suite.documents.view import View
from brdf_suite.documents.view_settings import Lamp
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import about_y, from_horizon
from brdf_suite.realtime.values import MaterialWeights

MOST_LIGHTS = 24
"""Sixteen of the environment and eight lamps."""
BLOCK_SIZE = (1 + 2 * MOST_LIGHTS) * 16

LARGEST_GLINT = 0.04
"""Radians: what a broader light of the environment gives flakes is in its maps, and part of the grain."""

_OF_ENVIRONMENT, _DIRECTIONAL, _POINT = 0.0, 1.0, 2.0


@dataclass(frozen=True, eq=False)
class DistantLights:
    """Directional lights of an environment, sorted by glint strength.

    Attributes
    ----------
    directions
        (l, 3) unit vectors to the lights, in the world before any turn.
    strengths
        (l, 3) irradiance on a surface that faces the light, working space, never negative.
    spreads
        (l,) standard deviation of its directions along an axis, radians.
    """

    directions: Floats
    strengths: Floats
    spreads: Floats

    def __post_init__(self) -> None:
        count = len(self.spreads)
        for name, shape in (("directions", (count, 3)), ("strengths", (count, 3)), ("spreads", (count,))):
            object.__setattr__(self, name, _checked(getattr(self, name), shape, name))

    def smaller_than(self, spread: float) -> DistantLights:
        """Return those whose directions spread by less, radians."""
        small = self.spreads < spread
        return DistantLights(self.directions[small], self.strengths[small], self.spreads[small])


def _checked(values: ArrayLike, shape: tuple[int, ...], name: str) -> Floats:
    array = np.ascontiguousarray(values, np.float64)
    if array.shape != shape or not np.isfinite(array).all():
        raise ValueRangeError(name, f"expected finite numbers of the shape {shape}, not {array.shape}")
    if name != "directions" and (array < 0).any():
        raise ValueRangeError(name, "must not be negative")
    return array


NO_LIGHTS = DistantLights(np.zeros((0, 3)), np.zeros((0, 3)), np.zeros(0))


def light_block(view: View, environment: DistantLights = NO_LIGHTS) -> bytes:
    """Return the block, :data:`BLOCK_SIZE` bytes: the environment's lights, turned with it, and the view's lamps."""
    block = np.zeros((1 + 2 * MOST_LIGHTS, 4), np.float32)
    if view.sparkle.mode == "glints":
        environment = environment.smaller_than(LARGEST_GLINT)
    count = 0 if view.sparkle.mode == "off" else min(view.sparkle.light_count, len(environment.spreads))
    rows = block[1:].reshape(MOST_LIGHTS, 2, 4)
    rows[:count, 0, :3] = environment.directions[:count] @ about_y(math.radians(view.rotation_deg)).T
    rows[:count, 0, 3] = _OF_ENVIRONMENT
    rows[:count, 1, :3] = environment.strengths[:count] @ environment_matrix(view.light_colour).T
    rows[:count, 1, 3] = environment.spreads[:count]
    for row, lamp in zip(rows[count:], view.lamps, strict=False):
        row[0, :3], row[0, 3] = _place(lamp)
        row[1, :3] = math.pi * lamp.strength * np.asarray(_colour(lamp.temperature_k))
        # An even disc has half its radius as standard deviation along an axis.
        row[1, 3] = 0.25 * (lamp.diameter if lamp.kind == "point" else math.radians(lamp.angle_deg))
    block[0, :2] = count, count + len(view.lamps)
    return block.tobytes()


def _place(lamp: Lamp) -> tuple[Floats, float]:
    if lamp.kind == "point":
        return np.asarray(lamp.position), _POINT
    return from_horizon(lamp.azimuth_deg, lamp.elevation_deg), _DIRECTIONAL


@lru_cache(maxsize=64)
def _colour(kelvin: float) -> tuple[float, ...]:
    return tuple(lamp_colour(kelvin).tolist())


def visible_flake_lobe(
    flakes: Flakes, gamma: Floats, base: Floats, theta: float, ior: float, strength: float = 1.0
) -> Floats:
    """Return the part (n, 3) of a base's lobes ``base`` (n, 3), 1/sr, at γ (n,) radians that visible flakes reflect.

    A paint's flakes lie in many layers; seen are those on top. As mirrors below a coat they have the mean reflectance

        f(γ) = d c R T² bell(δ(γ)) / (4π m² n² cos²θ')

    at the light's polar angle θ (:func:`~brdf_suite.appearance.flakes.visible.mirrored_by_flakes`): δ(γ) is the tilt
    that an aspecular angle sees, and d how much dimmer than clean mirrors they are (``flake_dimming``). Their colour is
    the base's there (they are seen through the same pigment), and they never send more than most of it.

    ``theta`` is the light's polar angle that the lobes hold for, radians, ``ior`` the coat's index; ``strength`` is a
    factor on the flakes' light, 1 being what the module derives.
    """
    peak = mirrored_by_flakes(flakes, ior, theta)
    at_15 = [float(np.interp(ASPECULAR, gamma, base[:, k])) for k in range(3)]
    dimming = flake_dimming(flakes, max(at_15), ior, theta)
    wanted = strength * dimming * peak * seen_tilts(gamma, theta, ior, flakes.roughness)
    share = np.minimum(wanted / np.maximum(base.max(axis=-1), 1e-12), LARGEST_SHARE)
    return np.asarray(base * share[:, None])


def coat_index(weights: MaterialWeights) -> float:
    """Return the index of the coat that a material's flakes lie below; 1 where they lie below none."""
    return weights.ior if weights.coat == "dielectric" else 1.0


def flake_power(weights: MaterialWeights, flakes: Flakes, strength: float = 1.0) -> float:
    """Return the light that a flake mirrors, of its largest channel, over what falls on the coat: d c R T².

    As :func:`visible_flake_lobe` has it; T is that of the fit's angle.
    """
    base = (math.cos(ASPECULAR) ** np.asarray(weights.exponents) @ weights.kdd + weights.kd).max()
    theta, ior = weights.theta_fit_rad, coat_index(weights)
    dimming = flake_dimming(flakes, float(base), ior, theta)
    return strength * dimming * mirrored_share(flakes, ior, theta)


COLUMNS = 160
"""A lobe of exponent 50,000 is then right to 0.5 % of its peak between columns."""
ROWS = 4


def column_angles() -> Floats:
    """Return γ (:data:`COLUMNS`,) of the columns, radians, 0 to π/2."""
    along = np.linspace(0.0, 1.0, COLUMNS)
    return np.asarray(2.0 * np.arcsin(math.sqrt(0.5) * along**2))


def light_lobes(
    weights: MaterialWeights, flakes: Flakes | None = None, strength: float = 1.0
) -> NDArray[np.float32]:
    """Return a table for light_lobes.glsl, (4, :data:`COLUMNS`, 4): base, gloss, flakes, discs; KD in the first alphas.

    A light from one direction needs Σ KDD_i cos^E_i γ and Σ KG_i cos^E_i γ, γ from the mirror direction. Both are
    tabulated over sqrt(sin γ/2), which gives the narrow lobes most of the columns, up to 90°, where every lobe ends; so
    a light costs one look-up however many lobes there are. The last row is the share that the gloss keeps of its peak
    in the light of a disc of radius γ (:func:`disc_lobe`), and in alpha the gloss's width.
    """
    gamma = column_angles()
    # 1 - cos γ = 2 sin²(γ/2) keeps its digits for narrow lobes; at 90° every lobe is 0.
    logarithm = np.log1p(-2.0 * np.sin(0.5 * gamma[:-1]) ** 2)
    powers = np.zeros((COLUMNS, len(weights.exponents)))
    powers[:-1] = np.exp(logarithm[:, None] * np.asarray(weights.exponents)[None, :])
    table = np.zeros((ROWS, COLUMNS, 4), np.float32)
    base = powers @ weights.kdd
    table[0, :, :3] = base
    gloss = powers @ weights.kg
    table[1, :, :3] = gloss
    table[3, :, :3], table[3, :, 3] = disc_lobe(gamma, gloss)
    if flakes is not None and flakes.density_per_mm2 > 0.0:
        theta, ior = weights.theta_fit_rad, coat_index(weights)
        lobe = visible_flake_lobe(flakes, gamma, base + weights.kd, theta, ior, strength)
        # The shader knows the tilt itself, not only in the plane of the fit's light.
        tilts = seen_tilts(gamma, theta, ior, flakes.roughness)
        table[2, :, :3] = lobe / np.maximum(tilts, 1e-4)[:, None]
    table[:3, :, 3] = weights.kd[:, None]
    return table


def disc_lobe(gamma: Floats, lobe: Floats) -> tuple[Floats, float]:
    """Return what a lobe (n, 3) over γ (n,), radians, is multiplied by in the light of discs of radius γ; its width.

    What a disc of radius a gives is drawn as an even middle, and beyond it the lobe, stretched: f((γ - s)/b), with the
    width σ from the lobe's peak, ∫ f γ dγ = σ² f(0), as of a Gaussian. Up to a = 2σ there is no middle, s = 0, and
    b² = 1 + a²/(4σ²) adds the disc's variance; beyond, s = a - 2σ, and b rises to 1.7, which puts half of the peak at
    the disc's edge. All directions together must get what they get of a light without extent:

        share = ∫ f γ dγ / (f(0) s²/2 + ∫ f (b γ + s) b dγ)
    """
    step = np.diff(gamma)[:, None]

    def integral(values: Floats) -> Floats:
        return np.asarray((0.5 * step * (values[1:] + values[:-1])).sum(axis=0))

    whole, over = integral(lobe * gamma[:, None]), integral(lobe)
    peak = float(lobe[0].max())
    width = math.sqrt(float(whole.max()) / peak) if peak > 0.0 else 1.0
    middle = np.maximum(gamma - 2.0 * width, 0.0)[:, None]
    broad = 1.7 - 0.58 * width / np.maximum(gamma, 2.0 * width)
    stretch = np.where(gamma < 2.0 * width, np.sqrt(1.0 + (0.5 * gamma / width) ** 2), broad)[:, None]
    spread = 0.5 * lobe[0] * middle**2 + stretch**2 * whole + middle * stretch * over
    return np.divide(whole, spread, out=np.ones_like(spread), where=spread > 0.0), width
