"""Lights of an environment that make single flakes glint: few, bright, and of their true size.

A flake mirrors a small part of the surroundings. Where that part holds a small bright light, the flake lights up; a
broad light is met by so many flakes that only their mean is seen. So what counts is the brightest *small* lights,
each with its own extent. Structured strata (Agarwal et al. 2003) follow bright regions by their edges, so a sun gets
strata of its own, without the sky around it; those that lie side by side and are small together are joined again.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import about_y
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.lights.cells import Cells, sum_by_label, sum_cells
from brdf_suite.lighting.lights.extract import check_lights
from brdf_suite.lighting.lights.structured import structured_strata

MOST_LIGHTS = 16
_STRATA = 96
_COLUMNS = 512  # of the cells; directions are still those of single texels
# Radians: strata nearer than this are one light, about what a flake's own spread makes of them.
_NEAR = 0.02
# Radians: the spread at which a light counts half as much as a small one of the same strength.
_SMALL = 0.03
_BLACK = 1e-12


@dataclass(frozen=True, eq=False)
class GlintLights:
    """Directional lights with an extent; the one that glints most comes first.

    Attributes
    ----------
    directions
        (l, 3) unit vectors towards the lights, world space.
    strengths
        (l, 3), ∫L dω: the irradiance on a surface that faces the light, working space, never negative.
    spreads
        (l,) standard deviation of the light's directions along one axis, radians.
    """

    directions: Floats
    strengths: Floats
    spreads: Floats

    def __post_init__(self) -> None:
        check_lights(self, "spreads")

    def __len__(self) -> int:
        return len(self.spreads)

    def turned(self, angle: float) -> GlintLights:
        """Return the lights turned by ``angle`` (radians) about +y, counter-clockwise seen from above."""
        return replace(self, directions=self.directions @ about_y(angle).T)


def glint_lights(environment: Environment, count: int = MOST_LIGHTS) -> GlintLights:
    """Return at most ``count`` lights (1…16) of the environment, by how much single flakes can glint in them.

    A light's rank is its luminance over the square of its extent, as a flake sees it. A black map has none.

    >>> sky = Environment("white", np.ones((16, 32, 3), np.float32))
    >>> bool(glint_lights(sky, 1).spreads[0] > 0.05)  # nothing small in an even sky
    True
    """
    if not 1 <= count <= MOST_LIGHTS:
        raise ValueRangeError("count", f"must be 1 to {MOST_LIGHTS} lights, not {count}")
    cells = sum_cells(environment.radiance, _COLUMNS)
    energy, moments, spread2 = _joined(*_strata(cells))
    luminous = energy @ LUMINANCE
    lit = luminous > _BLACK * max(float(luminous.sum()), _BLACK)
    energy, moments, spread2, luminous = energy[lit], moments[lit], spread2[lit], luminous[lit]
    directions = moments / np.maximum(np.linalg.norm(moments, axis=1, keepdims=True), 1e-300)
    order = np.argsort(-luminous / (_SMALL**2 + spread2), kind="stable")[:count]
    return GlintLights(directions[order], energy[order], np.sqrt(spread2[order])).turned(cells.turn)


def _strata(cells: Cells) -> tuple[Floats, Floats, Floats]:
    """Light (k, 3), moments (k, 3) and squared spread along an axis (k,) of the strata."""
    summed = partial(sum_by_label, structured_strata(cells, _STRATA).ravel())

    energy, moments = summed(cells.energy), summed(cells.moments)
    luminous = np.maximum(energy @ LUMINANCE, 1e-300)
    # 1 - |mean direction| is half the mean square of the angle from it, so its square along one of two axes. What lies
    # within a texel is not known: it is taken for an even disc, of the variance Ω / 4π along an axis.
    texel = summed(cells.luminous * cells.areas())[:, 0] / luminous / (4.0 * np.pi)
    apart = np.maximum(1.0 - np.linalg.norm(moments, axis=1) / luminous, 0.0)
    return energy, moments, apart + texel


def _joined(energy: Floats, moments: Floats, spread2: Floats) -> tuple[Floats, Floats, Floats]:
    """Merge strata within reach of a brighter one, while the merged extent stays small."""
    luminous = energy @ LUMINANCE
    rest = np.argsort(-luminous, kind="stable").tolist()
    towards = moments / np.maximum(np.linalg.norm(moments, axis=1, keepdims=True), 1e-300)
    reach = _NEAR + np.sqrt(spread2)

    def near(moment: Floats) -> list[bool]:
        apart = np.linalg.norm(towards - moment / np.linalg.norm(moment), axis=1)
        return [bool(item) for item in apart <= reach]

    out: list[tuple[Floats, Floats, float]] = []
    while rest:
        first = rest.pop(0)
        if luminous[first] <= 0.0:
            break
        light, moment = energy[first].copy(), moments[first].copy()
        square = float(luminous[first] * spread2[first])
        within = near(moment)
        for other in list(rest):
            if luminous[other] <= 0.0 or not within[other]:
                continue
            both = float(light @ LUMINANCE + luminous[other])
            between = max(1.0 - float(np.linalg.norm(moment + moments[other])) / both, 0.0)
            # Both moments are shortened by their own spread already, so this holds all of it but the texels'.
            if between > _NEAR * _NEAR:
                continue
            light += energy[other]
            moment += moments[other]
            square += float(luminous[other] * spread2[other])
            rest.remove(other)
            within = near(moment)
        whole = float(light @ LUMINANCE)
        own_spread = max(1.0 - float(np.linalg.norm(moment)) / whole, square / whole)
        out.append((light, moment, own_spread))
    lights, means, spreads = zip(*out, strict=True) if out else ((), (), ())
    return np.reshape(lights, (-1, 3)), np.reshape(means, (-1, 3)), np.array(spreads)
