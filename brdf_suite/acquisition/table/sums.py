"""Bins of a table in three layouts, and weighted sums of the readings in each, over all positions.

After Günther et al. 2005, section 4.1. Each position of the turntable gives its own :class:`PositionSums`, small,
because its readings lie in a band of θd. :class:`TableSums` adds them up in the order of the positions: a table that
was interrupted and taken up again is the same to the last bit.

A reading weighs cosθi·cosθo / ((σ/f)² + 0.02²): the noise of the photograph, and 2 % of geometry that no bright
pixel escapes; towards grazing, where a pixel covers more of the surface and an error of the normal counts more, it
weighs less. The weight hangs on the relative noise, which is alike for readings of one bin, and so draws no mean to
the low side as the weight 1/σ² of a noisy reading itself would.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal, get_args

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Singles
from brdf_suite.reflectance.tabulated.half_angle_grid import HalfAngleGrid

Layout = Literal["half-angle", "linear", "traditional"]
LAYOUTS: tuple[Layout, ...] = get_args(Layout)

_HALF_PI = 0.5 * np.pi
FIELDS = ("n", "w", "w²", "w·r", "w·g", "w·b", "w·y²", "w²·σ²", "w·x₀", "w·x₁", "w·x₂")
"""Sums of a bin: readings, weights, their squares; f_r by channel; y² and the noise's part, with y the mean over the
channels; and the readings' places less the bin's centre along the three axes, in bins."""
GEOMETRIC_ERROR = 0.02


@dataclass(frozen=True)
class Parameterization:
    """Bins of one layout of Figure 4: along (θh, θd, φd), or (θi, θo, Δφ) where it is ``traditional``.

    ``half-angle`` is the layout that is kept: θh non-linear, so that highlights get fine bins. The others stand beside
    it for comparison: ``linear``, the same with bins of one width along θh, and ``traditional``, the polar angles of
    light and view and the azimuth between them.

    >>> Parameterization("traditional").shape
    (90, 90, 180)
    """

    layout: Layout = "half-angle"
    shape: tuple[int, int, int] = (90, 90, 180)

    @property
    def bins(self) -> int:
        """Return the number of bins in all."""
        return int(np.prod(self.shape))

    @property
    def goes_round(self) -> bool:
        """Return whether the last axis goes round: a pair and its swap are one, so φd = π is φd = 0.

        Otherwise it ends at both sides as a mirror does: Δφ and -Δφ are one in an isotropic reflectance.
        """
        return self.layout != "traditional"

    @property
    def grid(self) -> HalfAngleGrid:
        """Return the bins of the two half-angle layouts; their θh is right for ``half-angle`` alone."""
        return HalfAngleGrid(*self.shape)

    def index_of(self, wi: Floats, wo: Floats) -> Floats:
        """Return places (3, n) in index space of directions (n, 3) above the horizon; bin k spans k to k + 1."""
        i, o = np.ascontiguousarray(wi.T), np.ascontiguousarray(wo.T)
        if self.layout == "traditional":
            turn = np.abs(np.arctan2(i[0] * o[1] - i[1] * o[0], i[0] * o[0] + i[1] * o[1]))
            polar_i = np.arctan2(np.hypot(i[0], i[1]), i[2])
            polar_o = np.arctan2(np.hypot(o[0], o[1]), o[2])
            scale = np.array(self.shape)[:, None] / np.array([_HALF_PI, _HALF_PI, np.pi])[:, None]
            places: Floats = np.stack((polar_i, polar_o, turn)) * scale
        else:
            h, d, p = self.grid.index_of(i, o)
            if self.layout == "linear":
                # The non-linear place is n·√(θh / (π/2)).
                h = h * h / self.shape[0]
            places = np.stack((h, d, p))
        # θ = π/2 and Δφ = π belong to the last bin.
        ends = np.nextafter(np.array(self.shape, float), 0.0)[:, None]
        return np.asarray(np.minimum(places, ends), np.float64)


@dataclass(frozen=True)
class PositionSums:
    """Sums of the readings of one position: ``places`` (m,) int32, flat bins rising; ``sums`` (m, 11) float32."""

    places: npt.NDArray[np.int32]
    sums: Singles


def reading_weights(wi: Singles, wo: Singles, value: Singles, variance: Singles | None) -> Floats:
    """Return the weights (n,) of readings ``value`` (n, 3) with the ``variance`` of their noise (n, 3)."""
    cosines = np.maximum(wi[:, 2], 0.0).astype(np.float64) * np.maximum(wo[:, 2], 0.0)
    if variance is None:
        return np.asarray(cosines / GEOMETRIC_ERROR**2)
    noise = variance.sum(axis=1, dtype=np.float64)
    total = np.maximum(value.sum(axis=1, dtype=np.float64), np.finfo(np.float32).tiny)
    with np.errstate(over="ignore"):  # next to nothing was seen there, and 0 is its weight
        share: Floats = noise / (total * total) + GEOMETRIC_ERROR**2
    return cosines / share


def position_sums(
    parameterization: Parameterization,
    places: Floats,
    value: Singles,
    weights: Floats,
    variance: Singles | None = None,
) -> PositionSums:
    """Return the sums of readings ``value`` (n, 3) at ``places`` (3, n) in index space.

    Readings that are not finite, or weigh nothing, are left out.
    """
    kept = np.flatnonzero((weights > 0.0) & np.isfinite(weights) & np.isfinite(value).all(axis=1))
    places, value, weights = places[:, kept], value[kept], weights[kept]
    whole = np.floor(places)
    last = np.array(parameterization.shape)[:, None] - 1
    flat = np.ravel_multi_index(tuple(np.minimum(whole.astype(np.intp), last)), parameterization.shape)
    bins, which = np.unique(flat, return_inverse=True)
    mean = value.mean(axis=1, dtype=np.float64)
    noise = np.zeros(len(kept)) if variance is None else variance[kept].sum(axis=1, dtype=np.float64) / 9.0
    columns: list[Floats | None] = [None, weights, weights * weights, *(weights[:, None] * value).T]
    columns += [weights * mean * mean, weights * weights * noise, *(weights * (places - whole - 0.5))]
    sums = np.empty((len(bins), len(FIELDS)), np.float32)
    for number, column in enumerate(columns):
        sums[:, number] = np.bincount(which, column, len(bins))
    return PositionSums(bins.astype(np.int32), sums)


@dataclass
class TableSums:
    """The sums of all positions so far, ``sums`` (bins, 11) float64: 128 MB for 90 × 90 × 180 bins."""

    parameterization: Parameterization = field(default_factory=Parameterization)
    sums: Floats = field(init=False)

    def __post_init__(self) -> None:
        self.sums = np.zeros((self.parameterization.bins, len(FIELDS)))

    def add(self, position: PositionSums) -> None:
        """Add one position's sums; the order of the positions decides the last bits."""
        self.sums[position.places] += position.sums
