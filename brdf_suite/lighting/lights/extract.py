"""Extraction of directional lights from an environment, by any method."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.errors import ValueRangeError
from brdf_suite.lighting.environment import Environment
from brdf_suite.lighting.lights.cells import Cells, sum_cells
from brdf_suite.lighting.lights.directional import DirectionalLights
from brdf_suite.lighting.lights.median_cut import median_cut
from brdf_suite.lighting.lights.relaxed import relaxed_strata
from brdf_suite.lighting.lights.structured import structured_strata

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
    count = int(at.max()) + 1

    def summed(values: NDArray[np.float64]) -> NDArray[np.float64]:
        flat = values.reshape(at.size, -1)
        return np.stack([np.bincount(at, flat[:, k], count) for k in range(flat.shape[1])], axis=1)

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
