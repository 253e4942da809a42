"""One map of a product: its values, the projection of a direction pair, interpolation, and a density to sample it.

The densities are texels, or rings of a radial map (McCool, Ang and Ahmad 2001, section 5). One over the half vector
gives lights by mirroring the view there; its measure is that of Torrance and Sparrow, dωi = 4 (ω·h) dωh
(``geometry.warps.mirrored_pdf``).
"""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colour.colorimetry import LUMINANCE
from brdf_suite.arrays import Floats, Singles
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_words import PROJECTIONS
from brdf_suite.geometry.parabolic import look_up_map, parabolic_direction, parabolic_place

SMALLEST_MAP, LARGEST_MAP = 2, 2048


@dataclass(frozen=True, eq=False)
class MapFactor:
    """A factor of a product: a map read through a projection.

    Attributes
    ----------
    projection
        A name of :data:`~brdf_suite.geometry.factor_words.PROJECTIONS`.
    values
        (n, 3) of a projection of one axis, (n, n, 3) of one of two: the factor itself, linear working space, finite,
        not negative, kept as float32.
    logarithmic
        Whether the logarithms of the values, which then are over 0, are what is interpolated between texels: so a
        factorization found them (McCool, Ang and Ahmad 2001, section 4.1). Otherwise the values themselves.
    name
        What the map is called, for the user.

    Raises
    ------
    ValueRangeError
        The projection is not known, or the values are not as above.
    """

    projection: str
    values: Singles
    logarithmic: bool = False
    name: str = ""

    def __post_init__(self) -> None:
        if self.projection not in PROJECTIONS:
            raise ValueRangeError("projection", f"expected one of {', '.join(PROJECTIONS)}")
        axes = PROJECTIONS[self.projection].axes
        object.__setattr__(self, "values", check_map(self.values, self.projection, (axes,)))
        if self.logarithmic and not (self.values > 0.0).all():
            raise ValueRangeError(self.projection, "a map between whose logarithms is interpolated holds a 0")

    @property
    def radial(self) -> bool:
        """Whether the map has one axis."""
        return self.values.ndim == 2

    @cached_property
    def _held(self) -> Floats:
        values = self.values.astype(np.float64)
        return np.log(values) if self.logarithmic else values

    def at(self, wi: Floats, wo: Floats) -> Floats:
        """Return the factor (k, 3) for directions (k, 3) above the horizon."""
        found = look_up_map(self._held, PROJECTIONS[self.projection].places(wi, wo))
        return np.exp(found) if self.logarithmic else found


def check_map(values: npt.ArrayLike, place: str, axes: tuple[int, ...] = (1, 2)) -> Singles:
    """Return a map (n, 3) or (n, n, 3), of as many ``axes`` as are allowed, that cannot be written.

    Raises
    ------
    ValueRangeError
        It is not of that form, or holds a number that cannot be; the error's place is ``place``.
    """
    array = np.asarray(values)
    formed = (
        array.ndim - 1 in axes
        and array.shape[-1] == 3
        and len(set(array.shape[:-1])) == 1
        and SMALLEST_MAP <= len(array) <= LARGEST_MAP
    )
    if not formed or array.dtype.kind not in "fiu":
        wanted = " or ".join(("(n, 3)", "(n, n, 3)")[count - 1] for count in axes)
        reason = f"expected a map {wanted} of numbers, n {SMALLEST_MAP} to {LARGEST_MAP}, not {array.shape}"
        raise ValueRangeError(place, reason)
    kept = array.dtype == np.float32 and array.flags.c_contiguous and not array.flags.writeable
    # Read-only arrays are shared: a map that two factors read stays one array.
    found = array if kept else np.array(array, np.float32, order="C")
    if not np.isfinite(found).all() or (found < 0.0).any():
        raise ValueRangeError(place, "holds a number that is negative or not finite")
    found.flags.writeable = False
    return found


RINGS = 64
"""Of a radial density: even in √r, so that those about the normal are fine."""
_LEAST_DENSITY = 1e-3
"""Of a texel, over the mean of its map: what is black there may be bright beside it, by the interpolation."""
_POINTS_A_RING = 8

LIGHT_PROJECTIONS = ("wi", "|wi|")
HALF_PROJECTIONS = ("h", "|h|", "sqrt|h|", "w.h,h.n")


