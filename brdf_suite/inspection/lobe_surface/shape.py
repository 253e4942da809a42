"""Points and normals of a radial surface r(ω)·ω over a lobe grid.

A radial surface has the normal r ω - ∇r, with the gradient on the unit sphere. With γ the arc from the mirror
direction and ψ the direction in which it leaves, ∇r = r_γ e_γ + r_ψ/sin γ e_ψ. Rows and columns of the grid are no
lines of constant γ and ψ; along them

    dr/dj = r_γ dγ/dj,    dr/dk = r_γ dγ/dk + r_ψ dψ/dk.

The gradient is taken from differences of r and of γ, never of points: within a spike those differ by less than
single precision resolves.
"""

from __future__ import annotations

import numpy as np

from brdf_suite.arrays import Singles
from brdf_suite.inspection.lobe_surface.grid import LobeGrid

_ROUNDING = 6e-7


def surface_points(grid: LobeGrid, radius: Singles) -> Singles:
    """Return r·ω (rows, columns, 3) float32 for ``radius`` (rows, columns); NaN where the radius is."""
    return np.asarray(grid.directions.astype(np.float32) * radius[..., None])


def surface_normals(grid: LobeGrid, radius: Singles) -> Singles:
    """Return unit normals (rows, columns, 3) float32, outwards; the mirror direction itself where nothing is known."""
    rows, columns = grid.shape
    gamma = grid.gamma.astype(np.float32)
    r_gamma = _per_gamma(radius, gamma)
    # Columns go round: the last is the first again.
    sideways = _around(radius)
    r_psi = sideways - r_gamma * _around(gamma)
    turned = np.empty(columns, np.float32)
    turned[1:-1] = grid.psi[2:] - grid.psi[:-2]
    turned[0] = turned[-1] = grid.psi[1] + (2.0 * np.pi - grid.psi[-2])
    # Next to the mirror direction columns lie closer than single precision resolves: what may be rounding
    # is taken away, which matters only where γ is far below what any picture shows.
    r_psi -= np.clip(r_psi, -_ROUNDING * radius, _ROUNDING * radius)
    r_psi /= turned
    sine = np.sin(gamma)
    np.divide(r_psi, sine, out=r_psi, where=sine > 0.0)
    r_psi[0] = 0.0
    cosine = np.cos(gamma)
    # e_γ = cosγ leave - sinγ M and ω = cosγ M + sinγ leave, so the normal has three parts along fixed vectors.
    along_centre = radius * cosine + r_gamma * sine
    along_leave = radius * sine - r_gamma * cosine
    centre = grid.mirror.astype(np.float32)
    leave, across = grid.leave.astype(np.float32), grid.across.astype(np.float32)
    normals = np.empty((rows, columns, 3), np.float32)
    for axis in range(3):
        part = along_leave * leave[:, axis]
        part += along_centre * centre[axis]
        part -= r_psi * across[:, axis]
        normals[..., axis] = part
    normals[0] = _tip(normals[0])
    length = np.sqrt(np.einsum("jki,jki->jk", normals, normals))
    known = length > 1e-20
    if not known.all():  # radius 0 all around, or a hole
        normals[~known] = centre
        length[~known] = 1.0
    normals /= length[..., None]
    return normals


def _tip(ring: Singles) -> Singles:
    """One normal for the mirror direction, where all columns meet: the mean of theirs that are known."""
    known = ring[:-1][np.isfinite(ring[:-1]).all(axis=-1)]
    return np.broadcast_to(known.mean(axis=0), ring.shape) if len(known) else ring


def _per_gamma(radius: Singles, gamma: Singles) -> Singles:
    """dr/dγ along the rows: central differences, one-sided at the ends and beside holes."""
    step = np.diff(gamma, axis=0)
    rise = np.diff(radius, axis=0)
    result = np.empty_like(radius)
    np.divide(rise[1:] + rise[:-1], step[1:] + step[:-1], out=result[1:-1])
    np.divide(rise[0], step[0], out=result[0])
    np.divide(rise[-1], step[-1], out=result[-1])
    if np.isnan(result).any():
        down, up = rise / step, np.full_like(radius, np.nan)
        up[:-1] = down
        up[1:] = np.where(np.isnan(up[1:]), down, up[1:])
        result = np.where(np.isnan(result), np.nan_to_num(up), result)
    return result


def _around(values: Singles) -> Singles:
    """Differences between the next and the last column, the doubled one left out; twice one side's beside holes."""
    result = np.empty_like(values)
    np.subtract(values[:, 2:], values[:, :-2], out=result[:, 1:-1])
    result[:, 0] = result[:, -1] = values[:, 1] - values[:, -2]
    if np.isnan(result).any():
        ahead = np.empty_like(values)
        ahead[:, :-1] = np.diff(values, axis=1)
        ahead[:, -1] = ahead[:, 0]
        back = np.empty_like(values)
        back[:, 1:] = ahead[:, :-1]
        back[:, 0] = back[:, -1]
        one = np.where(np.isnan(ahead), back, ahead)
        result = np.where(np.isnan(result), 2.0 * np.nan_to_num(one), result)
    return result
