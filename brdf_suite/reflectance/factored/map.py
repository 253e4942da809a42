"""One map of a product: its values, the projection of a direction pair, and interpolation."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Singles
from brdf_suite.errors import ValueRangeError
from brdf_suite.geometry.factor_projections import PROJECTIONS
from brdf_suite.geometry.map_look_up import look_up_map

SMALLEST_MAP, LARGEST_MAP = 2, 2048


@dataclass(frozen=True, eq=False)
class MapFactor:
    """A factor of a product: a map read through a projection.

    Attributes
    ----------
    projection
        A name of :data:`~brdf_suite.geometry.factor_projections.PROJECTIONS`.
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
