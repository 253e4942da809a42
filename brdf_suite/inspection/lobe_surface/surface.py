"""The reflected distribution as a radial surface: for one incidence, a point at a distance for every direction.

A surface is made in steps that are kept apart, because a drag repeats only some of them: directions
(:mod:`brdf_suite.inspection.lobe_surface.grid`), values (:mod:`brdf_suite.inspection.lobe_surface.values`), then
here the radius, points, normals and colours.
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache
from typing import Literal

import numpy as np

from brdf_suite.arrays import Bytes, Singles, Words
from brdf_suite.inspection.lobe_surface.colour import (
    CHANNEL_CODES,
    Channel,
    difference_codes,
    light_codes,
    mapped_codes,
    one_colour,
    scalar_of,
)
from brdf_suite.inspection.lobe_surface.grid import LobeGrid
from brdf_suite.inspection.lobe_surface.scale import RadiusScale
from brdf_suite.inspection.lobe_surface.shape import surface_normals, surface_points

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
    points, normals = surface_points(grid, radius), surface_normals(grid, radius)
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
