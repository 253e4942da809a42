"""An isotropic reflectance tabulated in half-angle coordinates: MERL's layout, and our own measurements'."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field, replace
from functools import cached_property, partial
from types import MappingProxyType
from typing import Any, ClassVar, Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Bools, Floats, Singles
from brdf_suite.documents.parameter import Parameter
from brdf_suite.errors import ValueRangeError
from brdf_suite.reflectance.blocks import in_blocks, look_up_above
from brdf_suite.reflectance.half_vector_density import HalfVectorDensity, HalfVectorSampled
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid, fill_holes, trilinear

PIXEL_FACT = "pixel_deg"
"""The fact by which a table made of photographs states the angle that a pixel covers of the sphere, degrees."""


@dataclass(frozen=True, eq=False)
class Coverage:
    """Number of readings and uncertainty of each bin; without readings, the table's value was filled in.

    Attributes
    ----------
    samples
        (θh, θd, φd) float32, the number of readings in a bin, 0 or more.
    deviation
        (θh, θd, φd) float32, standard error of the bin's value over the value; 0 where there are no readings.

    Raises
    ------
    ValueRangeError
        The shapes differ, or a number is negative or not finite.
    """

    samples: Singles
    deviation: Singles

    def __post_init__(self) -> None:
        for name in ("samples", "deviation"):
            array = np.ascontiguousarray(getattr(self, name), np.float32).view()
            if array.ndim != 3 or array.shape != self.samples.shape:
                raise ValueRangeError(
                    name, f"has the shape {array.shape}; expected (θh, θd, φd), alike for both"
                )
            # A NaN is neither.
            if not (array.min() >= 0.0 and array.max() < np.inf):
                raise ValueRangeError(name, "holds a number that is negative or not finite")
            array.flags.writeable = False
            object.__setattr__(self, name, array)

    @property
    def shape(self) -> tuple[int, ...]:
        """Return the numbers of bins along (θh, θd, φd)."""
        return self.samples.shape

    def folded(self) -> Coverage:
        """Return the coverage of a table whose pairs and their swaps were made one: φd halved.

        The readings add; the uncertainty is that of the mean of the two, or of the one that was measured.
        """
        half = self.shape[2] // 2
        one, other = self.samples[:, :, :half], self.samples[:, :, half:]
        squares = self.deviation[:, :, :half] ** 2 + self.deviation[:, :, half:] ** 2
        both = (one > 0.0) & (other > 0.0)
        return Coverage(one + other, np.sqrt(np.where(both, 0.25, 1.0) * squares))


@dataclass(frozen=True, eq=False)
class IsotropicTable(HalfVectorSampled):
    """Values in bins of (θh, θd, φd), looked up trilinearly between the centres of the bins.

    Attributes
    ----------
    values
        (θh, θd, φd, 3) float32, f_r in 1/sr, working space, without the cosine, finite, not negative. The
        bins are those of :class:`HalfAngleGrid`; at full size, 90 × 90 × 180, this is 17.5 MB.
    holes
        (θh, θd, φd) bool: bins that were not measured; what ``values`` holds there was filled in.
    reciprocal
        Whether φd covers [0, π), a pair and its swap being one, or [0, 2π).
    source
        Where the data come from, for the user.
    facts
        What the reader learned from the file, for the user.
    coverage
        How many readings each bin is made of, and how sure it is, where that is known.

    Raises
    ------
    ValueRangeError
        A shape does not fit, or a value is not finite or negative.
    """

    values: Singles
    holes: Bools | None = None
    reciprocal: bool = True
    source: str = ""
    facts: Mapping[str, Any] = field(default_factory=lambda: MappingProxyType({}))
    coverage: Coverage | None = None

    parameters: ClassVar[Mapping[str, Parameter]] = MappingProxyType({})

    def __post_init__(self) -> None:
        # Views, so that the caller's own arrays stay writable and nothing of 17 MB is copied without need.
        values = np.ascontiguousarray(self.values, np.float32).view()
        if values.ndim != 4 or values.shape[3] != 3:
            raise ValueRangeError("values", f"has the shape {values.shape}; expected (θh, θd, φd, 3)")
        infer_grid(values, self.reciprocal)
        # A NaN is neither.
        if not (values.min() >= 0.0 and values.max() < np.inf):
            at = np.argwhere(~((values >= 0.0) & (values < np.inf)))[0].tolist()
            raise ValueRangeError(f"values{at}", "is not finite or is negative; a reflectance is neither")
        holes = self.holes
        holes = np.zeros(values.shape[:3], np.bool_) if holes is None else np.asarray(holes, np.bool_).view()
        if holes.shape != values.shape[:3]:
            raise ValueRangeError("holes", f"has the shape {holes.shape}; expected {values.shape[:3]}")
        if self.coverage is not None and self.coverage.shape != values.shape[:3]:
            raise ValueRangeError(
                "coverage", f"has the shape {self.coverage.shape}; expected {values.shape[:3]}"
            )
        values.flags.writeable = False
        holes.flags.writeable = False
        object.__setattr__(self, "values", values)
        object.__setattr__(self, "holes", holes)

    @classmethod
    def from_reflectance(
        cls,
        reflectance: Reflectance,
        grid: HalfAngleGrid | None = None,
        *,
        reciprocity: Literal["assume", "average"] = "average",
        source: str = "",
        facts: Mapping[str, Any] | None = None,
    ) -> IsotropicTable:
        """Tabulate ``reflectance`` at the centres of the bins.

        Bins whose centre lies below the horizon are holes. In a reciprocal ``grid`` (the default, 90 × 90 ×
        180) a bin represents a pair and its swap: ``"average"`` takes the mean of both, ``"assume"`` the one
        with φd in [0, π). The azimuth of the half vector is 0: what is tabulated of an anisotropic
        reflectance is that cut.
        """
        grid = grid or HalfAngleGrid()
        values = np.empty((*grid.shape, 3), np.float32)
        for h in range(grid.theta_h):
            wi, wo = grid.pairs(h)
            value = np.asarray(reflectance.eval(wi, wo))
            if grid.reciprocal and reciprocity == "average":
                value = 0.5 * (value + reflectance.eval(wo, wi))
            values[h] = value
        holes = ~grid.above_horizon()
        fill_holes(values, holes, grid)
        return cls(values, holes, grid.reciprocal, source, facts or {})

    @cached_property
    def grid(self) -> HalfAngleGrid:
        """Return the bins."""
        return infer_grid(self.values, self.reciprocal)

    def eval(self, wi: npt.ArrayLike, wo: npt.ArrayLike) -> Floats:
        """Return f_r (..., 3) in 1/sr, working space, without the cosine; 0 below the horizon."""

        return in_blocks(partial(look_up_above, partial(trilinear, self.values, self.grid)), wi, wo)

    @cached_property
    def _sampler(self) -> HalfVectorDensity:
        return HalfVectorDensity(self, isotropic=True)

    def holes_above_horizon(self) -> int:
        """Return how many bins with their centre above the horizon were not measured."""
        return int(np.count_nonzero(self.measured_mask(False)))

    def measured_mask(self, measured: bool = True) -> Bools:
        """Return (θh, θd, φd): bins above the horizon that were measured (or were not)."""
        holes = np.asarray(self.holes)
        mask: Bools = self.grid.above_horizon() & (~holes if measured else holes)
        return mask

    def made_reciprocal(self) -> IsotropicTable:
        """Return the table with φd over [0, π): each bin the mean of a pair and its swap.

        Where only one of the two was measured, that one is taken; where neither was, the bin stays a hole and is filled
        again. A reciprocal table is returned as it is.

        Raises
        ------
        ValueRangeError
            φd has an odd number of bins, so that no bin is another's swap.
        """
        if self.reciprocal:
            return self
        half, odd = divmod(self.values.shape[2], 2)
        if odd or half < 2:
            raise ValueRangeError("values", f"φd has {self.values.shape[2]} bins; expected an even number")
        known = ~np.asarray(self.holes)
        first, second = known[:, :, :half, None], known[:, :, half:, None]
        one, other = self.values[:, :, :half], self.values[:, :, half:]
        values = np.where(first & second, 0.5 * (one + other), np.where(first, one, other))
        holes = ~(first | second)[..., 0]
        fill_holes(values, holes, infer_grid(values, True))
        coverage = None if self.coverage is None else self.coverage.folded()
        return replace(self, values=values, holes=holes, reciprocal=True, coverage=coverage)


def infer_grid(values: npt.NDArray[Any], reciprocal: bool) -> HalfAngleGrid:
    """Return the bins of an array (θh, θd, φd, ...)."""
    theta_h, theta_d, phi_d = values.shape[:3]
    return HalfAngleGrid(theta_h, theta_d, phi_d, reciprocal)
