"""Extraction of directional lights from an environment, by any method."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, replace
from functools import partial

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.directions import about_y
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.lights.cells import Cells, sum_by_label, sum_cells
from brdf_suite.lighting.lights.median_cut import median_cut, relaxed_strata
from brdf_suite.lighting.lights.structured import structured_strata


@dataclass(frozen=True, eq=False)
class DirectionalLights:
    """Directional lights of an environment; reflected radiance is ``Σ_d f_r(ω_d, ω_o)·strength_d·max(0, N·ω_d)``.

    (Günther et al. 2005, equation 4.) The cells cover the sphere once; the strongest light comes first.

    Attributes
    ----------
    directions
        (l, 3) unit vectors towards the lights, world space.
    strengths
        (l, 3), ∫L dω over the light's cell: the irradiance on a surface that faces it, in the working space.
        Divided by the solid angle it is the cell's mean radiance.
    solid_angles
        (l,) steradians of the cells; they sum to 4π.

    Raises
    ------
    ValueRangeError
        The shapes do not belong together, or a value is not finite or negative where it may not be.
    """

    directions: Floats
    strengths: Floats
    solid_angles: Floats

    def __post_init__(self) -> None:
        check_lights(self, "solid_angles")
        lengths = np.linalg.norm(self.directions, axis=1)
        if np.abs(lengths - 1.0).max(initial=0.0) > 1e-9:
            raise ValueRangeError("directions", "must have length 1")

    def __len__(self) -> int:
        return len(self.solid_angles)

    def brightest(self, count: int) -> DirectionalLights:
        """Return the ``count`` strongest lights; the others' light is left out."""
        return DirectionalLights(self.directions[:count], self.strengths[:count], self.solid_angles[:count])

    def turned(self, angle: float) -> DirectionalLights:
        """Return the lights turned by ``angle`` (radians) about +y, counter-clockwise seen from above."""
        return replace(self, directions=self.directions @ about_y(angle).T)

    def irradiance(self, normals: Floats) -> Floats:
        """Return the irradiance (..., 3) on surfaces of unit ``normals`` (..., 3)."""
        return np.asarray(np.maximum(normals @ self.directions.T, 0.0) @ self.strengths)


def check_lights(owner: object, sizes: str) -> None:
    """Check a frozen value's ``directions`` (l, 3), ``strengths`` (l, 3) and ``sizes`` (l,); store them read-only."""
    count = len(getattr(owner, sizes))
    for name, shape in (("directions", (count, 3)), ("strengths", (count, 3)), (sizes, (count,))):
        values = np.ascontiguousarray(getattr(owner, name), dtype=np.float64)
        if values.shape != shape:
            raise ValueRangeError(name, f"must have the shape {shape}, not {values.shape}")
        if not np.isfinite(values).all() or (name != "directions" and values.min(initial=0.0) < 0.0):
            raise ValueRangeError(name, "must be finite, and never negative")
        values.flags.writeable = False
        object.__setattr__(owner, name, values)


MAX_LIGHTS = 1024
DEFAULT_METHOD = "relaxed"
METHODS: dict[str, Callable[[Cells, int], NDArray[np.intp]]] = {
    "median-cut": median_cut,
    "structured": structured_strata,
    "relaxed": relaxed_strata,
}
_NO_DIRECTION = 1e-6


def directional_lights(
    environment: Environment, count: int, method: str = DEFAULT_METHOD
) -> DirectionalLights:
    """Return ``count`` lights (1…1,024) that represent the environment, the strongest first.

    Each represents a cell of the sphere and keeps all of its light, so their strengths sum to the map's, channel by
    channel; its direction is the mean of the cell's light. The same map gives the same lights. A map of fewer texels
    than ``count`` gives one light a texel.

    Parameters
    ----------
    method
        ``median-cut`` (Debevec 2005), ``structured`` (Agarwal et al. 2003), or ``relaxed``: median cut, then the
        relaxation of Kollig and Keller (2003), which errs least (docs/method/lights.md).

    Raises
    ------
    ValueRangeError
        ``count`` is out of its range, or there is no such method. (An environment is finite and never negative.)
    """
    if not 1 <= count <= MAX_LIGHTS:
        raise ValueRangeError("count", f"must be 1 to {MAX_LIGHTS} lights, not {count}")
    if method not in METHODS:
        raise ValueRangeError("method", f"must be one of {', '.join(METHODS)}, not {method!r}")
    cells = sum_cells(environment.radiance)
    return lights_from_labels(cells, METHODS[method](cells, count))


def lights_from_labels(cells: Cells, labels: NDArray[np.intp]) -> DirectionalLights:
    """Return one light for each of the ``labels`` (h, w) of cells, which are 0 and more, the strongest first."""
    at = labels.ravel()
    summed = partial(sum_by_label, at)
    strengths = summed(cells.energy)
    areas = cells.areas()
    solid_angles = summed(areas)[:, 0]
    towards = summed(cells.moments)
    luminous = strengths @ LUMINANCE
    # A black cell has no mean direction of its light: its middle will do. Where light comes from all around, none
    # is right: then it is that of the brightest texel, or the first.
    middles = summed(cells.centres() * areas[..., None])
    black = luminous <= 0.0
    towards[black] = middles[black]
    whole = np.where(black, solid_angles, luminous)
    undecided = np.linalg.norm(towards, axis=1) <= _NO_DIRECTION * whole
    for index in np.flatnonzero(undecided):
        mine = np.flatnonzero(at == index)
        brightest = mine[np.argmax((cells.luminous / areas).ravel()[mine])]
        towards[index] = cells.centres().reshape(-1, 3)[brightest]
    towards /= np.linalg.norm(towards, axis=1, keepdims=True)
    order = np.argsort(-luminous, kind="stable")
    return DirectionalLights(towards[order], strengths[order], solid_angles[order]).turned(cells.turn)