def build_density(factor: MapFactor) -> Floats:
    """Return the chances of a map over a direction or the half vector: (n, n) of texels, or (RINGS,) of rings.

    A map over w·h and h·n counts by its mean over the former.
    """
    if factor.projection in ("wi", "wo", "h"):
        return map_density(factor.values)
    values = factor.values.astype(np.float64)
    bounds = ring_bounds()
    # Several points of each ring, even in r².
    inner, outer = bounds[:-1, None] ** 2, bounds[1:, None] ** 2
    share = (np.arange(_POINTS_A_RING) + 0.5) / _POINTS_A_RING
    r2 = inner + (outer - inner) * share
    radius = np.sqrt(r2)
    cosine = (1.0 - r2) / (1.0 + r2)
    if factor.projection == "w.h,h.n":
        values, along = values.mean(axis=1), cosine
    else:
        along = np.sqrt(radius) if factor.projection == "sqrt|h|" else radius
    grey = (look_up_map(values, along.reshape(-1, 1)) @ LUMINANCE).reshape(along.shape)
    lifted = grey + _LEAST_DENSITY * max(float((values @ LUMINANCE).mean()), 1e-30)
    mass = (lifted * cosine / (1.0 + r2) ** 2).mean(axis=1) * (outer - inner)[:, 0]
    return np.asarray(mass / mass.sum())


def ring_bounds() -> Floats:
    """Return the radii (RINGS + 1,) on a parabolic map between which the rings lie."""
    return (np.arange(RINGS + 1) / RINGS) ** 2


def map_density(values: npt.NDArray[np.float32]) -> Floats:
    """Return the chance (n, n) of each texel: luminance times cosθ dω, and a little everywhere; their sum is 1."""
    size = len(values)
    along = (2.0 * np.arange(size) + 1.0) / size - 1.0
    s, t = np.meshgrid(along, along)
    r2 = s * s + t * t
    # Texels that the disc's edge cuts count with their corner that is inside.
    inner = np.hypot(np.maximum(np.abs(s) - 1.0 / size, 0.0), np.maximum(np.abs(t) - 1.0 / size, 0.0))
    cosine = np.maximum((1.0 - r2) / (1.0 + r2), 0.5 / size)
    grey = values.astype(float) @ LUMINANCE
    mass = (grey + _LEAST_DENSITY * max(float(grey.mean()), 1e-30)) * cosine / (1.0 + r2) ** 2
    mass = np.where(inner < 1.0, mass, 0.0)
    return np.asarray(mass / mass.sum())


def sample_directions(density: Floats, u: Floats) -> Floats:
    """Return directions (n, 3) for even numbers ``u`` (n, 2), of a texel or ring by its chance and even within it."""
    bounds = np.cumsum(density.ravel())
    bounds /= bounds[-1]
    index = np.minimum(np.searchsorted(bounds, u[:, 0], side="right"), bounds.size - 1)
    start = np.where(index > 0, bounds[index - 1], 0.0)
    within = (u[:, 0] - start) / np.maximum(bounds[index] - start, 1e-300)
    if density.ndim == 1:
        inner, outer = (ring_bounds()[index + step] ** 2 for step in (0, 1))
        radius, turn = np.sqrt(inner + (outer - inner) * within), 2.0 * np.pi * u[:, 1]
        return parabolic_direction(radius * np.cos(turn), radius * np.sin(turn))
    size = len(density)
    row, column = np.divmod(index, size)
    return parabolic_direction(2.0 * (column + within) / size - 1.0, 2.0 * (row + u[:, 1]) / size - 1.0)


def direction_density(density: Floats, w: Floats) -> Floats:
    """Return the density (...) of :func:`sample_directions` per solid angle at directions (..., 3)."""
    size = len(density)
    s, t = parabolic_place(w)
    r2 = s * s + t * t
    if density.ndim == 1:
        ring = np.clip((np.sqrt(np.sqrt(r2)) * size).astype(np.int64), 0, size - 1)
        areas = np.pi * np.diff(ring_bounds() ** 2)
        inside, per_area = r2 <= 1.0, (density / areas)[ring]
    else:
        column, row = (
            np.clip((0.5 * (place + 1.0) * size).astype(np.int64), 0, size - 1) for place in (s, t)
        )
        inside = (np.abs(s) <= 1.0) & (np.abs(t) <= 1.0)
        per_area = density[row, column] * (0.25 * size * size)
    return np.where(inside, per_area * (1.0 + r2) ** 2 / 4.0, 0.0)


def unevenness(factor: MapFactor) -> float:
    """The variance of a map over its squared mean, with a limit: a peak is worth many samples, but not all."""
    grey = factor.values.astype(float) @ LUMINANCE
    mean = float(grey.mean())
    return 0.0 if mean <= 0.0 else min(float(grey.var()) / mean**2, 10.0)
