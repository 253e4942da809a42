"""The reflected distribution as a radial surface: for one incidence, a point at a distance for every direction.

A surface is made in steps that are kept apart, because a drag repeats only some of them: directions
(:mod:`brdf_suite.inspection.lobe_surface.grid`), values (:mod:`brdf_suite.inspection.lobe_surface.parts`), then
here the radius, points, normals and colours.

A radial surface r(ω)·ω has the normal r ω - ∇r, with the gradient on the unit sphere. With γ the arc from the mirror
direction and ψ the direction in which it leaves, ∇r = r_γ e_γ + r_ψ/sin γ e_ψ. Rows and columns of the grid are no
lines of constant γ and ψ; along them

    dr/dj = r_γ dγ/dj,    dr/dk = r_γ dγ/dk + r_ψ dψ/dk.

The gradient is taken from differences of r and of γ, never of points: within a spike those differ by less than
single precision resolves.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bytes, Singles, Words
from brdf_suite.errors import ValueRangeError
from brdf_suite.inspection.lobe_surface.colour import (
    CHANNEL_CODES,
    difference_codes,
    light_codes,
    mapped_codes,
    one_colour,
    scalar_of,
)
from brdf_suite.inspection.lobe_surface.grid import LobeGrid
from brdf_suite.inspection.slices.values import Channel

RadiusKind = Literal["linear", "cbrt", "log"]
RADIUS_KINDS: tuple[RadiusKind, ...] = ("linear", "cbrt", "log")

LEAST_DECADES, MOST_DECADES = 1.0, 12.0


@dataclass(frozen=True)
class RadiusScale:
    """Radius 1 is the value ``full``, in 1/sr.

    ``decades`` is what the logarithm shows: a value of ``full`` / 10^decades, and all below, has the radius 0.

    >>> float(RadiusScale("cbrt", full=8.0).radius(1.0))
    0.5
    """

    kind: RadiusKind = "cbrt"
    full: float = 1.0
    decades: float = 4.0

    def __post_init__(self) -> None:
        if self.kind not in RADIUS_KINDS:
            raise ValueRangeError("kind", f"one of {', '.join(RADIUS_KINDS)} is wanted, not {self.kind!r}")
        if not 0.0 < self.full < np.inf:
            raise ValueRangeError("full", f"a value in 1/sr above 0 is wanted, not {self.full}")
        if not LEAST_DECADES <= self.decades <= MOST_DECADES:
            raise ValueRangeError("decades", f"{LEAST_DECADES:g} to {MOST_DECADES:g} decades are shown")

    def radius(self, values: npt.ArrayLike) -> Singles:
        """Return the radius (...), float32, of values (...) in 1/sr, not negative; NaN stays NaN.

        It is above 1 where a value is above ``full``.
        """
        share = np.asarray(values, np.float32) * np.float32(1.0 / self.full)
        if self.kind == "linear":
            return share
        if self.kind == "cbrt":
            return np.asarray(np.cbrt(share))
        least = np.float32(10.0**-self.decades)
        # np.maximum keeps a NaN.
        risen = np.log10(np.maximum(share, least))
        risen *= np.float32(1.0 / self.decades)
        risen += np.float32(1.0)
        # The least value would miss 0 by a rounding; a NaN stays one.
        return np.asarray(risen * (share > least))

    def value(self, radius: float) -> float:
        """Return the value in 1/sr that is drawn at ``radius``, above 0; the inverse of :meth:`radius`."""
        if self.kind == "linear":
            return radius * self.full
        if self.kind == "cbrt":
            return radius**3 * self.full
        return float(self.full * 10.0 ** ((radius - 1.0) * self.decades))


_ROUNDING = 6e-7


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
    rounding = _ROUNDING * radius
    r_psi -= np.clip(r_psi, -rounding, rounding)
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
    # Each part is an array of its own until the end: numpy is slow along a last axis of three.
    parts = []
    for axis in range(3):
        part = along_leave * leave[:, axis]
        part += along_centre * centre[axis]
        part -= r_psi * across[:, axis]
        parts.append(part)
    # One normal for the mirror direction, where all columns meet: the mean of theirs that are known.
    tips = np.stack([part[0, :-1] for part in parts])
    known_tips = tips[:, np.isfinite(tips).all(axis=0)]
    if known_tips.size:
        for part, tip in zip(parts, known_tips.mean(axis=1), strict=True):
            part[0] = tip
    length = parts[0] * parts[0]
    for part in parts[1:]:
        length += part * part
    np.sqrt(length, out=length)
    known = length > 1e-20
    if not known.all():  # radius 0 all around, or a hole
        for part, coordinate in zip(parts, centre, strict=True):
            part[~known] = coordinate
        length[~known] = 1.0
    normals = np.empty((rows, columns, 3), np.float32)
    for axis, part in enumerate(parts):
        np.divide(part, length, out=normals[..., axis])
    return normals


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


Colouring = Literal["light", "line", "values"]
COLOURINGS: tuple[Colouring, ...] = ("light", "line", "values")


@dataclass(frozen=True, eq=False)
class LobeSurface:
    """A surface over a grid of rows × columns points (the last column is the first again).

    Attributes
    ----------
    points, normals
        (rows, columns, 3) float32, local frame, z the normal of the reflecting surface; a point in a hole is at 0.
    colours
        (rows, columns, 3) sRGB codes.
    values
        (rows, columns) float32, 1/sr: what the radius shows; NaN in a hole.
    scale
        How values became radii.
    holes
        Points above the horizon without a value.
    dark
        Whether all values are 0, so that there is nothing to see.
    """

    points: Singles
    normals: Singles
    colours: Bytes
    values: Singles
    scale: RadiusScale
    holes: int = 0
    dark: bool = False

    @property
    def shape(self) -> tuple[int, int]:
        """Rows and columns."""
        rows, columns = self.values.shape
        return rows, columns

    @property
    def faces(self) -> Words:
        """Triangles (n, 3) of points, counter-clockwise seen from outside; none that has a point in a hole."""
        whole = grid_faces(*self.shape)
        if not self.holes:
            return whole
        known = np.isfinite(self.values).reshape(-1)
        return np.asarray(whole[known[whole].all(axis=1)])


def lobe_surface(
    grid: LobeGrid,
    values: Singles,
    scale: RadiusScale,
    *,
    channel: Channel = "colour",
    colouring: Colouring = "light",
    line: tuple[float, float, float] = (0.6, 0.6, 0.6),
    most_radius: float | None = None,
) -> LobeSurface:
    """Return the surface of values (rows, columns, 3), 1/sr, linear Rec. 2020, NaN in holes.

    Parameters
    ----------
    channel
        What the radius shows; ``colour`` by the luminance.
    colouring
        ``light``: the colour of the reflected light, or of the channel where one is shown; ``line``: the colour
        ``line`` (sRGB, 0 to 1); ``values``: the map of values over the radius.
    most_radius
        Where longer radii are cut off; None: nowhere.
    """
    shown = scalar_of(values, channel)
    radius = scale.radius(shown)
    holes = _holes(shown)
    if colouring == "values":
        colours = mapped_codes(radius)
    elif colouring == "line":
        colours = one_colour(tuple(255.0 * c for c in line), shown.shape)  # type: ignore[arg-type] # three of three
    elif channel == "colour":
        colours = light_codes(np.nan_to_num(values) if holes else values)
    else:
        colours = one_colour(CHANNEL_CODES[channel], shown.shape)
    return _made(grid, radius, shown, colours, scale, holes, most_radius)


def difference_surface(
    grid: LobeGrid, difference: Singles, scale: RadiusScale, most_radius: float | None = None
) -> LobeSurface:
    """Return the surface of signed differences (rows, columns), 1/sr: its radius is their size, its colour the sign.

    The map is centred at 0 and its ends are ± ``scale.full``.
    """
    radius = scale.radius(np.abs(difference))
    colours = difference_codes(np.sign(difference) * radius)
    return _made(grid, radius, difference, colours, scale, _holes(difference), most_radius)


def greatest(values: Singles) -> float:
    """Return the greatest size of values (...), 0 where all are 0 or none is known."""
    known = np.abs(values)
    most = float(known.max())
    if most != most:
        most = float(np.nanmax(known)) if not np.isnan(known).all() else 0.0
    return most


def _made(
    grid: LobeGrid,
    radius: Singles,
    values: Singles,
    colours: Bytes,
    scale: RadiusScale,
    holes: int,
    most_radius: float | None,
) -> LobeSurface:
    if most_radius is not None:
        radius = np.minimum(radius, np.float32(most_radius))  # keeps a NaN
    points, normals = grid.directions.astype(np.float32) * radius[..., None], surface_normals(grid, radius)
    if holes:
        points = np.nan_to_num(points)
    # The least radius of a logarithm is 0 too.
    return LobeSurface(points, normals, colours, values, scale, holes, greatest(values) == 0.0)


def _holes(values: Singles) -> int:
    if not np.isnan(float(values.min())):  # a sum may overflow
        return 0
    return int(np.isnan(values[:, :-1]).sum())


@lru_cache(maxsize=4)
def grid_faces(rows: int, columns: int) -> Words:
    """Return the triangles (n, 3) of a whole grid; the mirror direction, row 0, is a fan."""
    row, column = np.meshgrid(np.arange(rows - 1), np.arange(columns - 1), indexing="ij")
    first = (row * columns + column).astype(np.uint32)
    right, below = first + 1, first + np.uint32(columns)
    across = below + np.uint32(1)
    outer = np.stack((first, below, across), axis=-1)
    inner = np.stack((first, across, right), axis=-1)
    faces = np.concatenate((outer.reshape(-1, 3), inner[1:].reshape(-1, 3)))
    faces.setflags(write=False)
    return faces
