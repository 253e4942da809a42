"""A reflectance as a product of textures: f_r = α p(wo) q(h) p(wi) (McCool, Ang and Ahmad 2001, equations 9 and 20).

p and q are maps over the hemisphere, looked up bilinearly: p of the light and, the same one, of the view; q of the half
vector h = (wi + wo)/|wi + wo|. The product is reciprocal whatever the maps hold, and needs four numbers a channel to be
evaluated: real-time hardware does it per pixel. α takes what is left when the maps are normalised.

The maps are parabolic (``geometry.parabolic``), as the paper recommends. Texels outside of the disc are met by the
interpolation near the horizon only.

Sampling takes the maps for densities, as section 5 of the paper proposes: p(wi) cosθ, or q(h) and a mirror there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from functools import cached_property
from types import MappingProxyType
from typing import Any, ClassVar

import numpy as np
import numpy.typing as npt

from brdf_suite.appearance.colorimetry import LUMINANCE
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry import warps
from brdf_suite.geometry.directions import Floats
from brdf_suite.geometry.parabolic import parabolic_direction, parabolic_place, texel_directions
from brdf_suite.reflectance.blocks import in_blocks
from brdf_suite.reflectance.models import mixture
from brdf_suite.reflectance.models.channels import rgb

PARAMETERS: Mapping[str, Parameter] = MappingProxyType(
    {"alpha": Parameter("Scale", "1/sr", 0.0, 1e6, 1.0, "What the product of the maps is multiplied by")}
)
SMALLEST_MAP, LARGEST_MAP = 2, 2048
_LEAST_MATT = 0.1
_LEAST_DENSITY = 1e-3
"""Of a texel, over the mean of its map: what is black there may be bright beside it, by the interpolation."""


@dataclass(frozen=True, eq=False)
class Factored:
    """f_r = ``alpha`` p(wo) q(h) p(wi), in 1/sr.

    Attributes
    ----------
    p, q
        (n, n, 3) maps of the light's and the view's direction and of the half vector, each of a size of its own, linear
        working space, finite, not negative, kept as float32; their first row is that of the least t.
    alpha
        (3,), or one number for all channels, 0 to 10⁶.
    source
        Where the data come from, for the user.
    facts
        What the reader learned from the file, for the user.

    Raises
    ------
    ValueRangeError
        A map is not square, or holds a number that cannot be; the message names it.
    """

    p: npt.NDArray[np.float32]
    q: npt.NDArray[np.float32]
    alpha: npt.ArrayLike = (1.0, 1.0, 1.0)
    source: str = ""
    facts: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    parameters: ClassVar[Mapping[str, Parameter]] = PARAMETERS
    reciprocal: ClassVar[bool] = True
    # Nothing in the form keeps a product of maps from sending back more than it gets.
    energy_conserving: ClassVar[bool] = False

    def __post_init__(self) -> None:
        object.__setattr__(self, "p", _checked_map(self.p, "p"))
        object.__setattr__(self, "q", _checked_map(self.q, "q"))
        object.__setattr__(self, "alpha", rgb(self.alpha, "alpha", PARAMETERS["alpha"]))

    @classmethod
    def from_functions(
        cls, p: Callable[[Floats], Floats], q: Callable[[Floats], Floats], size: int = 64
    ) -> Factored:
        """Return the product of two functions of directions (..., 3), each giving (..., 3), at the texels' centres.

        Texels outside of the hemisphere take the value of the horizon nearest to them.
        """
        where = texel_directions(size)
        return cls(np.asarray(p(where), np.float32), np.asarray(q(where), np.float32))

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, without the cosine; 0 below the horizon."""
        return in_blocks(self._eval_block, wi, wo)

    def _eval_block(self, wi: Floats, wo: Floats) -> Floats:
        product = look_up(self.p, wi) * look_up(self.p, wo) * look_up(self.q, warps.half_vector(wi, wo))
        above = (wi[..., 2] > 0.0) & (wo[..., 2] > 0.0)
        return np.where(above[..., None], product * np.asarray(self.alpha), 0.0)

    @cached_property
    def shares(self) -> tuple[float, float, float]:
        """How often matt directions, those of p and those of q are drawn: by how uneven each map is."""
        uneven = [_unevenness(values) for values in (self.p, self.q)]
        rest = (1.0 - _LEAST_MATT) / max(sum(uneven), 1e-12)
        if sum(uneven) < 1e-6:
            return 1.0, 0.0, 0.0
        return _LEAST_MATT, rest * uneven[0], rest * uneven[1]

    @cached_property
    def densities(self) -> tuple[Floats, Floats]:
        """The chance of each texel (n, n) of p, with the cosine, and of q: sampling draws evenly within one."""
        return map_density(self.p), map_density(self.q)

    def sample(self, wo: npt.ArrayLike, u: npt.ArrayLike) -> Floats:
        """Return directions (..., 3) for ``u`` (..., 3): matt, of the light's map, or mirrors of the half vector's."""
        return mixture.sample(self._parts, wo, u)

    def pdf(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return the density (...) of :meth:`sample` per solid angle."""
        return mixture.pdf(self._parts, wi, wo)

    @cached_property
    def _parts(self) -> list[mixture.Part]:
        matt, of_p, of_q = self.shares
        p, q = self.densities

        def mirrored(wi: Floats, wo: Floats) -> Floats:
            h = warps.half_vector(wi, wo)
            return warps.mirrored_pdf(direction_density(q, h), wo, h)

        return [
            mixture.diffuse(matt),
            mixture.Part(of_p, lambda _wo, u: drawn(p, u), lambda wi, _wo: direction_density(p, wi)),
            mixture.Part(of_q, lambda wo, u: _mirrored_above(wo, drawn(q, u)), mirrored),
        ]


def look_up(values: npt.NDArray[np.float32], w: npt.ArrayLike) -> Floats:
    """Return a map (n, n, 3) at directions (..., 3), bilinear between texels; the outermost hold at the edge."""
    size = len(values)
    s, t = parabolic_place(w)
    x, y = (np.clip(0.5 * (place + 1.0) * size - 0.5, 0.0, size - 1.0) for place in (s, t))
    i, j = (np.minimum(place.astype(np.int64), size - 2) for place in (x, y))
    u, v = (x - i)[..., None], (y - j)[..., None]
    low = values[j, i] * (1.0 - u) + values[j, i + 1] * u
    high = values[j + 1, i] * (1.0 - u) + values[j + 1, i + 1] * u
    return np.asarray(low * (1.0 - v) + high * v, float)


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


def drawn(density: Floats, u: Floats) -> Floats:
    """Return directions (n, 3) for even numbers ``u`` (n, 2), of a texel by its chance and even within it."""
    size = len(density)
    bounds = np.cumsum(density.ravel())
    bounds /= bounds[-1]
    index = np.minimum(np.searchsorted(bounds, u[:, 0], side="right"), bounds.size - 1)
    start = np.where(index > 0, bounds[index - 1], 0.0)
    within = (u[:, 0] - start) / np.maximum(bounds[index] - start, 1e-300)
    row, column = np.divmod(index, size)
    return parabolic_direction(2.0 * (column + within) / size - 1.0, 2.0 * (row + u[:, 1]) / size - 1.0)


def direction_density(density: Floats, w: Floats) -> Floats:
    """Return the density (...) of :func:`drawn` per solid angle at directions (..., 3)."""
    size = len(density)
    s, t = parabolic_place(w)
    column, row = (np.clip((0.5 * (place + 1.0) * size).astype(np.int64), 0, size - 1) for place in (s, t))
    inside = (np.abs(s) <= 1.0) & (np.abs(t) <= 1.0)
    per_area = density[row, column] * (0.25 * size * size)
    return np.where(inside, per_area * (1.0 + s * s + t * t) ** 2 / 4.0, 0.0)


def _mirrored_above(wo: Floats, h: Floats) -> Floats:
    """Mirror views at half vectors; those below the horizon, which no pair has, are lost."""
    return np.where(h[:, 2:] > 0.0, warps.mirrored_at(wo, h), np.array([0.0, 0.0, -1.0]))


def _unevenness(values: npt.NDArray[np.float32]) -> float:
    """The variance of a map over its squared mean, with a limit: a peak is worth many samples, but not all."""
    grey = values.astype(float) @ LUMINANCE
    mean = float(grey.mean())
    return 0.0 if mean <= 0.0 else min(float(grey.var()) / mean**2, 10.0)


def _checked_map(values: npt.ArrayLike, place: str) -> npt.NDArray[np.float32]:
    array = np.asarray(values)
    square = array.ndim == 3 and array.shape[0] == array.shape[1] and array.shape[2] == 3
    if not square or not SMALLEST_MAP <= len(array) <= LARGEST_MAP or array.dtype.kind not in "fiu":
        reason = (
            f"an image (n, n, 3) of numbers, n {SMALLEST_MAP} to {LARGEST_MAP}, is wanted, not {array.shape}"
        )
        raise ValueRangeError(place, reason)
    found = np.ascontiguousarray(array, np.float32)
    if not np.isfinite(found).all() or (found < 0.0).any():
        raise ValueRangeError(place, "holds a number that is negative or not finite")
    found.flags.writeable = False
    return found
