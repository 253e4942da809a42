"""What a reflectance sends into the directions of a lobe grid; a fit whole and in its parts, lobe by lobe.

    f_r = KD + Σ KDD_i (R·V)^E_i + Σ KG_i (R·V)^E_i / (N·L)

All lobes share R·V, so each costs one exponential a point: (R·V)^E = exp(E ln(R·V)). For other reflectances two ways
save time without changing a value: what is the same on both sides of the plane of incidence is worked out on one side
only, and a half-angle table is looked up without the detour of its ``eval``.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass, field
from functools import cached_property
from typing import Literal

import numpy as np
import numpy.typing as npt

from brdf_suite.arrays import Floats, Singles, triple
from brdf_suite.fitting.lobes.weights import LobeWeights
from brdf_suite.geometry.directions import spherical
from brdf_suite.inspection.lobe_surface.grid import LobeGrid
from brdf_suite.reflectance.protocol import Reflectance
from brdf_suite.reflectance.tabulated.half_angle_grid import trilinear
from brdf_suite.reflectance.tabulated.isotropic import IsotropicTable

Measured = Callable[[npt.ArrayLike, npt.ArrayLike], npt.NDArray[np.bool_]]

_BLOCK = 8192
"""Pairs at a time: what is in between stays in the cache, and in memory that the allocator keeps."""
_PROBES = 48
_ALIKE = 1e-9


@dataclass(frozen=True, eq=False)
class LobeSource:
    """A reflectance that surfaces are made of; kept between incidences, since it remembers what it found out.

    Attributes
    ----------
    reflectance
        ``eval(wi, wo)`` in 1/sr.
    measured
        ``(wi, wo) -> (...)`` bool: False in the holes of a table; None where there are none.
    """

    reflectance: Reflectance
    measured: Measured | None = None

    @cached_property
    def symmetric(self) -> bool:
        """Whether values are alike on both sides of the plane of incidence, at every azimuth that was probed."""
        if isinstance(self.reflectance, IsotropicTable):
            return False
        draws = np.random.default_rng(7)
        theta = draws.uniform(0.05, 1.5, (2, _PROBES))
        phi, apart = draws.uniform(0.0, 2.0 * np.pi, (2, _PROBES))
        # Half of the views are drawn about the mirror direction, where sharp lobes are.
        near = np.arange(_PROBES) % 2 == 0
        theta[1][near] = theta[0][near] + 0.02 * (apart[near] - np.pi)
        apart[near] = np.pi + 0.05 * draws.standard_normal(int(near.sum()))
        wi = spherical(theta[0], phi)
        one, other = (self.reflectance.eval(wi, spherical(theta[1], phi + side * apart)) for side in (1, -1))
        with np.errstate(invalid="ignore"):  # infinite values cannot be compared; both sides are evaluated
            return bool(np.all(np.abs(one - other) <= _ALIKE * np.maximum(np.abs(one), 1e-12)))

    def brdf(self, grid: LobeGrid) -> Singles:
        """Return f_r (rows, columns, 3) in 1/sr at the grid's directions, without a cosine.

        NaN where nothing was measured and where the value is none: not a number, infinite or negative.
        """
        rows, columns = grid.shape
        half = columns // 2 + 1
        seen = half if self.symmetric else columns - 1
        views = grid.directions[:, :seen]
        values = np.empty((rows, columns, 3), np.float32)
        with np.errstate(all="ignore"):  # invalid values become holes, which are reported
            # The first row is one direction. Without it, half a grid is one block of an evaluation: the threads that
            # two blocks take cost more than they save.
            values[0, :seen] = self._values(grid.wi, views[:1, :1])
            values[1:, :seen] = self._values(grid.wi, views[1:])
        if self.measured is not None:
            values[:, :seen][~self.measured(grid.wi, views)] = np.nan
        if seen == half:
            values[:, half:] = values[:, half - 2 :: -1]
        else:
            values[:, -1] = values[:, 0]
        # Two passes without anything in between; a NaN fails both comparisons.
        if not (float(values.min()) >= 0.0 and float(values.max()) < np.inf):
            wrong = ~((values >= 0.0) & (values < np.inf)).all(axis=-1)
            values[wrong] = np.nan
        return values

    def _values(self, wi: Floats, views: Floats) -> npt.NDArray[np.floating]:
        if not isinstance(self.reflectance, IsotropicTable):
            return self.reflectance.eval(wi, views)
        table = self.reflectance
        flat = views.reshape(-1, 3)
        found = np.empty((len(flat), 3), np.float32)
        # The directions of a grid are finite and above the horizon, which eval would have to find out.
        for start in range(0, len(flat), _BLOCK):
            view = np.ascontiguousarray(flat[start : start + _BLOCK].T)
            light = np.repeat(wi[:, None], view.shape[1], axis=1)
            found[start : start + _BLOCK] = trilinear(table.values, table.grid, light, view)
        return found.reshape(views.shape)


FitPart = Literal["diffuse", "directional", "gloss"]
FIT_PARTS: tuple[FitPart, ...] = ("diffuse", "directional", "gloss")
PART_CODES: dict[FitPart, tuple[int, int, int]] = {
    "diffuse": (0, 158, 115),
    "directional": (86, 180, 233),
    "gloss": (230, 159, 0),
}
"""The parts' colours, sRGB codes: three of Okabe and Ito's."""

_LEAST = 1e-300


@dataclass(frozen=True)
class FitLobe:
    """One lobe of a fit: its part, its place among the exponents (0 for diffuse), exponent and weight.

    ``exponent`` is None for the diffuse part, which has none. ``weight`` is linear Rec. 2020; in 1/sr, of the gloss
    without the cosine's share (see :class:`LobeWeights`).
    """

    part: FitPart
    index: int
    exponent: float | None
    weight: tuple[float, float, float]

    @property
    def key(self) -> tuple[FitPart, int]:
        """Part and index."""
        return self.part, self.index


def fit_lobes(weights: LobeWeights) -> tuple[FitLobe, ...]:
    """Return the lobes of a fit that have any weight, diffuse first, then by part and rising exponent."""
    rows: list[FitLobe] = [FitLobe("diffuse", 0, None, triple(weights.kd))]
    order = np.argsort(weights.exponents, kind="stable").tolist()
    tables: tuple[tuple[FitPart, npt.NDArray[np.float64]], ...] = (
        ("directional", weights.kdd),
        ("gloss", weights.kg),
    )
    for part, table in tables:
        rows += [FitLobe(part, i, float(weights.exponents[i]), triple(table[i])) for i in order]
    return tuple(row for row in rows if any(row.weight))


@dataclass(frozen=True, eq=False)
class FitOnGrid:
    """The values of a fit at a grid's directions; powers are kept, so that lobes can be switched for nothing."""

    weights: LobeWeights
    grid: LobeGrid
    _powers: dict[float, Singles] = field(default_factory=dict, init=False, repr=False)

    @cached_property
    def _logarithm(self) -> npt.NDArray[np.float64]:
        cosine = self.grid.directions @ self.grid.mirror
        return np.asarray(np.log(np.clip(cosine, _LEAST, 1.0)))

    def _power(self, exponent: float) -> Singles:
        if exponent not in self._powers:
            self._powers[exponent] = np.exp(exponent * self._logarithm).astype(np.float32)
        return self._powers[exponent]

    def brdf(self, lobes: Iterable[FitLobe] | None = None) -> Singles:
        """Return f_r (rows, columns, 3), 1/sr, of some lobes, or of all; the light's cosine is not in it."""
        lobes = fit_lobes(self.weights) if lobes is None else lobes
        total = np.zeros((*self.grid.shape, 3), np.float32)
        cosine = float(self.grid.wi[2])
        # What shares an exponent shares its power.
        by_exponent: dict[float | None, npt.NDArray[np.float64]] = {}
        for lobe in lobes:
            weight = np.array(lobe.weight) / (cosine if lobe.part == "gloss" else 1.0)
            by_exponent[lobe.exponent] = by_exponent.get(lobe.exponent, np.zeros(3)) + weight
        for exponent, weight in by_exponent.items():
            single = weight.astype(np.float32)
            total += single if exponent is None else self._power(exponent)[..., None] * single
        return total
