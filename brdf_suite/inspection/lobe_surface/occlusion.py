"""What a lobe hides, and where a ray meets it: for labels that lie behind it, and for reading a value under the cursor.

A radial surface says at once whether a point is within: its distance is less than the radius in its direction. So a
line of sight is walked in steps, and the first that ends within has met the surface.
"""

from __future__ import annotations

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.inspection.lobe_surface.grid import WARP, LobeGrid
from brdf_suite.inspection.lobe_surface.surface import LobeSurface

_STEPS = 96
_BISECTIONS = 12


def radius_along(surface: LobeSurface, grid: LobeGrid, directions: npt.ArrayLike) -> Floats:
    """Return the surface's radius (...) in unit directions (..., 3), between its points; 0 below the horizon."""
    d = np.asarray(directions, float)
    row, column = _place(grid, d)
    rows, columns = surface.shape
    r0 = np.minimum(row.astype(int), rows - 2)
    c0 = np.minimum(column.astype(int), columns - 2)
    u, v = row - r0, column - c0
    radius = np.linalg.norm(surface.points, axis=-1)
    near = (1.0 - v) * radius[r0, c0] + v * radius[r0, c0 + 1]
    far = (1.0 - v) * radius[r0 + 1, c0] + v * radius[r0 + 1, c0 + 1]
    return np.where(d[..., 2] >= 0.0, (1.0 - u) * near + u * far, 0.0)


def hidden(
    surface: LobeSurface, grid: LobeGrid, eye: npt.ArrayLike, places: npt.ArrayLike
) -> npt.NDArray[np.bool_]:
    """Return whether (n,) the surface stands between ``eye`` (3,) and each of ``places`` (n, 3)."""
    eye, places = np.asarray(eye, float), np.asarray(places, float).reshape(-1, 3)
    # Up to just before the place itself, which may lie on the surface.
    share = np.linspace(0.0, 0.985, _STEPS)[:, None, None]
    walk = eye + share * (places - eye)
    return np.asarray(_within(surface, grid, walk).any(axis=0))


def met(
    surface: LobeSurface, grid: LobeGrid, start: npt.ArrayLike, along: npt.ArrayLike, reach: float = 1.5
) -> Floats | None:
    """Return the point (3,) where a ray meets the surface first, None where it misses.

    ``start`` (3,) and unit ``along`` (3,); ``reach`` is how far from the middle the surface may be.
    """
    start, along = np.asarray(start, float), np.asarray(along, float)
    middle = -float(start @ along)
    apart = float(start @ start) - middle * middle
    if apart >= reach * reach:
        return None
    half = float(np.sqrt(reach * reach - apart))
    # The steps are as close as a spike is thin beside the middle of the ray.
    walk = np.linspace(max(middle - half, 0.0), middle + half, 4 * _STEPS)
    inside = _within(surface, grid, start + walk[:, None] * along)
    if not inside.any():
        return None
    first = int(np.argmax(inside))
    if first == 0:
        return np.asarray(start + walk[0] * along)
    low, high = walk[first - 1], walk[first]
    for _ in range(_BISECTIONS):
        half_way = 0.5 * (low + high)
        if _within(surface, grid, (start + half_way * along)[None])[0]:
            high = half_way
        else:
            low = half_way
    return np.asarray(start + high * along)


def value_along(surface: LobeSurface, grid: LobeGrid, direction: npt.ArrayLike) -> float:
    """Return the value, 1/sr, of the point of the surface that is nearest to a unit direction (3,)."""
    row, column = _place(grid, np.asarray(direction, float))
    return float(surface.values[round(float(row)), round(float(column))])


def _within(surface: LobeSurface, grid: LobeGrid, places: Floats) -> npt.NDArray[np.bool_]:
    distance = np.linalg.norm(places, axis=-1)
    safe = np.maximum(distance, 1e-12)
    return np.asarray((distance < 1.5) & (distance < radius_along(surface, grid, places / safe[..., None])))


def _place(grid: LobeGrid, d: Floats) -> tuple[Floats, Floats]:
    """Row and column, not whole numbers, of directions (..., 3) in a grid; the inverse of its making."""
    rows, _ = grid.shape
    # Away from the mirror direction along the normal's plane, and across it.
    down, side = grid.leave[0], grid.across[0]
    ahead, beside = d @ down, d @ side
    psi = np.arctan2(beside, ahead) % (2.0 * np.pi)
    column = np.interp(psi, grid.psi, np.arange(len(grid.psi)))
    gamma = np.arctan2(np.hypot(ahead, beside), d @ grid.mirror)
    reach = np.interp(psi, grid.psi, grid.gamma[-1])
    row = np.clip(gamma / reach, 0.0, 1.0) ** (1.0 / WARP) * (rows - 1)
    return row, column
