"""Directions over the upper hemisphere that lie close where a reflectance is sharp: about the mirror direction.

The hemisphere is covered by great circles that start at the mirror direction M of the light and end at the horizon.
With the light at the polar angle θ, a circle that leaves M at the angle ψ from "away from the normal" meets the
horizon after the arc Γ(ψ) and at the azimuth φ(ψ) from that of M:

    tan Γ = cosθ / (cosψ sinθ),   tan φ = cosθ tan ψ.

- Rows: arcs γ = w Γ(ψ) with w = (j/(n-1))³. Of 128 rows 17 lie within 0.23° of M, the half width of a lobe of
  exponent 10⁵, and the widest step is 2.1°.
- Columns: where M is the normal, ψ = φ is even. As M sinks, even ψ leaves the horizon beside the light without
  columns, and even φ leaves M's own neighbourhood without. So (ψ + φ)/2 is even, and neither is ever sparser than half.

Every point above the horizon lies on one such arc, so there is no pole but M, where all columns meet, and no seam:
the last column is the first again, bit by bit.
"""

from __future__ import annotations

import math
from dataclasses import dataclass

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats
from brdf_suite.geometry.directions import mirror

ROWS, COLUMNS = 128, 256
"""Points from the mirror direction to the horizon, and around it."""

MOST_THETA_DEG = 89.9
HORIZON_Z = 1e-4
"""Least z of a direction: at the horizon itself every reflectance is 0 by definition, and a rim would fall to it."""

WARP = 3.0
"""Rows lie at this power of even shares of the way to the horizon."""
_HALF_TURN = np.linspace(0.0, math.pi, 2049)


@dataclass(frozen=True, eq=False)
class LobeGrid:
    """Directions for one incidence; columns + 1 along the second axis, the last being the first again.

    Attributes
    ----------
    wi
        (3,) to the light.
    mirror
        (3,) its mirror direction.
    directions
        (rows, columns + 1, 3) unit, z ≥ :data:`HORIZON_Z`; row 0 is the mirror direction, the last the horizon.
    gamma
        (rows, columns + 1) the arc from the mirror direction, radians.
    psi
        (columns + 1,) in which direction the column leaves, radians, 0 is away from the normal; rises to 2π.
    leave, across
        (columns + 1, 3) unit vectors at M: that in which the column leaves, and that in which ψ grows.
    """

    wi: Floats
    mirror: Floats
    directions: Floats
    gamma: Floats
    psi: Floats
    leave: Floats
    across: Floats

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns of points, the doubled column counted."""
        rows, columns = self.gamma.shape
        return rows, columns


def lobe_grid(wi: npt.ArrayLike, rows: int = ROWS, columns: int = COLUMNS) -> LobeGrid:
    """Return the grid for light from the unit direction ``wi`` (3,) above the horizon.

    ``columns`` is even, so that the grid is its own mirror image about the plane of incidence: column k and column
    ``columns - k``. Light within 0.1° of the horizon is taken to stand there.
    """
    if rows < 3 or columns < 8 or columns % 2:
        raise ValueError("at least 3 rows and 8 columns are wanted, columns even")
    x, y, z = (float(value) for value in np.asarray(wi, float))
    light = np.array([x, y, z])
    top = mirror(light)
    cos_t = max(z, math.cos(math.radians(MOST_THETA_DEG)))
    # From the part across, which keeps its digits near the normal.
    flat = math.hypot(x, y)
    sin_t = flat if cos_t == z else math.sqrt(1.0 - cos_t * cos_t)
    # At normal incidence any azimuth serves; that of a light which comes down to it from the -x side stays.
    cos_a, sin_a = (-x / flat, -y / flat) if flat > 1e-12 else (1.0, 0.0)
    psi = _columns(cos_t, columns)
    cos_p, sin_p = np.cos(psi), np.sin(psi)
    reach = np.arctan2(cos_t, cos_p * sin_t)
    gamma = ((np.arange(rows) / (rows - 1.0)) ** WARP)[:, None] * reach
    # With M's azimuth at 0: M, away from the normal, and sideways; these few are turned, not all directions.
    turn = np.array([[cos_a, sin_a, 0.0], [-sin_a, cos_a, 0.0], [0.0, 0.0, 1.0]])
    centre = np.array([sin_t, 0.0, cos_t]) @ turn
    leave = np.stack((cos_p * cos_t, sin_p, -cos_p * sin_t), axis=-1) @ turn
    across = np.stack((-sin_p * cos_t, cos_p, sin_p * sin_t), axis=-1) @ turn
    leave[-1], across[-1] = leave[0], across[0]
    cos_g, sin_g = np.cos(gamma), np.sin(gamma)
    directions = np.empty((*gamma.shape, 3))
    for axis in range(3):
        np.multiply(cos_g, centre[axis], out=directions[..., axis])
        directions[..., axis] += sin_g * leave[:, axis]
    low = np.nonzero(directions[..., 2] < HORIZON_Z)
    rim = directions[low]
    rim[:, 2] = HORIZON_Z
    directions[low] = rim / np.sqrt(np.einsum("ni,ni->n", rim, rim))[:, None]
    return LobeGrid(light, top, directions, gamma, psi, leave, across)


def _columns(cos_t: float, columns: int) -> Floats:
    """ψ (columns + 1,) for which ψ + φ(ψ) is even over a turn."""
    # Finely even between the two: tan p lies between tan ψ and tan φ = cosθ tan ψ.
    p = _HALF_TURN
    root = math.sqrt(cos_t)
    cos_p, sin_p = np.cos(p), np.sin(p)
    psi = np.arctan2(sin_p, root * cos_p)
    phi = np.arctan2(root * sin_p, cos_p)
    half = columns // 2
    side = np.interp(np.arange(half + 1) * (math.pi / half), 0.5 * (psi + phi), psi)
    side[0], side[-1] = 0.0, math.pi
    return np.concatenate((side, 2.0 * math.pi - side[-2::-1]))
